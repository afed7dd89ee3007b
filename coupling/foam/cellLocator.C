// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellLocator.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

#include <cmath>


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    // Of the diagonal of the mesh
    static const scalar onFaceFraction = 1e-12;

    // By which a point is moved before it is searched, over the distance within
    // which it is on a face: no plane that meshes have is parallel to it
    static const vector tieBreak(10, 6.18033988749895, 4.14213562373095);

    // Two ranks may see the plane of their common face that far apart, over
    // the distance within which a point is on it
    static const scalar planesApart = 1e-3;

    // Ways to move it: towards each octant
    static const label nOctants = 8;

    // Cells that a walk may cross before the octree is the better way
    static const label maxWalk = 100;

    // Answers of the walk
    static const label inNoCell = -1;
    static const label notKnown = -2;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellLocator::setSides()
{
    const labelList& owner = mesh_.faceOwner();
    DynamicList<side> sides(2*mesh_.nFaces());
    starts_.setSize(mesh_.nCells() + 1);
    forAll(mesh_.cells(), celli)
    {
        starts_[celli] = sides.size();
        for (const label facei : mesh_.cells()[celli])
        {
            const bool owns = owner[facei] == celli;
            const vector S((owns ? 1 : -1)*mesh_.faceAreas()[facei]);
            const vector normal(S/max(mag(S), VSMALL));
            const label behind =
                !mesh_.isInternalFace(facei) ? -1
              : owns ? mesh_.faceNeighbour()[facei]
              : owner[facei];
            sides.append
            (
                side
                {
                    normal,
                    normal & mesh_.faceCentres()[facei],
                    behind
                }
            );
        }
    }
    starts_.last() = sides.size();
    sides_.transfer(sides);
}


void Foam::cellLocator::setBends()
{
    scalarField bends(mesh_.nCells(), Zero);
    forAll(mesh_.faces(), facei)
    {
        const vector& S = mesh_.faceAreas()[facei];
        const vector normal(S/max(mag(S), VSMALL));
        scalar bend = 0;
        for (const label pointi : mesh_.faces()[facei])
        {
            bend = max
            (
                bend,
                mag(normal & (mesh_.points()[pointi] - mesh_.faceCentres()[facei]))
            );
        }
        if (bend > onFace_)
        {
            scalar& ofOwner = bends[mesh_.faceOwner()[facei]];
            ofOwner = max(ofOwner, bend);
            if (mesh_.isInternalFace(facei))
            {
                scalar& ofNeighbour = bends[mesh_.faceNeighbour()[facei]];
                ofNeighbour = max(ofNeighbour, bend);
            }
        }
    }
    if (bends.size() && max(bends) > 0)
    {
        bends_.transfer(bends);
    }
}


void Foam::cellLocator::setSeeds()
{
    const vector span(bounds_.span());
    const scalar cellSize =
        mesh_.nCells() ? std::cbrt(cmptProduct(span)/mesh_.nCells()) : 1;
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        nVoxels_[d] = std::max(1.0, std::floor(span[d]/cellSize));
        voxelSize_[d] = span[d]/nVoxels_[d];
    }

    seeds_.setSize(cmptProduct(nVoxels_), -1);
    DynamicList<label> front;
    forAll(mesh_.cellCentres(), celli)
    {
        const label v = voxel(mesh_.cellCentres()[celli]);
        if (seeds_[v] == -1)
        {
            seeds_[v] = celli;
            front.append(v);
        }
    }

    // Voxels without a cell centre take the seed of the nearest one with
    const labelVector stride(1, nVoxels_[0], nVoxels_[0]*nVoxels_[1]);
    for (label i = 0; i < front.size(); ++i)
    {
        const label v = front[i];
        for (direction d = 0; d < labelVector::nComponents; ++d)
        {
            const label place = (v/stride[d])%nVoxels_[d];
            if (place > 0 && seeds_[v - stride[d]] == -1)
            {
                seeds_[v - stride[d]] = seeds_[v];
                front.append(v - stride[d]);
            }
            if (place + 1 < nVoxels_[d] && seeds_[v + stride[d]] == -1)
            {
                seeds_[v + stride[d]] = seeds_[v];
                front.append(v + stride[d]);
            }
        }
    }
}


Foam::label Foam::cellLocator::voxel(const point& position) const
{
    label place[3];
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        place[d] = std::min
        (
            nVoxels_[d] - 1,
            std::max
            (
                label(0),
                label((position[d] - bounds_.min()[d])/voxelSize_[d])
            )
        );
    }
    return (place[2]*nVoxels_[1] + place[1])*nVoxels_[0] + place[0];
}


Foam::label Foam::cellLocator::next
(
    const point& position,
    const label celli,
    const scalar tolerance
) const
{
    scalar worst = tolerance;
    label behind = celli;
    bool behindPatch = false;
    for (label i = starts_[celli]; i < starts_[celli + 1]; ++i)
    {
        const side& s = sides_[i];
        const scalar outside = s.outside(position);
        if (outside > tolerance)
        {
            if (s.cell < 0)
            {
                behindPatch = true;
            }
            else if (outside > worst)
            {
                worst = outside;
                behind = s.cell;
            }
        }
    }
    return behind == celli && behindPatch ? notKnown : behind;
}


Foam::label Foam::cellLocator::walk
(
    const point& position,
    const label start,
    const scalar tolerance
) const
{
    label celli = start;
    label previous = -1;
    for (label step = 0; step < maxWalk; ++step)
    {
        const label after = next(position, celli, tolerance);
        if (after == celli)
        {
            return celli;
        }
        if (after == notKnown || after == previous)
        {
            return notKnown;
        }
        previous = celli;
        celli = after;
    }
    return notKnown;
}


bool Foam::cellLocator::isNearBend
(
    const point& position,
    const label celli
) const
{
    return
        bends_.size()
     && bends_[celli] > 0
     && depth(position, celli) <= bends_[celli];
}


Foam::label Foam::cellLocator::search
(
    const point& position,
    const label hint,
    const scalar tolerance
) const
{
    // First those that are not numbers: comparing them would be trapped
    if
    (
        !std::isfinite(position.x())
     || !std::isfinite(position.y())
     || !std::isfinite(position.z())
    )
    {
        return inNoCell;
    }
    // Most particles are where they were
    if (hint >= 0 && next(position, hint, tolerance) == hint)
    {
        if
        (
            !isNearBend(position, hint)
         || mesh_.pointInCell(position, hint, polyMesh::CELL_TETS)
        )
        {
            return hint;
        }
    }
    if (!bounds_.contains(position) || mesh_.nCells() == 0)
    {
        return inNoCell;
    }

    // A hint may be of another particle, far away
    label start = seeds_[voxel(position)];
    const vectorField& centres = mesh_.cellCentres();
    if
    (
        hint >= 0
     && magSqr(position - centres[hint]) < magSqr(position - centres[start])
    )
    {
        start = hint;
    }
    const label celli = walk(position, start, tolerance);

    return
        celli == notKnown || isNearBend(position, celli)
      ? mesh_.cellTree().findInside(position)
      : celli;
}


Foam::point Foam::cellLocator::moved
(
    const point& position,
    const label octant
) const
{
    vector shift(shift_);
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        if (octant & (1 << d))
        {
            shift[d] *= -1;
        }
    }
    return position + shift;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLocator::cellLocator(const fvMesh& mesh)
:
    mesh_(mesh),
    onFace_(onFaceFraction*mesh.bounds().mag()),
    shift_(onFace_*tieBreak),
    bounds_(mesh.points(), false)
{
    bounds_.min() -= 2*onFace_*vector::one;
    bounds_.max() += 2*onFace_*vector::one;

    // Made now because all ranks are needed for it
    mesh_.tetBasePtIs();
    if (mesh_.nCells())
    {
        mesh_.cellTree();
    }

    setSides();
    setBends();
    setSeeds();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::cellLocator::find
(
    const point& position,
    const label hint
) const
{
    return search(position + shift_, hint, 0);
}


Foam::cellLocator::claim Foam::cellLocator::claimOf
(
    const point& position,
    const bool refused
) const
{
    const scalar tolerance = planesApart*onFace_;
    label celli =
        refused ? inNoCell : search(moved(position, 0), -1, tolerance);
    if (celli != inNoCell)
    {
        return {celli, 0};
    }

    // On a boundary, or outside
    const label itself = search(position, -1, 2*onFace_);
    if (itself == inNoCell)
    {
        return {inNoCell, labelMax};
    }
    for (label octant = 1; octant < nOctants; ++octant)
    {
        celli = search(moved(position, octant), -1, tolerance);
        if (celli != inNoCell)
        {
            return {celli, octant};
        }
    }
    return {itself, nOctants};
}


Foam::label Foam::cellLocator::nearest(const point& position) const
{
    const label celli = find(position);
    return
        celli >= 0 || !mesh_.nCells()
      ? celli
      : mesh_.cellTree().findNearest(position, GREAT).index();
}


Foam::scalar Foam::cellLocator::depth
(
    const point& position,
    const label celli
) const
{
    scalar least = GREAT;
    for (label i = starts_[celli]; i < starts_[celli + 1]; ++i)
    {
        least = std::min(least, -sides_[i].outside(position));
    }
    return least;
}


// ************************************************************************* //
