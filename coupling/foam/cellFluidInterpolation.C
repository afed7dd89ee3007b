// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellFluidInterpolation.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellFluidInterpolation, 0);
    addToRunTimeSelectionTable
    (
        fluidInterpolation,
        cellFluidInterpolation,
        mesh
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellFluidInterpolation::cellFluidInterpolation(const fvMesh& mesh)
:
    fluidInterpolation(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::cellFluidInterpolation::interpolate
(
    const volScalarField& field
) const
{
    return tmp<scalarField>::New(field.primitiveField(), cells_);
}


Foam::tmp<Foam::vectorField> Foam::cellFluidInterpolation::interpolate
(
    const volVectorField& field
) const
{
    return tmp<vectorField>::New(field.primitiveField(), cells_);
}


// ************************************************************************* //
