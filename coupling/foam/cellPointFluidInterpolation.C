// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellPointFluidInterpolation.H"
#include "addToRunTimeSelectionTable.H"
#include "bitSet.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellPointFluidInterpolation, 0);
    addToRunTimeSelectionTable
    (
        fluidInterpolation,
        cellPointFluidInterpolation,
        mesh
    );

    // A weight that is negative by round-off only
    static const scalar roundOff = 1e-10;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::cellPointFluidInterpolation::tetrahedron
Foam::cellPointFluidInterpolation::findTetrahedron
(
    const point& position,
    const label celli
) const
{
    const pointField& points = mesh_.points();
    const point& centre = mesh_.cellCentres()[celli];
    const vector r(position - centre);

    tetrahedron best{{0, 0, 0}, {0, 0, 0}};
    scalar bestLeast = -GREAT;

    // The ray from the centre through the position leaves the cell through
    // this face: nearly always one of its tetrahedra is the right one
    const label nFaces = starts_[celli + 1] - starts_[celli];
    const side* const sides = &sides_[starts_[celli]];
    label exit = 0;
    scalar largest = -GREAT;
    for (label i = 0; i < nFaces; ++i)
    {
        const scalar along = r & sides[i].gradient;
        if (along > largest)
        {
            largest = along;
            exit = i;
        }
    }

    for (label n = 0; n < nFaces; ++n)
    {
        const label facei = sides[n == 0 ? exit : n == exit ? 0 : n].face;
        const label* const f = &facePoints_[faceStarts_[facei]];
        const label size = faceStarts_[facei + 1] - faceStarts_[facei];
        const vector a(points[f[0]] - centre);

        for (label i = 1; i + 1 < size; ++i)
        {
            const label pointB = f[i];
            const label pointC = f[i + 1];
            const vector b(points[pointB] - centre);
            const vector c(points[pointC] - centre);

            const vector bc(b ^ c);
            const scalar volume = a & bc;
            if (mag(volume) < VSMALL)
            {
                continue;
            }
            const vector ra(r ^ a);
            const scalar weightA = (r & bc)/volume;
            const scalar weightB = -(ra & c)/volume;
            const scalar weightC = (ra & b)/volume;
            const scalar least = min
            (
                min(weightA, 1 - weightA - weightB - weightC),
                min(weightB, weightC)
            );
            if (least > bestLeast)
            {
                bestLeast = least;
                best =
                {
                    {f[0], pointB, pointC},
                    {weightA, weightB, weightC}
                };
                if (least > -roundOff)
                {
                    return best;
                }
            }
        }
    }

    scalar sum = 0;
    for (scalar& weight : best.weights)
    {
        weight = max(weight, scalar(0));
        sum += weight;
    }
    for (scalar& weight : best.weights)
    {
        weight /= max(sum, scalar(1));
    }
    return best;
}


void Foam::cellPointFluidInterpolation::setFaces()
{
    const labelList& basePoints = mesh_.tetBasePtIs();
    DynamicList<label> points(4*mesh_.nFaces());
    faceStarts_.setSize(mesh_.nFaces() + 1);
    forAll(mesh_.faces(), facei)
    {
        faceStarts_[facei] = points.size();
        const face& f = mesh_.faces()[facei];
        const label base = max(label(0), basePoints[facei]);
        forAll(f, i)
        {
            points.append(f[(base + i)%f.size()]);
        }
    }
    faceStarts_.last() = points.size();
    facePoints_.transfer(points);
}


void Foam::cellPointFluidInterpolation::setSides()
{
    DynamicList<side> sides(2*mesh_.nFaces());
    starts_.setSize(mesh_.nCells() + 1);
    forAll(mesh_.cells(), celli)
    {
        starts_[celli] = sides.size();
        const point& centre = mesh_.cellCentres()[celli];
        for (const label facei : mesh_.cells()[celli])
        {
            const vector& S = mesh_.faceAreas()[facei];
            const scalar height = (mesh_.faceCentres()[facei] - centre) & S;
            sides.append(side{S/stabilise(height, VSMALL), facei});
        }
    }
    starts_.last() = sides.size();
    sides_.transfer(sides);
}


template<class Type>
Foam::tmp<Foam::Field<Type>>
Foam::cellPointFluidInterpolation::interpolateField
(
    const GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    const tmp<Field<Type>> tatPoints(pointValues_.interpolate(field, points_));
    const Field<Type>& atPoints = tatPoints();

    tmp<Field<Type>> tvalues(new Field<Type>(cells_.size()));
    Field<Type>& values = tvalues.ref();
    forAll(values, i)
    {
        const tetrahedron& t = tetrahedra_[i];
        values[i] =
            (1 - t.weights[0] - t.weights[1] - t.weights[2])*field[cells_[i]]
          + t.weights[0]*atPoints[t.points[0]]
          + t.weights[1]*atPoints[t.points[1]]
          + t.weights[2]*atPoints[t.points[2]];
    }
    return tvalues;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::cellPointFluidInterpolation::setWeights
(
    const UList<point>& positions
)
{
    tetrahedra_.setSize(positions.size());
    forAll(positions, i)
    {
        tetrahedra_[i] = findTetrahedron(positions[i], cells_[i]);
    }

    bitSet isUsed(mesh_.nPoints());
    for (const tetrahedron& t : tetrahedra_)
    {
        for (const label pointi : t.points)
        {
            isUsed.set(pointi);
        }
    }
    points_ = isUsed.sortedToc();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellPointFluidInterpolation::cellPointFluidInterpolation
(
    const fvMesh& mesh
)
:
    fluidInterpolation(mesh),
    pointValues_(mesh)
{
    setFaces();
    setSides();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::cellPointFluidInterpolation::interpolate
(
    const volScalarField& field
) const
{
    return interpolateField(field);
}


Foam::tmp<Foam::vectorField> Foam::cellPointFluidInterpolation::interpolate
(
    const volVectorField& field
) const
{
    return interpolateField(field);
}


// ************************************************************************* //
