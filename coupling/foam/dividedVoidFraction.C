// SPDX-License-Identifier: GPL-3.0-or-later

#include "dividedVoidFraction.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dividedVoidFraction, 0);
    addToRunTimeSelectionTable(voidFraction, dividedVoidFraction, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::pointField Foam::dividedVoidFraction::unitPoints()
{
    DynamicList<point> directions;
    for (label i = -1; i <= 1; ++i)
    {
        for (label j = -1; j <= 1; ++j)
        {
            for (label k = -1; k <= 1; ++k)
            {
                const label nonZero = mag(i) + mag(j) + mag(k);
                if (nonZero == 1 || nonZero == 3)
                {
                    directions.append(normalised(vector(i, j, k)));
                }
            }
        }
    }

    DynamicList<point> points;
    points.append(point::zero);
    const scalar nPoints = 1 + 2*directions.size();
    for (label shell = 0; shell < 2; ++shell)
    {
        // Radii that hold the volume of the points inside and with this shell
        const scalar inner = cbrt((1 + shell*directions.size())/nPoints);
        const scalar outer = cbrt((1 + (shell + 1)*directions.size())/nPoints);
        const scalar mean =
            0.75*(pow4(outer) - pow4(inner))/(pow3(outer) - pow3(inner));
        for (const vector& direction : directions)
        {
            points.append(mean*direction);
        }
    }
    return pointField(std::move(points));
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::dividedVoidFraction::setWeights
(
    const UList<point>& positions,
    const UList<scalar>& radii
)
{
    const scalar pointWeight = 1.0/unitPoints_.size();

    starts_.setSize(positions.size() + 1);
    DynamicList<label> cells(2*positions.size());
    DynamicList<scalar> weights(2*positions.size());
    DynamicList<label> awayParticles;
    DynamicList<point> awayPositions;

    // Adds to the shares of the particle that begin at start
    auto add = [&](const label start, const label celli)
    {
        label i = start;
        while (i < cells.size() && cells[i] != celli)
        {
            ++i;
        }
        if (i == cells.size())
        {
            cells.append(celli);
            weights.append(0);
        }
        weights[i] += pointWeight;
    };

    forAll(positions, i)
    {
        starts_[i] = cells.size();
        const label centreCell = cells_[i];

        if (locator_.depth(positions[i], centreCell) >= radii[i])
        {
            cells.append(centreCell);
            weights.append(1);
            continue;
        }

        add(starts_[i], centreCell);
        for (label pointi = 1; pointi < unitPoints_.size(); ++pointi)
        {
            const point position(positions[i] + radii[i]*unitPoints_[pointi]);
            const label celli = locator_.find(position, centreCell);
            if (celli >= 0)
            {
                add(starts_[i], celli);
            }
            else
            {
                awayParticles.append(i);
                awayPositions.append(images_.inside(position, locator_.shift()));
            }
        }
    }
    starts_.last() = cells.size();

    away_.update(awayPositions);
    for (const label row : away_.outsideRows())
    {
        // The centre's share is the first one of a particle
        weights[starts_[awayParticles[row]]] += pointWeight;
    }

    shareCells_.transfer(cells);
    shareWeights_.transfer(weights);
    awayParticles_.transfer(awayParticles);
}


void Foam::dividedVoidFraction::share
(
    const label n,
    const UList<scalar>& values,
    UList<scalar>& amounts
) const
{
    for (label i = 0; i + 1 < starts_.size(); ++i)
    {
        for (label j = starts_[i]; j < starts_[i + 1]; ++j)
        {
            for (label k = 0; k < n; ++k)
            {
                amounts[shareCells_[j]*n + k] +=
                    shareWeights_[j]*values[i*n + k];
            }
        }
    }

    scalarList sent(awayParticles_.size());
    scalarList received;
    for (label k = 0; k < n; ++k)
    {
        forAll(sent, row)
        {
            sent[row] = values[awayParticles_[row]*n + k]/unitPoints_.size();
        }
        away_.toOwner(sent, received);
        forAll(received, row)
        {
            amounts[away_.cells()[row]*n + k] += received[row];
        }
    }
}


void Foam::dividedVoidFraction::collect
(
    const label n,
    const UList<scalar>& cellValues,
    UList<scalar>& values
) const
{
    for (label i = 0; i + 1 < starts_.size(); ++i)
    {
        for (label j = starts_[i]; j < starts_[i + 1]; ++j)
        {
            for (label k = 0; k < n; ++k)
            {
                values[i*n + k] +=
                    shareWeights_[j]*cellValues[shareCells_[j]*n + k];
            }
        }
    }

    scalarList there(away_.nOwned());
    scalarList back;
    for (label k = 0; k < n; ++k)
    {
        forAll(there, row)
        {
            there[row] = cellValues[away_.cells()[row]*n + k];
        }
        away_.toReceiver(there, back, scalar(0));
        forAll(back, row)
        {
            values[awayParticles_[row]*n + k] += back[row]/unitPoints_.size();
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dividedVoidFraction::dividedVoidFraction
(
    const cellLocator& locator,
    const dictionary& dict
)
:
    voidFraction(locator),
    unitPoints_(unitPoints()),
    starts_(1, Zero),
    images_(locator.mesh()),
    away_(locator)
{
    dictionaryChecks::checkEntries(dict, {"type"}, {});
}


// ************************************************************************* //
