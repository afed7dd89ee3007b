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

void Foam::couplingTimer::start()
{
    seconds_ = {};
    reported_ = {};
    last_ = clock::now();
}


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
    const scalar own = coupling + seconds_[forces] + seconds_[fluid];

    print("of the run", seconds_);
    Info<< "coupling share: "
        << 100*coupling/max(own + seconds_[wait], VSMALL)
        << " % of the coupled steps; of the work of this program "
        << 100*coupling/max(own, VSMALL) << " %, with force laws "
        << 100*(coupling + seconds_[forces])/max(own, VSMALL) << " %" << nl
        << endl;
}


// ************************************************************************* //
