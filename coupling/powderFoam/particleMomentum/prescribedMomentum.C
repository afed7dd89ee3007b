// SPDX-License-Identifier: GPL-3.0-or-later

#include "prescribedMomentum.H"
#include "couplingProperties.H"
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
    const dictionary& dict
)
:
    particleMomentum(mesh, dict)
{
    couplingProperties::checkEntries(dict, {"type", "Su", "Sp"}, {});

    const scalar Sp = dict.get<scalar>("Sp");
    if (!(Sp <= 0))
    {
        couplingProperties::badValue
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
