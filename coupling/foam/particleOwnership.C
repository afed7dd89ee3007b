// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleOwnership.H"
#include "bitSet.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::particleOwnership::orderByCell(labelList& rows) const
{
    // Counting sort; place 0 is for rows in no cell
    labelList next(locator_.mesh().nCells() + 2, Zero);
    for (const label celli : lastCells_)
    {
        ++next[celli + 2];
    }
    for (label place = 1; place < next.size(); ++place)
    {
        next[place] += next[place - 1];
    }
    rows.setSize(lastCells_.size());
    forAll(lastCells_, row)
    {
        rows[next[lastCells_[row] + 1]++] = row;
    }
}


void Foam::particleOwnership::offer
(
    const UList<point>& positions,
    const labelList& leftover
)
{
    const label me = Pstream::myProcNo();

    List<pointField> offers(Pstream::nProcs());
    offers[me] = pointField(positions, leftover);
    Pstream::gatherList(offers);
    Pstream::scatterList(offers);

    label nOffers = 0;
    for (const pointField& points : offers)
    {
        nOffers += points.size();
    }

    // The first claim counts; of several equal ones, which only round-off can
    // make, that of the lowest rank
    labelList first(nOffers, labelMax);
    labelList cells(nOffers);
    label row = 0;
    forAll(offers, from)
    {
        for (const point& position : offers[from])
        {
            const cellLocator::claim claim =
                locator_.claimOf(position, from == me);
            cells[row] = claim.cell;
            if (claim.cell >= 0)
            {
                first[row] = claim.order*Pstream::nProcs() + me;
            }
            ++row;
        }
    }
    Pstream::listCombineGather(first, minEqOp<label>());
    Pstream::listCombineScatter(first);

    DynamicList<label> stay(stay_);
    DynamicList<label> outside;
    DynamicList<label> ownCells(cells_);
    DynamicList<label> guestCells;
    List<DynamicList<label>> send(Pstream::nProcs());

    row = 0;
    forAll(offers, from)
    {
        forAll(offers[from], i)
        {
            const label to = first[row]%Pstream::nProcs();
            if (first[row] == labelMax)
            {
                ++nOutsideGlobal_;
                if (from == me)
                {
                    outside.append(leftover[i]);
                }
            }
            else if (to != from)
            {
                ++nMovedGlobal_;
                if (from == me)
                {
                    send[to].append(leftover[i]);
                }
                if (to == me)
                {
                    ++nGuests_[from];
                    guestCells.append(cells[row]);
                }
            }
            else if (from == me)
            {
                stay.append(leftover[i]);
                ownCells.append(cells[row]);
            }
            ++row;
        }
    }

    ownCells.append(guestCells);
    stay_.transfer(stay);
    cells_.transfer(ownCells);
    outside_.transfer(outside);
    forAll(send, proci)
    {
        send_[proci].transfer(send[proci]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleOwnership::particleOwnership(const cellLocator& locator)
:
    locator_(locator),
    nReceived_(0),
    nMovedGlobal_(0),
    nOutsideGlobal_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleOwnership::update
(
    const UList<point>& positions,
    const labelUList& passed
)
{
    passed_ = passed;
    nReceived_ = positions.size();
    nMovedGlobal_ = 0;
    nOutsideGlobal_ = 0;
    outside_.clear();
    send_ = labelListList(Pstream::nProcs());
    nGuests_ = labelList(Pstream::nProcs(), Zero);

    // Neighbours in the mesh one after the other, now and wherever the owned
    // rows are used: what is read of the mesh is then still in the cache
    lastCells_.setSize(nReceived_, -1);
    labelList rows;
    orderByCell(rows);
    for (const label row : rows)
    {
        lastCells_[row] = locator_.find(positions[row], lastCells_[row]);
    }
    orderByCell(rows);

    bitSet isPassed(nReceived_);
    isPassed.set(passed_);
    DynamicList<label> stay(nReceived_);
    DynamicList<label> cells(nReceived_);
    DynamicList<label> leftover;
    for (const label row : rows)
    {
        if (isPassed.test(row))
        {
            continue;
        }
        if (lastCells_[row] >= 0)
        {
            stay.append(row);
            cells.append(lastCells_[row]);
        }
        else
        {
            leftover.append(row);
        }
    }
    stay_.transfer(stay);
    cells_.transfer(cells);

    if (returnReduce(leftover.size(), sumOp<label>()) > 0)
    {
        offer(positions, leftover);
    }
}


// ************************************************************************* //
