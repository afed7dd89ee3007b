// SPDX-License-Identifier: GPL-3.0-or-later

#include "pointValues.H"
#include "emptyPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::pointValues::findPatchFaces()
{
    List<DynamicList<label>> faces(mesh_.nPoints());
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled() || isA<emptyPolyPatch>(patch.patch()))
        {
            continue;
        }
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            for (const label pointi : mesh_.faces()[facei])
            {
                faces[pointi].append(facei);
            }
        }
    }
    patchFaces_.setSize(faces.size());
    forAll(faces, pointi)
    {
        patchFaces_[pointi].transfer(faces[pointi]);
    }
}


void Foam::pointValues::makeWeights()
{
    // A rank, or an image, may have a point of a patch and none of its faces
    List<label> isOnPatch(mesh_.nPoints(), 0);
    forAll(isOnPatch, pointi)
    {
        isOnPatch[pointi] = patchFaces_[pointi].size() ? 1 : 0;
    }
    mesh_.globalData().syncPointData
    (
        isOnPatch, maxEqOp<label>(), mapDistribute::transform()
    );

    const pointField& points = mesh_.points();
    scalarField sum(mesh_.nPoints(), Zero);
    const auto weigh = [&]
    (
        const label pointi,
        const labelList& from,
        const vectorField& centres,
        scalarList& weights
    )
    {
        weights.setSize(from.size());
        forAll(from, i)
        {
            weights[i] = 1.0/mag(points[pointi] - centres[from[i]]);
            sum[pointi] += weights[i];
        }
    };
    cellWeights_.setSize(mesh_.nPoints());
    faceWeights_.setSize(mesh_.nPoints());
    forAll(points, pointi)
    {
        if (isOnPatch[pointi])
        {
            weigh
            (
                pointi,
                patchFaces_[pointi],
                mesh_.faceCentres(),
                faceWeights_[pointi]
            );
        }
        else
        {
            weigh
            (
                pointi,
                mesh_.pointCells()[pointi],
                mesh_.cellCentres(),
                cellWeights_[pointi]
            );
        }
    }
    mesh_.globalData().syncPointData
    (
        sum, plusEqOp<scalar>(), mapDistribute::transform()
    );

    forAll(points, pointi)
    {
        for (scalarList* weights : {&cellWeights_[pointi], &faceWeights_[pointi]})
        {
            for (scalar& weight : *weights)
            {
                weight /= sum[pointi];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointValues::pointValues(const fvMesh& mesh)
:
    mesh_(mesh)
{
    findPatchFaces();
    makeWeights();
}


// ************************************************************************* //
