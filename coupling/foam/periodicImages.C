// SPDX-License-Identifier: GPL-3.0-or-later

#include "periodicImages.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::periodicImages::beyond(const point& position) const
{
    scalar sum = 0;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        sum +=
            max(scalar(0), bounds_.min()[d] - position[d])
          + max(scalar(0), position[d] - bounds_.max()[d]);
    }
    return sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::periodicImages::periodicImages(const fvMesh& mesh)
:
    bounds_(mesh.points(), true)
{
    List<List<vector>> found(Pstream::nProcs());
    DynamicList<vector> here;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            !patch.size()
         || !isA<coupledPolyPatch>(patch)
         || !refCast<const coupledPolyPatch>(patch).parallel()
        )
        {
            continue;
        }
        if (isA<cyclicPolyPatch>(patch))
        {
            const auto& cyclic = refCast<const cyclicPolyPatch>(patch);
            here.append
            (
                average(cyclic.neighbPatch().faceCentres())
              - average(patch.faceCentres())
            );
        }
        else if (isA<processorPolyPatch>(patch))
        {
            const auto& processor = refCast<const processorPolyPatch>(patch);
            here.append
            (
                average(processor.neighbFaceCentres())
              - average(patch.faceCentres())
            );
        }
    }
    found[Pstream::myProcNo()] = here;
    Pstream::gatherList(found);
    Pstream::scatterList(found);

    // The same pair, or two ranks that touch
    const scalar same = 1e-6*bounds_.mag();
    for (const List<vector>& some : found)
    {
        for (const vector& separation : some)
        {
            bool isNew = mag(separation) > same;
            for (const vector& known : separations_)
            {
                isNew = isNew && mag(separation - known) > same;
            }
            if (isNew)
            {
                separations_.append(separation);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::periodicImages::separation(const point& position) const
{
    vector sum(Zero);
    scalar distance = beyond(position);
    for (bool nearer = true; nearer && distance > 0;)
    {
        nearer = false;
        for (const vector& separation : separations_)
        {
            const scalar moved = beyond(position + sum + separation);
            if (moved < distance)
            {
                sum += separation;
                distance = moved;
                nearer = true;
                break;
            }
        }
    }
    return sum;
}


// ************************************************************************* //
