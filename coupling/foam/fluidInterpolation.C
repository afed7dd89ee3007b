// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidInterpolation.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(fluidInterpolation, 0);
    defineRunTimeSelectionTable(fluidInterpolation, mesh);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidInterpolation::fluidInterpolation(const fvMesh& mesh)
:
    mesh_(mesh)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fluidInterpolation> Foam::fluidInterpolation::New
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    const word modelType
    (
        dictionaryChecks::getWord
        (
            dict,
            "interpolation",
            meshConstructorTablePtr_->sortedToc()
        )
    );

    Info<< "Selecting interpolation " << modelType << endl;

    return autoPtr<fluidInterpolation>
    (
        meshConstructorTablePtr_->cfind(modelType)()(mesh)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fluidInterpolation::set
(
    const UList<point>& positions,
    const labelUList& cells
)
{
    cells_ = cells;
    setWeights(positions);
}


// ************************************************************************* //
