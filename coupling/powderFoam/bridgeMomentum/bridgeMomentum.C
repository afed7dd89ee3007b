// SPDX-License-Identifier: GPL-3.0-or-later

#include "bridgeMomentum.H"
#include "bridgeValues.H"
#include "dictionaryChecks.H"
#include "drivingGradient.H"
#include "addToRunTimeSelectionTable.H"
#include "turbulentTransportModel.H"
#include "fvcDdt.H"
#include "fvcGrad.H"
#include "writtenFiles.H"
#include "zeroGradientFvPatchFields.H"

namespace bridge = powderlink::bridge;

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(bridgeMomentum, 0);
    addToRunTimeSelectionTable(particleMomentum, bridgeMomentum, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::bridgeMomentum::setFluidFraction()
{
    voidFraction_->set
    (
        particles_.position(),
        particles_.radius(),
        particles_.ownership().cells()
    );
    voidFraction_->checkFluidFraction(settings_.minFluidFraction);
    particleFluidFraction_.primitiveFieldRef() =
        1 - voidFraction_->solidsFraction().field();
    particleFluidFraction_.correctBoundaryConditions();
}


void Foam::bridgeMomentum::evaluateForces()
{
    interpolation_->set
    (
        particles_.position(), particles_.ownership().cells()
    );

    tmp<volScalarField> nuEff;
    if (forces_.needsViscousStress())
    {
        nuEff =
            mesh_.lookupObject<incompressible::turbulenceModel>
            (
                turbulenceModel::propertiesName
            ).nuEff();
    }

    const fluidForces::fluidFields fluid
    {
        U_,
        p_,
        particleFluidFraction_,
        nuEff.valid() ? &nuEff() : nullptr,
        ddtU_.valid() ? &ddtU_() : nullptr,
        drivingGradient::value(mesh_)
    };
    const fluidForces::fluidRows atParticles
    (
        forces_.interpolate(fluid, interpolation_(), settings_.minFluidFraction)
    );
    timer_.lap(couplingTimer::interpolation);

    forces_.evaluate(atParticles, particles_.rows(), rows_);
    timer_.lap(couplingTimer::forces);
}


void Foam::bridgeMomentum::sendValues()
{
    const bridgeValues values(forces_, rows_, particles_.ownership());
    link_.sendValues
    (
        {bridge::Command::go_on, isCheckpoint_, clock_.writesNext()},
        values.columns()
    );
    answerIsDue_ = false;
    timer_.lap(couplingTimer::exchange);
}


void Foam::bridgeMomentum::sayStop()
{
    if (isOver_)
    {
        return;
    }
    // What is written between two exchanges is no part of a pair
    const bool isWritten = fieldsAreWritten() && !(clock_.sinceExchange() > 0);
    if (answerIsDue_)
    {
        link_.sendValues({bridge::Command::stop, isCheckpoint_}, {});
    }
    else if (link_.receiveParticles())
    {
        link_.sendValues({bridge::Command::stop, isWritten}, {});
    }
    timer_.lap(couplingTimer::wait);
}


bool Foam::bridgeMomentum::fieldsAreWritten() const
{
    const Time& time = mesh_.time();
    if (time.timeIndex() <= time.startTimeIndex() || !time.writeTime())
    {
        return false;
    }
    const string broken = writtenFiles::firstBroken(mesh_);
    if (!broken.empty())
    {
        stopForDisk(broken);
    }
    return true;
}


void Foam::bridgeMomentum::stopForDisk(const string& file)
{
    FatalErrorInFunction
        << "checkpoint of the fluid at its end" << nl
        << "    given:   the disk did not take the whole file "
        << file.c_str() << nl
        << "    allowed: a folder that can be written to, on a disk with room"
        << nl
        << "    to do:   make room, then go on from the last pair:"
        << " powderlink restart CASE --prepare" << nl
        << exit(FatalError);
    std::abort();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bridgeMomentum::bridgeMomentum
(
    const fvMesh& mesh,
    const couplingProperties& coupling
)
:
    particleMomentum(mesh, coupling),
    timer_(),
    settings_(mesh, coupling),
    U_(mesh.lookupObject<volVectorField>("U")),
    p_(mesh.lookupObject<volScalarField>("p")),
    alphaf_(mesh.lookupObjectRef<volScalarField>("alphaf")),
    forces_(settings_.dict, settings_.fluid),
    clock_(mesh.time(), coupling),
    particles_(mesh),
    voidFraction_
    (
        voidFraction::New
        (
            particles_.locator(),
            dictionaryChecks::subDict
            (
                settings_.dict,
                "voidFraction",
                "{ type smooth; length 2e-4; }"
            )
        )
    ),
    interpolation_(fluidInterpolation::New(mesh, settings_.dict)),
    particleFluidFraction_
    (
        IOobject("particleFluidFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1.0),
        zeroGradientFvPatchScalarField::typeName
    ),
    alphafStart_(alphaf_.primitiveField()),
    account_(settings_, clock_, particles_, voidFraction_()),
    fields_(mesh, settings_.dict),
    ddtU_(),
    clocksOnDisk_(mesh),
    answerIsDue_(false),
    isCheckpoint_(false),
    isOver_(false),
    link_
    (
        settings_.dict,
        mesh.time(),
        bridgeParticles::needs(),
        bridgeValues::offers(forces_),
        clock_.interval(),
        clocksOnDisk_.start(),
        rankMap(particles_.locator())
    )
{
    if (forces_.needsAcceleration())
    {
        ddtU_.reset
        (
            new volVectorField
            (
                IOobject
                (
                    "ddtU",
                    mesh.time().timeName(),
                    mesh,
                    IOobject::READ_IF_PRESENT,
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensionedVector(dimAcceleration, Zero)
            )
        );
    }

    Info<< "Coupled with " << link_.peer().ranks << " rank(s) of "
        << link_.peer().role.c_str() << ", every " << clock_.interval()
        << " s, " << (settings_.twoWay ? "twoWay" : "oneWay") << ", "
        << (settings_.concurrent ? "concurrent" : "staggered") << ", "
        << (settings_.semiImplicit ? "semiImplicit" : "explicit") << nl
        << endl;

    if
    (
        settings_.twoWay
     && link_.peer().clock.continues
     && !clocksOnDisk_.start().continues
    )
    {
        Info<< "Warning: open balance of momentum at the start" << nl
            << "    given:   particles that go on from a checkpoint, fields of"
            << " time " << mesh.time().timeName() << " s that are none: no"
            << " uniform/couplingClock, no momentumBalance" << nl
            << "    allowed: both; without them the balance begins at zero, and"
            << " what was open is lost" << nl
            << "    to do:   restore both files, or go on from the last complete"
            << " pair: powderlink restart CASE --prepare; for a new run give fix"
            << " couple/bridge another ID" << nl << endl;
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::bridgeMomentum::~bridgeMomentum()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::bridgeMomentum::timeToExchange() const
{
    const scalar remaining = clock_.remaining();
    // An exchange that is due now comes before the step
    return remaining > 0 ? remaining : clock_.interval();
}


bool Foam::bridgeMomentum::startStep()
{
    if (clock_.remaining() > 0)
    {
        return true;
    }
    if (forces_.needsVelocityGradient() && mesh_.cache("grad(U)"))
    {
        // Work of the fluid: its momentum equation takes the same gradient
        fvc::grad(U_);
    }
    timer_.lap(couplingTimer::fluid);

    const bool goesOn = link_.receiveParticles();
    if (clock_.nExchanges() == 0)
    {
        timer_.start();
    }
    timer_.lap(couplingTimer::wait);
    if (!goesOn)
    {
        isOver_ = true;
        Info<< "The program of the particles has finished at time "
            << mesh_.time().timeName() << " s: so does this one" << nl << endl;
        return false;
    }

    clock_.check(link_.particles().time_s);
    clocksOnDisk_.set(clock_.offset());
    particles_.take(link_.particles(), link_.plan(), clock_.nExchanges());
    timer_.lap(couplingTimer::search);

    setFluidFraction();
    timer_.lap(couplingTimer::sharing);

    evaluateForces();
    fields_.set(particles_, rows_.dragCoefficient, voidFraction_());

    if (settings_.twoWay)
    {
        if (clock_.nExchanges() == 0 && !account_.isRestart())
        {
            alphaf_ = particleFluidFraction_;
            alphaf_.oldTime() = alphaf_;
        }
        alphafStart_ = alphaf_.primitiveField();
        account_.startInterval(rows_, Su_, Sp_);
        account_.report();
    }
    clock_.count();
    timer_.lap(couplingTimer::sharing);
    timer_.reportInterval();

    isCheckpoint_ = fieldsAreWritten();
    answerIsDue_ = true;
    if (settings_.concurrent)
    {
        sendValues();
    }
    return true;
}


void Foam::bridgeMomentum::advanceFluidFraction()
{
    if (!settings_.twoWay)
    {
        return;
    }
    const scalar share = clock_.share();
    alphaf_.primitiveFieldRef() =
        (1 - share)*alphafStart_ + share*particleFluidFraction_.primitiveField();
    alphaf_.correctBoundaryConditions();
}


void Foam::bridgeMomentum::endStep()
{
    if (settings_.twoWay)
    {
        account_.addStep(mesh_.time().deltaTValue(), U_, Su_, Sp_);
    }
    if (ddtU_.valid())
    {
        ddtU_() = fvc::ddt(U_);
    }

    if (clock_.remaining() > 0)
    {
        return;
    }
    timer_.lap(couplingTimer::fluid);
    if (settings_.twoWay)
    {
        account_.endInterval();
        timer_.lap(couplingTimer::sharing);
    }
    if (answerIsDue_)
    {
        rows_.fluidVelocity = interpolation_->interpolate(U_);
        timer_.lap(couplingTimer::interpolation);
        sendValues();
    }
}


void Foam::bridgeMomentum::write(Time& time)
{
    // A stream that has failed in the middle of a file
    const bool throws = FatalIOError.throwExceptions();
    try
    {
        time.write();
    }
    catch (const IOerror& error)
    {
        FatalIOError.throwExceptions(throws);
        stopForDisk(error.ioFileName());
    }
    FatalIOError.throwExceptions(throws);
}


void Foam::bridgeMomentum::fail(const string& why)
{
    link_.fail(why);
}


void Foam::bridgeMomentum::finish()
{
    timer_.lap(couplingTimer::fluid);
    if (clock_.sinceExchange() > 0)
    {
        // With the answer they have been let go for the whole interval
        const scalar particles =
            mesh_.time().value()
          + (answerIsDue_ ? -clock_.sinceExchange() : clock_.remaining());
        Info<< "Warning: the run ended between two exchanges: the gas is at "
            << mesh_.time().value() << " s, the particles are at "
            << particles << " s of the same clock" << nl << endl;
    }
    sayStop();
    timer_.report();
}


// ************************************************************************* //
