// SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothVoidFraction.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "surfaceFields.H"
#include "UIPstream.H"
#include "UOPstream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(smoothVoidFraction, 0);
    addToRunTimeSelectionTable(voidFraction, smoothVoidFraction, dictionary);

    // What may leave a cell in one sweep
    static const scalar maxLeaving = 0.5;

    // A length of about 40 cells: beyond, the mesh is not meant for it
    static const label maxSweeps = 2000;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::smoothVoidFraction::readLength(const dictionary& dict)
{
    dictionaryChecks::checkEntries(dict, {"type", "length"}, {});

    const string allowed("a length above 0 m");
    const scalar length =
        dictionaryChecks::get<scalar>(dict, "length", allowed);
    if (!(length > 0))
    {
        dictionaryChecks::badValue
        (
            dict,
            "length",
            Foam::name(length),
            allowed,
            "set about three diameters of the largest particles"
        );
    }
    return length;
}


void Foam::smoothVoidFraction::addCoupling
(
    const fvPatch& patch,
    const surfaceScalarField& conductance
)
{
    const scalarField& mine = conductance.boundaryField()[patch.index()];

    if (isA<processorPolyPatch>(patch.patch()))
    {
        const auto& pp = refCast<const processorPolyPatch>(patch.patch());
        couplings_.append
        (
            coupling
            {
                patch.faceCells(),
                mine,
                labelList(),
                pp.neighbProcNo(),
                pp.tag()
            }
        );
    }
    else if (isA<cyclicPolyPatch>(patch.patch()))
    {
        const auto& pp = refCast<const cyclicPolyPatch>(patch.patch());
        if (pp.parallel())
        {
            // Areas of the two sides agree to the mesh's tolerance only: the
            // mean of both, so that the sum is kept to round-off
            const scalarField mean
            (
                0.5*(mine + conductance.boundaryField()[pp.neighbPatchID()])
            );
            couplings_.append
            (
                coupling
                {
                    patch.faceCells(),
                    mean,
                    labelList(pp.neighbPatch().faceCells()),
                    Pstream::myProcNo(),
                    0
                }
            );
        }
    }
}


template<int N>
void Foam::smoothVoidFraction::sweep
(
    const label n,
    UList<scalar>& densities,
    UList<scalar>& gains
) const
{
    const label width = N > 0 ? N : n;
    const scalar* const density = densities.cdata();
    scalar* const gain = gains.data();

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
        received[i].setSize(width*c.cells.size());
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
        sent[i].setSize(width*c.cells.size());
        forAll(c.cells, facei)
        {
            for (label k = 0; k < width; ++k)
            {
                sent[i][facei*width + k] = density[c.cells[facei]*width + k];
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

    gains = 0;
    const label* const owner = mesh_.owner().cdata();
    const label* const neighbour = mesh_.neighbour().cdata();
    forAll(coefficients_, facei)
    {
        const label own = owner[facei]*width;
        const label other = neighbour[facei]*width;
        const scalar coefficient = coefficients_[facei];
        for (label k = 0; k < width; ++k)
        {
            const scalar flow =
                coefficient*(density[other + k] - density[own + k]);
            gain[own + k] += flow;
            gain[other + k] -= flow;
        }
    }

    Pstream::waitRequests(startOfRequests);
    forAll(couplings_, i)
    {
        const coupling& c = couplings_[i];
        const bool here = c.rank == Pstream::myProcNo();
        forAll(c.cells, facei)
        {
            const scalar* const other =
                here
              ? density + c.otherCells[facei]*width
              : received[i].cdata() + facei*width;
            const label own = c.cells[facei]*width;
            for (label k = 0; k < width; ++k)
            {
                gain[own + k] +=
                    c.coefficients[facei]*(other[k] - density[own + k]);
            }
        }
    }

    forAll(rV_, celli)
    {
        for (label k = 0; k < width; ++k)
        {
            densities[celli*width + k] += rV_[celli]*gain[celli*width + k];
        }
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::smoothVoidFraction::spread
(
    const label n,
    UList<scalar>& densities
) const
{
    scalarField gains(densities.size());
    for (label i = 0; i < nSweeps_; ++i)
    {
        // The widths that the coupling uses are compiled as such
        switch (n)
        {
            case 1: sweep<1>(n, densities, gains); break;
            case 3: sweep<3>(n, densities, gains); break;
            case 4: sweep<4>(n, densities, gains); break;
            case 7: sweep<7>(n, densities, gains); break;
            case 8: sweep<8>(n, densities, gains); break;
            default: sweep<0>(n, densities, gains); break;
        }
    }
}


Foam::string Foam::smoothVoidFraction::remedy
(
    const scalar largestDiameter
) const
{
    return
        "raise length (now " + Foam::name(length_) + ") to at least "
      + Foam::name(max(3*largestDiameter, 1.5*length_))
      + ", check that the particles do not overlap by much, or lower"
        " minFluidFraction";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::smoothVoidFraction::smoothVoidFraction
(
    const cellLocator& locator,
    const dictionary& dict
)
:
    centreVoidFraction(locator),
    length_(readLength(dict)),
    nSweeps_(0),
    rV_(1/mesh_.V().field())
{
    // D t of the whole spreading times area over distance [m3]
    const scalar Dt = 0.5*sqr(length_)/(8*Foam::log(scalar(2)));
    const surfaceScalarField conductance
    (
        dimensionedScalar("Dt", dimArea, Dt)
       *mesh_.magSf()*mesh_.nonOrthDeltaCoeffs()
    );
    coefficients_ = conductance.primitiveField();
    for (const fvPatch& patch : mesh_.boundary())
    {
        addCoupling(patch, conductance);
    }

    // What would leave each cell at once
    scalarField leaving(mesh_.nCells(), Zero);
    forAll(coefficients_, facei)
    {
        leaving[mesh_.owner()[facei]] += coefficients_[facei];
        leaving[mesh_.neighbour()[facei]] += coefficients_[facei];
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
    const scalar most = gMax(leaving)*(1 - 1e-9);
    if (most/maxLeaving > maxSweeps)
    {
        dictionaryChecks::badValue
        (
            dict,
            "length",
            Foam::name(length_),
            "at most " + Foam::name(length_*sqrt(maxSweeps*maxLeaving/most))
          + " m on this mesh, because of its smallest cells",
            "shorten length, three particle diameters are usual, or use larger"
            " cells"
        );
    }
    nSweeps_ = std::max(1.0, std::ceil(most/maxLeaving));

    coefficients_ /= nSweeps_;
    for (coupling& c : couplings_)
    {
        c.coefficients /= nSweeps_;
    }

    Info<< "    width at half maximum " << length_ << " m, " << nSweeps_
        << " sweep(s) over the mesh" << endl;
}


// ************************************************************************* //
