// SPDX-License-Identifier: GPL-3.0-or-later

#include "smoothVoidFraction.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(smoothVoidFraction, 0);
    addToRunTimeSelectionTable(voidFraction, smoothVoidFraction, dictionary);

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


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::smoothVoidFraction::spread
(
    const label n,
    scalarField& densities
) const
{
    diffusion_.spread(n, densities);
}


Foam::string Foam::smoothVoidFraction::remedy
(
    const scalar largestDiameter
) const
{
    return
        "raise length (now " + Foam::name(length_) + ") to at least "
      + Foam::name(max(3*largestDiameter, 1.5*length_))
      + ", check that the particles do not overlap by much,"
        " or lower minFluidFraction";
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
    // D t = sigma^2/2 of the Gaussian
    diffusion_(mesh_, sqr(length_)/(16*Foam::log(scalar(2))))
{
    const scalar most = maxSweeps*meshDiffusion::maxLeaving;
    if (diffusion_.leaving() > most)
    {
        dictionaryChecks::badValue
        (
            dict,
            "length",
            Foam::name(length_),
            "at most " + Foam::name(length_*sqrt(most/diffusion_.leaving()))
          + " m on this mesh, because of its smallest cells",
            "shorten length,"
            " three particle diameters are usual, or use larger cells"
        );
    }

    Info<< "    width at half maximum " << length_ << " m, "
        << diffusion_.nSweeps() << " sweep(s) over the mesh" << endl;
}


// ************************************************************************* //
