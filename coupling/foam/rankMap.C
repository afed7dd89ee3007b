// SPDX-License-Identifier: GPL-3.0-or-later

#include "rankMap.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rankMap::rankMap(const cellLocator& locator, const label maxVoxels)
{
    const fvMesh& mesh = locator.mesh();
    const boundBox& box = mesh.bounds();

    // Cubes, as far as the box allows. One rank needs no map.
    const label wanted = Pstream::parRun() ? maxVoxels : 1;
    const vector span(max(box.span(), vector::uniform(VSMALL)));
    const scalar cube = std::cbrt(cmptProduct(span)/wanted);
    vector size;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        voxels[d] =
            wanted == 1
          ? 1
          : std::max(1.0, std::min(std::floor(span[d]/cube), scalar(wanted)));
        size[d] = span[d]/voxels[d];
        origin[d] = box.min()[d];
        spacing[d] = size[d];
    }

    const label nVoxels = voxels[0]*voxels[1]*voxels[2];
    labelList holder(nVoxels, labelMax);
    labelList toucher(nVoxels, labelMax);

    forAll(mesh.cells(), celli)
    {
        const boundBox cellBox
        (
            mesh.points(),
            mesh.cellPoints()[celli],
            false
        );
        labelVector first, last;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            const label end = voxels[d] - 1;
            const scalar low = (cellBox.min()[d] - origin[d])/size[d];
            const scalar high = (cellBox.max()[d] - origin[d])/size[d];
            first[d] = std::max(label(0), std::min(end, label(low)));
            last[d] = std::max(label(0), std::min(end, label(high)));
        }
        for (label k = first[2]; k <= last[2]; ++k)
        {
            for (label j = first[1]; j <= last[1]; ++j)
            {
                for (label i = first[0]; i <= last[0]; ++i)
                {
                    const label v = (k*voxels[1] + j)*voxels[0] + i;
                    const vector place(i + 0.5, j + 0.5, k + 0.5);
                    const point centre(box.min() + cmptMultiply(place, size));
                    toucher[v] = Pstream::myProcNo();
                    if (locator.depth(centre, celli) >= 0)
                    {
                        holder[v] = Pstream::myProcNo();
                    }
                }
            }
        }
    }

    Pstream::listCombineGather(holder, minEqOp<label>());
    Pstream::listCombineScatter(holder);
    Pstream::listCombineGather(toucher, minEqOp<label>());
    Pstream::listCombineScatter(toucher);

    rank.resize(nVoxels);
    for (label v = 0; v < nVoxels; ++v)
    {
        const label owner = holder[v] == labelMax ? toucher[v] : holder[v];
        rank[v] = owner == labelMax ? -1 : owner;
    }
}


// ************************************************************************* //
