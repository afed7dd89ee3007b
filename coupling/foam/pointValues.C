// SPDX-License-Identifier: GPL-3.0-or-later

#include "pointValues.H"
#include "emptyPolyPatch.H"
#include "indirectPrimitivePatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelListList Foam::pointValues::patchFaces() const
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
                faces[pointi].append(facei - mesh_.nInternalFaces());
            }
        }
    }
    labelListList result(faces.size());
    forAll(faces, pointi)
    {
        result[pointi].transfer(faces[pointi]);
    }
    return result;
}


void Foam::pointValues::flatten
(
    const labelListList& from,
    const scalarListList& weights,
    sources& result
)
{
    result.starts.setSize(weights.size() + 1);
    DynamicList<label> allFrom;
    DynamicList<scalar> allWeights;
    forAll(weights, pointi)
    {
        result.starts[pointi] = allFrom.size();
        if (weights[pointi].size())
        {
            allFrom.append(from[pointi]);
            allWeights.append(weights[pointi]);
        }
    }
    result.starts.last() = allFrom.size();
    result.from.transfer(allFrom);
    result.weights.transfer(allWeights);
}


void Foam::pointValues::makeWeights()
{
    const labelListList patchFaces(this->patchFaces());
    const SubList<point> faceCentres
    (
        mesh_.faceCentres(),
        mesh_.nFaces() - mesh_.nInternalFaces(),
        mesh_.nInternalFaces()
    );
    // A rank, or an image, may have a point of a patch and none of its faces
    List<label> isOnPatch(mesh_.nPoints(), 0);
    forAll(isOnPatch, pointi)
    {
        isOnPatch[pointi] = patchFaces[pointi].size() ? 1 : 0;
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
        const UList<point>& centres,
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
    scalarListList cellWeights(mesh_.nPoints());
    scalarListList faceWeights(mesh_.nPoints());
    forAll(points, pointi)
    {
        if (isOnPatch[pointi])
        {
            weigh
            (
                pointi,
                patchFaces[pointi],
                faceCentres,
                faceWeights[pointi]
            );
        }
        else
        {
            weigh
            (
                pointi,
                mesh_.pointCells()[pointi],
                mesh_.cellCentres(),
                cellWeights[pointi]
            );
        }
    }
    mesh_.globalData().syncPointData
    (
        sum, plusEqOp<scalar>(), mapDistribute::transform()
    );

    forAll(points, pointi)
    {
        for (scalarList* weights : {&cellWeights[pointi], &faceWeights[pointi]})
        {
            for (scalar& weight : *weights)
            {
                weight /= sum[pointi];
            }
        }
    }
    flatten(mesh_.pointCells(), cellWeights, cells_);
    flatten(patchFaces, faceWeights, faces_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointValues::pointValues(const fvMesh& mesh)
:
    mesh_(mesh),
    sharedPoints_(mesh.globalData().coupledPatch().meshPoints())
{
    makeWeights();
}


// ************************************************************************* //
