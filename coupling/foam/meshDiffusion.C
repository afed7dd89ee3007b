// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshDiffusion.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "surfaceFields.H"
#include "syncTools.H"
#include "volFields.H"
#include "UIPstream.H"
#include "UOPstream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::meshDiffusion::setCouplings
(
    const fvMesh& mesh,
    const surfaceScalarField& conductance
)
{
    // Areas of the two sides of a face agree to the mesh's tolerance only: the
    // mean of both, so that the sum is kept to round-off
    const label nInternal = mesh.nInternalFaces();
    scalarField otherSide(mesh.nFaces() - nInternal, Zero);
    for (const fvsPatchScalarField& mine : conductance.boundaryField())
    {
        SubList<scalar>
        (
            otherSide, mine.size(), mine.patch().start() - nInternal
        ) = mine;
    }
    syncTools::swapBoundaryFaceList(mesh, otherSide);

    wordList closed;
    for (const fvPatch& patch : mesh.boundary())
    {
        const polyPatch& poly = patch.patch();
        if (!poly.coupled() && !isA<cyclicAMIPolyPatch>(poly))
        {
            continue;
        }
        const bool turns =
            isA<coupledPolyPatch>(poly)
         && !refCast<const coupledPolyPatch>(poly).parallel();
        labelList otherCells;
        label rank = Pstream::myProcNo();
        int tag = 0;
        if (turns || isA<cyclicAMIPolyPatch>(poly))
        {
            closed.append(patch.name());
            continue;
        }
        if (isA<processorPolyPatch>(poly))
        {
            const auto& processor = refCast<const processorPolyPatch>(poly);
            rank = processor.neighbProcNo();
            tag = processor.tag();
        }
        else
        {
            otherCells =
                refCast<const cyclicPolyPatch>(poly).neighbPatch().faceCells();
        }
        const SubField<scalar> other
        (
            otherSide, patch.size(), patch.start() - nInternal
        );
        const scalarField mean
        (
            0.5*(conductance.boundaryField()[patch.index()] + other)
        );
        couplings_.append
        (
            coupling
            {
                patch.faceCells(),
                mean,
                otherCells,
                rank,
                tag
            }
        );
    }
    Pstream::combineGather(closed, ListOps::uniqueEqOp<word>());
    if (closed.size())
    {
        Info<< "Warning: nothing is smoothed across the patches "
            << flatOutput(closed) << ", of which the two sides are turned or"
            << " do not match face by face: they act as walls here" << endl;
    }
}


void Foam::meshDiffusion::setRows
(
    const fvMesh& mesh,
    const scalarField& conductance
)
{
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();

    starts_ = labelList(mesh.nCells() + 1, Zero);
    forAll(neighbour, facei)
    {
        ++starts_[owner[facei] + 1];
        ++starts_[neighbour[facei] + 1];
    }
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        starts_[celli + 1] += starts_[celli];
    }

    neighbours_.setSize(starts_.last());
    coefficients_.setSize(starts_.last());
    labelList next(starts_);
    blockSize_ = 1;
    forAll(neighbour, facei)
    {
        blockSize_ = max(blockSize_, neighbour[facei] - owner[facei]);
        const label own = next[owner[facei]]++;
        const label other = next[neighbour[facei]]++;
        neighbours_[own] = neighbour[facei];
        neighbours_[other] = owner[facei];
        coefficients_[own] = conductance[facei];
        coefficients_[other] = conductance[facei];
    }
}


Foam::scalar Foam::meshDiffusion::largestShare() const
{
    scalarField leaving(rV_.size(), Zero);
    forAll(leaving, celli)
    {
        for (label i = starts_[celli]; i < starts_[celli + 1]; ++i)
        {
            leaving[celli] += coefficients_[i];
        }
    }
    for (const coupling& c : couplings_)
    {
        forAll(c.cells, facei)
        {
            leaving[c.cells[facei]] += c.coefficients[facei];
        }
    }
    leaving *= rV_;

    // Round-off must not make the number depend on the decomposition
    return gMax(leaving)*(1 - 1e-9);
}


template<int N>
void Foam::meshDiffusion::sweepRows
(
    const label first,
    const label end,
    const scalar* const __restrict__ density,
    scalar* const __restrict__ result
) const
{
    // Rows and not faces: every cell is written once, in order
    const label* const start = starts_.cdata();
    const label* const neighbour = neighbours_.cdata();
    const scalar* const coefficient = coefficients_.cdata();
    for (label celli = first; celli < end; ++celli)
    {
        scalar own[N];
        scalar gain[N];
        for (label k = 0; k < N; ++k)
        {
            own[k] = density[celli*N + k];
            gain[k] = 0;
        }
        for (label i = start[celli]; i < start[celli + 1]; ++i)
        {
            const scalar* const other = density + neighbour[i]*N;
            for (label k = 0; k < N; ++k)
            {
                gain[k] += coefficient[i]*(other[k] - own[k]);
            }
        }
        for (label k = 0; k < N; ++k)
        {
            result[celli*N + k] = own[k] + rV_[celli]*gain[k];
        }
    }
}


template<int N>
void Foam::meshDiffusion::sweepBlocks
(
    scalar* const even,
    scalar* const odd
) const
{
    const label nBlocks = (rV_.size() + blockSize_ - 1)/blockSize_;
    for (label lead = 0; lead < nBlocks + nSweeps_ - 1; ++lead)
    {
        for (label i = max(label(0), lead - nBlocks + 1); i < nSweeps_; ++i)
        {
            const label first = (lead - i)*blockSize_;
            if (first < 0)
            {
                break;
            }
            sweepRows<N>
            (
                first,
                min(first + blockSize_, rV_.size()),
                i % 2 ? odd : even,
                i % 2 ? even : odd
            );
        }
    }
}


template<int N>
void Foam::meshDiffusion::sweep
(
    const UList<scalar>& old,
    UList<scalar>& densities
) const
{
    const scalar* const density = old.cdata();
    scalar* const result = densities.data();

    // Own side of the faces that are shared with other ranks
    const label startOfRequests = Pstream::nRequests();
    List<scalarList> sent(couplings_.size());
    List<scalarList> received(couplings_.size());
    forAll(couplings_, i)
    {
        const coupling& c = couplings_[i];
        if (c.rank == Pstream::myProcNo())
        {
            continue;
        }
        received[i].setSize(N*c.cells.size());
        UIPstream::read
        (
            Pstream::commsTypes::nonBlocking,
            c.rank,
            reinterpret_cast<char*>(received[i].data()),
            received[i].byteSize(),
            c.tag
        );
    }
    forAll(couplings_, i)
    {
        const coupling& c = couplings_[i];
        if (c.rank == Pstream::myProcNo())
        {
            continue;
        }
        sent[i].setSize(N*c.cells.size());
        forAll(c.cells, facei)
        {
            for (label k = 0; k < N; ++k)
            {
                sent[i][facei*N + k] = density[c.cells[facei]*N + k];
            }
        }
        UOPstream::write
        (
            Pstream::commsTypes::nonBlocking,
            c.rank,
            reinterpret_cast<const char*>(sent[i].cdata()),
            sent[i].byteSize(),
            c.tag
        );
    }

    sweepRows<N>(0, rV_.size(), density, result);

    Pstream::waitRequests(startOfRequests);
    forAll(couplings_, i)
    {
        const coupling& c = couplings_[i];
        const bool here = c.rank == Pstream::myProcNo();
        forAll(c.cells, facei)
        {
            const scalar* const other =
                here
              ? density + c.otherCells[facei]*N
              : received[i].cdata() + facei*N;
            const label own = c.cells[facei]*N;
            const scalar share = rV_[c.cells[facei]]*c.coefficients[facei];
            for (label k = 0; k < N; ++k)
            {
                result[own + k] += share*(other[k] - density[own + k]);
            }
        }
    }
}


template<int N>
void Foam::meshDiffusion::sweeps(scalarField& densities) const
{
    scalarField other(densities.size());
    if (couplings_.empty())
    {
        sweepBlocks<N>(densities.data(), other.data());
    }
    else
    {
        UList<scalar> from(densities);
        UList<scalar> to(other);
        for (label i = 0; i < nSweeps_; ++i)
        {
            sweep<N>(from, to);
            from.swap(to);
        }
    }
    if (nSweeps_ % 2)
    {
        densities.transfer(other);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshDiffusion::meshDiffusion(const fvMesh& mesh, const scalar Dt)
:
    leaving_(0),
    nSweeps_(0),
    blockSize_(1),
    rV_(1/mesh.V().field())
{
    // D t times area over distance [m3]
    const surfaceScalarField conductance
    (
        dimensionedScalar("Dt", dimArea, Dt)
       *mesh.magSf()*mesh.nonOrthDeltaCoeffs()
    );
    setRows(mesh, conductance.primitiveField());
    setCouplings(mesh, conductance);

    leaving_ = largestShare();
    nSweeps_ = min(max(std::ceil(leaving_/maxLeaving), 1.0), scalar(labelMax));

    coefficients_ /= nSweeps_;
    for (coupling& c : couplings_)
    {
        c.coefficients /= nSweeps_;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::meshDiffusion::spread
(
    const label n,
    scalarField& densities
) const
{
    // A width that is known to the compiler: the next larger one of these
    switch (n)
    {
        case 1: sweeps<1>(densities); return;
        case 4: sweeps<4>(densities); return;
    }

    constexpr label widest = 4;
    scalarField some;
    for (label first = 0; first < n; first += widest)
    {
        const label nHere = min(n - first, widest);
        const label width = nHere == 1 ? 1 : widest;
        some.setSize(width*rV_.size());
        some = 0;
        forAll(rV_, celli)
        {
            for (label k = 0; k < nHere; ++k)
            {
                some[celli*width + k] = densities[celli*n + first + k];
            }
        }
        spread(width, some);
        forAll(rV_, celli)
        {
            for (label k = 0; k < nHere; ++k)
            {
                densities[celli*n + first + k] = some[celli*width + k];
            }
        }
    }
}


// ************************************************************************* //
