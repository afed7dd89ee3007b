// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribedMomentum.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(prescribedMomentum, 0);
    addToRunTimeSelectionTable
    (
        particleMomentum,
        prescribedMomentum,
        dictionary
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::prescribedMomentum::prescribedMomentum
(
    const fvMesh& mesh,
    const couplingProperties& coupling
)
:
    particleMomentum(mesh, coupling)
{
    const dictionary& dict = coupling.particleMomentumDict();
    dictionaryChecks::checkEntries(dict, {"type", "Su", "Sp"}, {});

    const string allowed("at most 0 1/s: a resistance, not a drive");
    const scalar Sp = dictionaryChecks::get<scalar>(dict, "Sp", allowed);
    if (!(Sp <= 0))
    {
        dictionaryChecks::badValue
        (
            dict,
            "Sp",
            Foam::name(Sp),
            allowed
        );
    }

    Su_ = dimensionedVector
    (
        "Su",
        dimAcceleration,
        dictionaryChecks::get<vector>(dict, "Su", "(x y z) in m/s2")
    );
    Sp_ = dimensionedScalar("Sp", dimless/dimTime, Sp);
}


// ************************************************************************* //
