// SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingTimer.H"
#include "IOstreams.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::couplingTimer::print
(
    const char* when,
    const std::array<scalar, nParts>& seconds
)
{
    Info<< "Wall time [s] " << when << ": search " << seconds[search]
        << ", fluid fraction and sources " << seconds[sharing]
        << ", interpolation " << seconds[interpolation]
        << ", force laws " << seconds[forces]
        << ", exchange " << seconds[exchange]
        << ", fluid " << seconds[fluid]
        << ", waiting for the particles " << seconds[wait] << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingTimer::reportInterval()
{
    std::array<scalar, nParts> spent(seconds_);
    for (std::size_t i = 0; i < spent.size(); ++i)
    {
        spent[i] -= reported_[i];
    }
    reported_ = seconds_;

    print("since the last exchange", spent);
}


void Foam::couplingTimer::report() const
{
    const scalar coupling =
        seconds_[search] + seconds_[sharing] + seconds_[interpolation]
      + seconds_[exchange];
    const scalar all = coupling + seconds_[forces] + seconds_[fluid];
    const scalar percent = 100/max(all, VSMALL);

    print("of the run", seconds_);
    Info<< "coupling share: " << percent*coupling << " %, with force laws "
        << percent*(coupling + seconds_[forces]) << " %" << nl << endl;
}


// ************************************************************************* //
