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

    const scalar Sp = dict.get<scalar>("Sp");
    if (!(Sp <= 0))
    {
        dictionaryChecks::badValue
        (
            dict,
            "Sp",
            Foam::name(Sp),
            "at most 0 1/s: a resistance, not a drive"
        );
    }

    Su_ = dimensionedVector("Su", dimAcceleration, dict.get<vector>("Su"));
    Sp_ = dimensionedScalar("Sp", dimless/dimTime, Sp);
}


// ************************************************************************* //
