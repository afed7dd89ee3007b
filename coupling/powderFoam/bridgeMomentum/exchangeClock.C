// SPDX-License-Identifier: GPL-3.0-or-later

#include "exchangeClock.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // Sums of time steps are off by round-off; a step is far longer than that
    constexpr double roundOff = 1e-6;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::exchangeClock::interval
(
    const Time& time,
    const couplingProperties& coupling
)
{
    const bool adjusted =
        time.controlDict().lookupOrDefault("adjustTimeStep", false);

    if (adjusted && coupling.couplingTime() <= 0)
    {
        dictionaryChecks::badValue
        (
            time.controlDict(),
            "adjustTimeStep",
            "yes, without couplingTime",
            "steps of constant length,"
            " or couplingTime [s] in constant/couplingProperties",
            "set couplingTime instead of couplingInterval there"
        );
    }
    const scalar nSteps = coupling.couplingTime()/time.deltaTValue();
    if
    (
        !adjusted
     && coupling.couplingTime() > 0
     && (round(nSteps) < 1 || mag(nSteps - round(nSteps)) > roundOff*nSteps)
    )
    {
        dictionaryChecks::badValue
        (
            time.controlDict(),
            "deltaT",
            Foam::name(time.deltaTValue()) + " s, with couplingTime "
          + Foam::name(coupling.couplingTime()) + " s",
            "a whole number of steps from exchange to exchange,"
            " or steps that are adjusted",
            "set deltaT "
          + Foam::name(coupling.couplingTime()/max(ceil(nSteps), 1.0))
          + ", or adjustTimeStep yes and maxCo"
        );
    }

    return
        coupling.couplingTime() > 0
      ? coupling.couplingTime()
      : coupling.couplingInterval()*time.deltaTValue();
}


void Foam::exchangeClock::checkPurge() const
{
    const dictionary& dict = time_.controlDict();
    const label nKept = dict.lookupOrDefault<label>("purgeWrite", 0);
    if (nKept == 1)
    {
        // OpenFOAM removes the older time while it writes; the particles'
        // part of the new pair comes after that
        dictionaryChecks::badValue
        (
            dict,
            "purgeWrite",
            "1",
            "0 (keep all), or at least 2: the last pair of checkpoints"
            " must stay until the next one is whole",
            "set purgeWrite 2"
        );
    }
}


Foam::label Foam::exchangeClock::checkWriteTimes() const
{
    const dictionary& dict = time_.controlDict();
    const word control(dict.lookupOrDefault<word>("writeControl", "timeStep"));
    const scalar writeInterval =
        dict.lookupOrDefault<scalar>("writeInterval", GREAT);

    if (control == "none" || writeInterval > 1e15)
    {
        return 0;
    }

    const bool byTime =
        control == "runTime"
     || control == "adjustable"
     || control == "adjustableRunTime";
    const bool bySteps =
        control == "timeStep"
     && !dict.lookupOrDefault("adjustTimeStep", false);
    if (!byTime && !bySteps)
    {
        dictionaryChecks::badValue
        (
            dict,
            "writeControl",
            control
          + (control == "timeStep" ? ", with adjustTimeStep yes" : ""),
            "runTime or adjustableRunTime,"
            " and timeStep with steps of constant length:"
            " fields are written at exchanges",
            "set writeControl adjustableRunTime and writeInterval [s]"
        );
    }

    // Never written
    constexpr scalar never = 1e9;
    const scalar period =
        byTime ? writeInterval : writeInterval*time_.deltaTValue();
    const scalar nIntervals = period/interval_;
    if (nIntervals > never)
    {
        return 0;
    }
    if
    (
        mag(nIntervals - round(nIntervals)) > roundOff*max(nIntervals, 1.0)
    )
    {
        dictionaryChecks::badValue
        (
            dict,
            "writeInterval",
            "fields every " + Foam::name(period) + " s, exchanges every "
          + Foam::name(interval_) + " s",
            "a whole number of exchanges from write to write",
            "change writeInterval,"
            " or couplingInterval in constant/couplingProperties"
        );
    }
    return round(nIntervals);
}


void Foam::exchangeClock::warnOfEnd() const
{
    const dictionary& dict = time_.controlDict();
    if (dict.lookupOrDefault<word>("stopAt", "endTime") != "endTime")
    {
        return;
    }
    const scalar end = time_.endTime().value();
    const scalar nIntervals = (end - start_)/interval_;
    // Never, or so late that steps cannot be counted
    constexpr scalar never = 1e9;
    if (!(nIntervals > 0 && nIntervals < never))
    {
        return;
    }
    // The run ends with the step that is nearest to endTime
    const bool adjusted = dict.lookupOrDefault("adjustTimeStep", false);
    const scalar step = adjusted ? 0 : time_.deltaTValue();
    const scalar off = mag(nIntervals - round(nIntervals))*interval_;
    if (off <= max(0.5*step, roundOff*max(nIntervals, 1.0)*interval_))
    {
        return;
    }
    const scalar last = start_ + floor(nIntervals)*interval_;
    Info<< "Warning: endTime lies between two exchanges" << nl
        << "    given:   endTime " << end << " s, exchanges every " << interval_
        << " s from " << start_ << " s on" << nl
        << "    allowed: a whole number of exchanges: after the last one, at "
        << last << " s, the gas alone would go on, for " << end - last
        << " s, and the particles stand" << nl
        << "    to do:   set endTime " << last << " or " << last + interval_
        << nl << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::exchangeClock::exchangeClock
(
    const Time& time,
    const couplingProperties& coupling
)
:
    time_(time),
    interval_(interval(time, coupling)),
    nExchanges_(0),
    start_(time.value()),
    nToWrite_(checkWriteTimes()),
    offset_(0)
{
    checkPurge();
    warnOfEnd();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::exchangeClock::remaining() const
{
    const scalar time = start_ + nExchanges_*interval_ - time_.value();
    return time > roundOff*interval_ ? time : 0;
}


Foam::scalar Foam::exchangeClock::sinceExchange() const
{
    return nExchanges_ && remaining() > 0 ? interval_ - remaining() : 0;
}


Foam::scalar Foam::exchangeClock::share() const
{
    return min(1 - remaining()/interval_, scalar(1));
}


void Foam::exchangeClock::check(const scalar otherTime)
{
    const scalar offset = otherTime - time_.value();
    if (nExchanges_ == 0)
    {
        offset_ = offset;
        if (mag(offset) > roundOff*interval_)
        {
            Info<< "The particles' time is ours plus " << offset << " s"
                << endl;
        }
        return;
    }
    // A hundredth of an interval: far above round-off, far below a step
    if (mag(offset - offset_) > 0.01*interval_)
    {
        FatalErrorInFunction
            << "the clocks of the two programs go apart" << nl
            << "    given:   particles at " << otherTime
            << " s, fluid at " << time_.value() << " s" << nl
            << "    allowed: a constant difference, " << offset_ << " s"
            << nl
            << "    to do:   do not change the time step of a program during"
            << " a coupled run" << nl
            << exit(FatalError);
    }
}


// ************************************************************************* //
