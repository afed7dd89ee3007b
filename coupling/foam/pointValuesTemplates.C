// SPDX-License-Identifier: GPL-3.0-or-later

#include "globalMeshData.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::pointValues::interpolate
(
    const GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    tmp<Field<Type>> tvalues(new Field<Type>(mesh_.nPoints(), Zero));
    Field<Type>& values = tvalues.ref();

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const labelListList& pointCells = mesh_.pointCells();
    forAll(values, pointi)
    {
        const scalarList& fromCells = cellWeights_[pointi];
        forAll(fromCells, i)
        {
            values[pointi] += fromCells[i]*field[pointCells[pointi][i]];
        }
        const scalarList& fromFaces = faceWeights_[pointi];
        forAll(fromFaces, i)
        {
            const label facei = patchFaces_[pointi][i];
            const label patchi =
                patches.patchID()[facei - mesh_.nInternalFaces()];
            values[pointi] +=
                fromFaces[i]
               *field.boundaryField()[patchi]
                [
                    patches[patchi].whichFace(facei)
                ];
        }
    }

    mesh_.globalData().syncPointData
    (
        values, plusEqOp<Type>(), mapDistribute::transform()
    );
    return tvalues;
}


// ************************************************************************* //
