// SPDX-License-Identifier: GPL-3.0-or-later

#include "centreVoidFraction.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(centreVoidFraction, 0);
    addToRunTimeSelectionTable(voidFraction, centreVoidFraction, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::centreVoidFraction::setWeights
(
    const UList<point>&,
    const UList<scalar>&
)
{}


void Foam::centreVoidFraction::share
(
    const label n,
    const UList<scalar>& values,
    UList<scalar>& amounts
) const
{
    forAll(cells_, i)
    {
        for (label k = 0; k < n; ++k)
        {
            amounts[cells_[i]*n + k] += values[i*n + k];
        }
    }
}


void Foam::centreVoidFraction::collect
(
    const label n,
    const UList<scalar>& cellValues,
    UList<scalar>& values
) const
{
    forAll(cells_, i)
    {
        for (label k = 0; k < n; ++k)
        {
            values[i*n + k] += cellValues[cells_[i]*n + k];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::centreVoidFraction::centreVoidFraction(const cellLocator& locator)
:
    voidFraction(locator)
{}


Foam::centreVoidFraction::centreVoidFraction
(
    const cellLocator& locator,
    const dictionary& dict
)
:
    voidFraction(locator)
{
    dictionaryChecks::checkEntries(dict, {"type"}, {});
}


// ************************************************************************* //
