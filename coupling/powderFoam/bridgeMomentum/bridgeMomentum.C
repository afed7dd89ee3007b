// SPDX-License-Identifier: GPL-3.0-or-later

#include "bridgeMomentum.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"
#include "turbulentTransportModel.H"
#include "fvcDdt.H"
#include "uniformDimensionedFields.H"
#include "zeroGradientFvPatchFields.H"
#include "writtenFiles.H"

#include "coupling/bridge/coupling_fields.h"
#include "coupling/forces/semi_implicit_step.h"

#include <cstring>

namespace bridge = powderlink::bridge;

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(bridgeMomentum, 0);
    addToRunTimeSelectionTable(particleMomentum, bridgeMomentum, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // OpenFOAM's vectors are three doubles in a row, as in the exchange
    static_assert(sizeof(Foam::vector) == 3*sizeof(double), "vector");

    const double* doubles(const Foam::UList<Foam::vector>& list)
    {
        return reinterpret_cast<const double*>(list.cdata());
    }

    template<class Type>
    Foam::List<Type> rowsOf
    (
        const bridge::ParticleTable& table,
        const bridge::ExchangePlan& plan,
        const bridge::FieldSpec& spec
    )
    {
        Foam::List<Type> rows(Foam::label(table.particles));
        for (std::size_t i = 0; i < plan.to_solver.size(); ++i)
        {
            if (plan.to_solver[i] == spec && rows.size())
            {
                std::memcpy
                (
                    static_cast<void*>(rows.data()),
                    table.fields[i].view().data(),
                    rows.size()*sizeof(Type)
                );
            }
        }
        return rows;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::bridgeMomentum::requiredEntries()
{
    return wordList
    ({
        "type", "transport", "voidFraction", "interpolation", "forces"
    });
}


Foam::fluidForces::fluidProperties Foam::bridgeMomentum::readProperties
(
    const couplingProperties& coupling
) const
{
    const auto& transport =
        mesh_.lookupObject<IOdictionary>("transportProperties");

    for (const word name : {"rho", "nu"})
    {
        if (!transport.found(name))
        {
            dictionaryChecks::badValue
            (
                transport,
                name,
                "missing",
                "density rho [kg/m3] and kinematic viscosity nu [m2/s] of"
                " the fluid",
                "add them: forces on particles need them"
            );
        }
    }

    fluidForces::fluidProperties properties;
    properties.rho = dimensionedScalar("rho", dimDensity, transport).value();
    properties.nu =
        dimensionedScalar("nu", dimViscosity, transport).value();
    properties.g = Zero;
    properties.modelA = coupling.pressureShared();

    const uniformDimensionedVectorField g
    (
        IOobject
        (
            "g",
            mesh_.time().constant(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        dimensionedVector(dimAcceleration, Zero)
    );
    properties.g = g.value();

    if
    (
        dict_.get<wordList>("forces").found("buoyancy")
     && mag(properties.g) < VSMALL
    )
    {
        dictionaryChecks::badValue
        (
            dict_,
            "forces",
            "buoyancy, and no gravity",
            "buoyancy with constant/g",
            "write constant/g, or remove buoyancy"
        );
    }
    return properties;
}


void Foam::bridgeMomentum::stop(const std::exception& error)
{
    if (link_)
    {
        link_->fail(error.what());
    }
    FatalErrorInFunction
        << "the link to the program of the particles failed at time "
        << mesh_.time().timeName() << " s" << nl
        << "    " << error.what() << nl
        << exit(FatalError);
    std::abort();
}


std::vector<bridge::FieldSpec> Foam::bridgeMomentum::offers() const
{
    namespace f = bridge::fields;
    std::vector<bridge::FieldSpec> specs
    {
        f::fluid_velocity,
        f::fluid_fraction,
        f::drag_coefficient,
        f::reacting_force,
        f::pressure_force
    };
    if (forces_.hasTorque())
    {
        specs.push_back(f::fluid_spin);
        specs.push_back(f::rotational_drag);
        specs.push_back(f::fluid_torque);
    }
    if (forces_.hasAddedMass())
    {
        specs.push_back(f::added_mass);
    }
    return specs;
}


void Foam::bridgeMomentum::takeParticles()
{
    namespace f = bridge::fields;
    const bridge::ParticleTable& table = link_->particles();
    const bridge::ExchangePlan& plan = link_->plan();

    const List<point> position = rowsOf<point>(table, plan, f::position);
    ownership_.update(position);
    checkOutside(position, rowsOf<int64_t>(table, plan, f::id));

    ownership_.toOwner(position, particles_.position);
    ownership_.toOwner
    (
        rowsOf<vector>(table, plan, f::velocity), particles_.velocity
    );
    ownership_.toOwner(rowsOf<vector>(table, plan, f::spin), particles_.spin);
    ownership_.toOwner
    (
        rowsOf<scalar>(table, plan, f::radius), particles_.radius
    );
    ownership_.toOwner
    (
        rowsOf<scalar>(table, plan, f::density), particles_.density
    );
    ownership_.toOwner
    (
        rowsOf<vector>(table, plan, f::reaction_impulse), particles_.impulse
    );
}


void Foam::bridgeMomentum::checkOutside
(
    const List<point>& received,
    const List<int64_t>& ids
)
{
    const label nOutside = ownership_.nOutsideGlobal();
    const label nAll = returnReduce(received.size(), sumOp<label>());
    Info<< "exchange " << clock_.nExchanges() << ": " << nAll
        << " particles, " << nOutside << " outside" << endl;
    if (!nOutside)
    {
        return;
    }
    const boundBox bounds(received, true);

    if (nOutside == nAll)
    {
        FatalErrorInFunction
            << "the domains of the two programs do not overlap: no particle"
            << " is in the mesh" << nl
            << "    given:   " << nAll << " particles within " << bounds << nl
            << "    allowed: particles within the mesh, " << mesh_.bounds()
            << nl
            << "    to do:   check units and origin of the mesh and of the"
            << " particles" << nl
            << exit(FatalError);
    }

    // The first ones of every rank
    constexpr label nNamed = 5;
    const labelList& rows = ownership_.outsideRows();
    OStringStream here;
    for (label i = 0; i < min(nNamed, rows.size()); ++i)
    {
        here << ' ' << ids[rows[i]] << " at " << received[rows[i]];
    }
    List<string> texts(Pstream::nProcs());
    texts[Pstream::myProcNo()] = here.str();
    Pstream::gatherList(texts);

    Info<< "Warning: particles outside the mesh feel no fluid; id and place:";
    for (const string& text : texts)
    {
        Info<< text.c_str();
    }
    Info<< endl;
}


void Foam::bridgeMomentum::checkTime(const scalar particleTime)
{
    const scalar offset = particleTime - mesh_.time().value();
    if (clock_.nExchanges() == 0)
    {
        timeOffset_ = offset;
        clocks_.set(offset);
        if (mag(offset) > 1e-6*clock_.interval())
        {
            Info<< "The particles' time is ours plus " << offset << " s"
                << endl;
        }
        return;
    }
    // A hundredth of an interval: far above round-off, far below a step
    if (mag(offset - timeOffset_) > 0.01*clock_.interval())
    {
        FatalErrorInFunction
            << "the clocks of the two programs go apart" << nl
            << "    given:   particles at " << particleTime
            << " s, fluid at " << mesh_.time().value() << " s" << nl
            << "    allowed: a constant difference, " << timeOffset_ << " s"
            << nl
            << "    to do:   do not change the time step of a program during"
            << " a coupled run" << nl
            << exit(FatalError);
    }
}


void Foam::bridgeMomentum::evaluateForces()
{
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
        ddtU_.valid() ? &ddtU_() : nullptr
    };
    const fluidForces::particleRows particles
    {
        particles_.velocity,
        particles_.spin,
        particles_.radius,
        particles_.density
    };
    forces_.evaluate
    (
        fluid, interpolation_(), particles, minFluidFraction_, rows_
    );
}


void Foam::bridgeMomentum::setSource()
{
    const scalar D = clock_.interval();
    const scalar rho = properties_.rho;
    const label n = particles_.position.size();

    // Per particle: K' (explicit: K), K' v - F, -J
    constexpr label nValues = 7;
    scalarField values(nValues*n);
    relaxedDrag_.setSize(n);
    relaxedDrag_ = 0;
    path_ = Zero;
    vector impulse(Zero);
    scalar magImpulse = 0;
    for (label i = 0; i < n; ++i)
    {
        scalar K = rows_.dragCoefficient[i];
        vector explicitPart(Zero);
        if (semiImplicit_)
        {
            scalar mass =
                4.0/3.0*constant::mathematical::pi*pow3(particles_.radius[i])
               *particles_.density[i];
            if (forces_.hasAddedMass())
            {
                mass += rows_.addedMass[i];
            }
            const scalar x = K*D/mass;
            K *= powderlink::forces::relaxation_mean(x);
            relaxedDrag_[i] = K;
            explicitPart = K*particles_.velocity[i] - rows_.reactingForce[i];
        }
        const vector& J = particles_.impulse[i];
        impulse += J;
        magImpulse += mag(J);

        scalar* v = &values[nValues*i];
        v[0] = K;
        for (direction d = 0; d < 3; ++d)
        {
            v[1 + d] = explicitPart[d];
            v[4 + d] = -J[d];
        }
    }
    reduce(impulse, sumOp<vector>());
    reduce(magImpulse, sumOp<scalar>());
    // What came before the first exchange of a restart was counted then
    if (clock_.nExchanges() > 0)
    {
        toParticles_ += impulse;
        sumMagImpulse_ += magImpulse;
    }
    else if (isRestart_)
    {
        balanceAtStart_ -= impulse;
    }

    scalarField densities;
    voidFraction_->deposit(nValues, values, densities);

    if (!semiImplicit_)
    {
        scalarField drag(mesh_.nCells());
        forAll(drag, celli)
        {
            drag[celli] = densities[nValues*celli];
        }
        checkExplicit(drag);
    }

    // A first exchange without a run before has no interval to settle
    const bool settles = clock_.nExchanges() > 0 || isRestart_;
    forAll(Su_, celli)
    {
        const scalar* d = &densities[nValues*celli];
        if (settles)
        {
            balance_[celli] += vector(d[4], d[5], d[6])/rho;
        }
        Sp_[celli] = semiImplicit_ ? -d[0]/rho : 0;
        Su_[celli] =
            vector(d[1], d[2], d[3])/rho + balance_[celli]/D;
    }
}


void Foam::bridgeMomentum::checkExplicit
(
    const scalarField& dragPerVolume
) const
{
    // With the drag of the last interval U of the next one changes by this
    // factor times U: above 1 the error grows from interval to interval
    const scalar factor =
        clock_.interval()/properties_.rho
       *gMax((dragPerVolume/particleFluidFraction_.primitiveField())());

    if (factor > 1)
    {
        dictionaryChecks::badValue
        (
            dict_,
            "momentumExchange",
            "explicit, where the drag changes the fluid's velocity by "
          + Foam::name(factor) + " of itself within an interval",
            "explicit while that factor is at most 1",
            "set momentumExchange semiImplicit, or couple "
          + Foam::name(factor) + " times more often"
        );
    }
}


void Foam::bridgeMomentum::settle()
{
    const tmp<vectorField> tpath = voidFraction_->gather(path_);
    const vectorField& path = tpath();
    const scalar D = clock_.interval();

    vectorField given(particles_.position.size(), Zero);
    if (semiImplicit_)
    {
        forAll(given, i)
        {
            given[i] =
                relaxedDrag_[i]*(path[i] - D*particles_.velocity[i])
              + D*rows_.reactingForce[i];
        }
    }
    balance_.field() = voidFraction_->deposit(given)/properties_.rho;
}


void Foam::bridgeMomentum::reportMomentum() const
{
    const vector open =
        properties_.rho*gSum((balance_.field()*mesh_.V().field())());
    const vector wrong = toFluid_ + toParticles_ + open - balanceAtStart_;

    Info<< "momentum [N s]: fluid " << toFluid_
        << " particles " << toParticles_
        << " open " << open
        << " closure " << mag(wrong)/max(sumMagImpulse_, VSMALL) << endl;
}


void Foam::bridgeMomentum::sendValues()
{
    const label n = ownership_.nReceived();
    std::vector<bridge::ColumnView> columns;

    // Received rows, kept until they are sent
    std::vector<List<vector>> vectors(5);
    std::vector<List<scalar>> scalars(4);
    label nVectors = 0;
    label nScalars = 0;

    const auto addVector = [&](const UList<vector>& owned)
    {
        List<vector>& rows = vectors[nVectors++];
        ownership_.toReceiver(owned, rows, vector(Zero));
        columns.emplace_back(doubles(rows), std::size_t(n));
    };
    const auto addScalar = [&](const UList<scalar>& owned, const scalar outside)
    {
        List<scalar>& rows = scalars[nScalars++];
        ownership_.toReceiver(owned, rows, outside);
        columns.emplace_back
        (
            static_cast<const double*>(rows.cdata()), std::size_t(n)
        );
    };

    // In the order of offers()
    addVector(rows_.fluidVelocity);
    addScalar(rows_.fluidFraction, 1);
    addScalar(rows_.dragCoefficient, 0);
    addVector(rows_.reactingForce);
    addVector(rows_.pressureForce);
    if (forces_.hasTorque())
    {
        addVector(rows_.fluidSpin);
        addScalar(rows_.rotationalDrag, 0);
        addVector(rows_.fluidTorque);
    }
    if (forces_.hasAddedMass())
    {
        addScalar(rows_.addedMass, 0);
    }

    try
    {
        link_->send_values
        (
            {bridge::Command::go_on, isCheckpoint_, clock_.writesNext()},
            columns
        );
    }
    catch (const std::exception& e)
    {
        stop(e);
    }
    answerIsDue_ = false;
    timer_.lap(couplingTimer::exchange);
}


void Foam::bridgeMomentum::sayStop()
{
    if (isOver_)
    {
        return;
    }
    const bool isWritten = fieldsAreWritten();
    try
    {
        if (answerIsDue_)
        {
            link_->send_values({bridge::Command::stop, isCheckpoint_}, {});
        }
        else if (link_->receive_particles())
        {
            link_->send_values({bridge::Command::stop, isWritten}, {});
        }
    }
    catch (const std::exception& e)
    {
        stop(e);
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


void Foam::bridgeMomentum::stopForDisk(const string& file) const
{
    const std::string text =
        "checkpoint of the fluid; given: the disk did not take the whole file "
      + file + "; allowed: a folder that can be written to, on a disk with"
        " room; to do: make room, then go on from the last pair:"
        " powderlink restart CASE --prepare";
    link_->fail(text);
    FatalErrorInFunction << text.c_str() << exit(FatalError);
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
    dict_(coupling.particleMomentumDict()),
    twoWay_
    (
        !dict_.found("coupling")
     || dictionaryChecks::getWord(dict_, "coupling", {"twoWay", "oneWay"})
     == "twoWay"
    ),
    concurrent_
    (
        dict_.found("schedule")
     && dictionaryChecks::getWord(dict_, "schedule", {"staggered", "concurrent"})
     == "concurrent"
    ),
    semiImplicit_
    (
        !dict_.found("momentumExchange")
     || dictionaryChecks::getWord
        (
            dict_, "momentumExchange", {"semiImplicit", "explicit"}
        ) == "semiImplicit"
    ),
    minFluidFraction_(dict_.lookupOrDefault<scalar>("minFluidFraction", 0.2)),
    U_(mesh.lookupObject<volVectorField>("U")),
    p_(mesh.lookupObject<volScalarField>("p")),
    alphaf_(mesh.lookupObjectRef<volScalarField>("alphaf")),
    properties_(readProperties(coupling)),
    forces_(dict_, properties_),
    clock_(mesh.time(), coupling),
    locator_(mesh),
    ownership_(locator_),
    voidFraction_(voidFraction::New(locator_, dict_.subDict("voidFraction"))),
    interpolation_(fluidInterpolation::New(mesh, dict_)),
    particleFluidFraction_
    (
        IOobject("particleFluidFraction", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1.0),
        zeroGradientFvPatchScalarField::typeName
    ),
    alphafStart_(alphaf_.primitiveField()),
    balance_
    (
        IOobject
        (
            "momentumBalance",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedVector(dimVelocity, Zero)
    ),
    relaxedDrag_(),
    path_(mesh.nCells(), Zero),
    ddtU_(),
    isRestart_
    (
        IOobject("momentumBalance", mesh.time().timeName(), mesh)
       .typeHeaderOk<volVectorField::Internal>(true)
    ),
    answerIsDue_(false),
    isCheckpoint_(false),
    isOver_(false),
    timeOffset_(0),
    clocks_(mesh),
    toFluid_(Zero),
    toParticles_(Zero),
    balanceAtStart_
    (
        properties_.rho*gSum((balance_.field()*mesh.V().field())())
    ),
    sumMagImpulse_(0)
{
    wordList optional
    ({
        "coupling", "schedule", "momentumExchange", "minFluidFraction"
    });
    optional.append(bridgeLink::optionalEntries());
    optional.append(fluidForces::optionalEntries());
    dictionaryChecks::checkEntries(dict_, requiredEntries(), optional);

    if (!(minFluidFraction_ > 0 && minFluidFraction_ < 1))
    {
        dictionaryChecks::badValue
        (
            dict_,
            "minFluidFraction",
            Foam::name(minFluidFraction_),
            "above 0, below 1"
        );
    }

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

    namespace f = bridge::fields;
    try
    {
        link_ = bridgeLink::open
        (
            dict_,
            mesh.time().globalCaseName(),
            {
                f::id,
                f::position,
                f::velocity,
                f::spin,
                f::radius,
                f::density,
                f::reaction_impulse
            },
            offers(),
            clock_.interval(),
            clocks_.start(),
            rankMap(locator_)
        );
    }
    catch (const std::exception& e)
    {
        stop(e);
    }
    Info<< "Coupled with " << link_->peer().ranks << " rank(s) of "
        << link_->peer().role.c_str() << ", every " << clock_.interval()
        << " s, " << (twoWay_ ? "twoWay" : "oneWay") << ", "
        << (concurrent_ ? "concurrent" : "staggered") << ", "
        << (semiImplicit_ ? "semiImplicit" : "explicit") << nl << endl;
    // Both programs read their cases in that time
    timer_.lap(couplingTimer::wait);
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
    timer_.lap(couplingTimer::fluid);
    if (clock_.remaining() > 0)
    {
        return true;
    }

    bool goesOn = false;
    try
    {
        goesOn = link_->receive_particles();
    }
    catch (const std::exception& e)
    {
        stop(e);
    }
    timer_.lap(couplingTimer::wait);
    if (!goesOn)
    {
        isOver_ = true;
        Info<< "The program of the particles has finished at time "
            << mesh_.time().timeName() << " s: so does this one" << nl << endl;
        return false;
    }

    checkTime(link_->particles().time_s);
    takeParticles();
    timer_.lap(couplingTimer::search);

    voidFraction_->set
    (
        particles_.position, particles_.radius, ownership_.cells()
    );
    voidFraction_->checkFluidFraction(minFluidFraction_);
    particleFluidFraction_.primitiveFieldRef() =
        1 - voidFraction_->solidsFraction().field();
    particleFluidFraction_.correctBoundaryConditions();
    timer_.lap(couplingTimer::sharing);

    interpolation_->set(particles_.position, ownership_.cells());
    evaluateForces();
    timer_.lap(couplingTimer::forces);

    if (twoWay_)
    {
        if (clock_.nExchanges() == 0 && !isRestart_)
        {
            alphaf_ = particleFluidFraction_;
            alphaf_.oldTime() = alphaf_;
        }
        alphafStart_ = alphaf_.primitiveField();
        setSource();
        reportMomentum();
    }
    clock_.count();
    timer_.lap(couplingTimer::sharing);
    timer_.reportInterval();

    isCheckpoint_ = fieldsAreWritten();
    answerIsDue_ = true;
    if (concurrent_)
    {
        sendValues();
    }
    return true;
}


void Foam::bridgeMomentum::advanceFluidFraction()
{
    if (!twoWay_)
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
    const scalar dt = mesh_.time().deltaTValue();
    if (twoWay_)
    {
        const scalar rho = properties_.rho;
        vector given(Zero);
        forAll(Su_, celli)
        {
            const vector impulse =
                dt*(Su_[celli] + Sp_[celli]*U_[celli]);
            path_[celli] += dt*U_[celli];
            given += rho*mesh_.V()[celli]*impulse;
        }
        reduce(given, sumOp<vector>());
        toFluid_ += given;
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
    if (twoWay_)
    {
        settle();
        timer_.lap(couplingTimer::sharing);
    }
    if (answerIsDue_)
    {
        rows_.fluidVelocity = interpolation_->interpolate(U_);
        timer_.lap(couplingTimer::forces);
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


void Foam::bridgeMomentum::finish()
{
    timer_.lap(couplingTimer::fluid);
    sayStop();
    timer_.report();
}


// ************************************************************************* //
