// SPDX-License-Identifier: GPL-3.0-or-later

#include "momentumAccount.H"
#include "dictionaryChecks.H"

#include "physics/fluid_forces/semi_implicit_step.h"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::momentumAccount::open() const
{
    return
        settings_.fluid.rho*gSum((balance_.field()*mesh_.V().field())());
}


void Foam::momentumAccount::countImpulses()
{
    vector impulse(Zero);
    scalar magImpulse = 0;
    for (const vector& J : particles_.impulse())
    {
        impulse += J;
        magImpulse += mag(J);
    }
    for (const bridgeParticles::strayImpulse& stray : particles_.strays())
    {
        impulse += stray.impulse;
        magImpulse += mag(stray.impulse);
    }
    reduce(impulse, sumOp<vector>());
    reduce(magImpulse, sumOp<scalar>());

    // What came before the first exchange of a restart was counted then
    if (clock_.nExchanges() > 0)
    {
        toParticles_ += impulse;
        scale_ += magImpulse;
    }
    else if (isRestart_)
    {
        balanceAtStart_ -= impulse;
        scale_ += magImpulse;
    }
}


void Foam::momentumAccount::checkExplicit
(
    const scalarField& dragPerVolume
) const
{
    // With the drag of the last interval U of the next one changes by this
    // factor times U: above 1 the error grows from interval to interval
    const scalar factor =
        clock_.interval()/settings_.fluid.rho
       *gMax
        (
            (dragPerVolume/(1 - voidFraction_.solidsFraction().field()))()
        );

    if (factor > 1)
    {
        dictionaryChecks::badValue
        (
            settings_.dict,
            "momentumExchange",
            "explicit, where the drag changes the fluid's velocity by "
          + Foam::name(factor) + " of itself within an interval",
            "explicit while that factor is at most 1",
            "set momentumExchange semiImplicit, or couple "
          + Foam::name(factor) + " times more often"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentumAccount::momentumAccount
(
    const bridgeSettings& settings,
    const exchangeClock& clock,
    const bridgeParticles& particles,
    const voidFraction& voidFraction
)
:
    mesh_(particles.locator().mesh()),
    settings_(settings),
    clock_(clock),
    particles_(particles),
    voidFraction_(voidFraction),
    balance_
    (
        IOobject
        (
            "momentumBalance",
            mesh_.time().timeName(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedVector(dimVelocity, Zero)
    ),
    isRestart_
    (
        IOobject("momentumBalance", mesh_.time().timeName(), mesh_)
       .typeHeaderOk<volVectorField::Internal>(true)
    ),
    path_(mesh_.nCells(), Zero),
    toFluid_(Zero),
    toParticles_(Zero),
    balanceAtStart_(open()),
    scale_
    (
        settings_.fluid.rho
       *gSum((mag(balance_.field())*mesh_.V().field())())
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::momentumAccount::startInterval
(
    const fluidForces::forceRows& rows,
    volVectorField::Internal& Su,
    volScalarField::Internal& Sp
)
{
    const scalar D = clock_.interval();
    const scalar rho = settings_.fluid.rho;
    const label n = particles_.size();

    countImpulses();
    path_ = Zero;

    // Per particle: K' (explicit: K), K' v - F, -J
    constexpr label nValues = 7;
    scalarField values(nValues*n, Zero);
    relaxedDrag_.setSize(n);
    relaxedDrag_ = 0;
    explicitForce_.setSize(n);
    explicitForce_ = Zero;
    for (label i = 0; i < n; ++i)
    {
        scalar K = rows.dragCoefficient[i];
        vector explicitPart(Zero);
        if (settings_.semiImplicit)
        {
            scalar share = 1;
            if (!particles_.held(i))
            {
                const scalar mass =
                    4.0/3.0*constant::mathematical::pi
                   *pow3(particles_.radius()[i])*particles_.density()[i];
                const scalar addedMass =
                    rows.addedMass.size() ? rows.addedMass[i] : 0;
                share = mass/(mass + addedMass);
                const scalar x = K*D/(mass + addedMass);
                K *= share*powderlink::forces::relaxation_mean(x);
            }
            relaxedDrag_[i] = K;
            explicitForce_[i] =
                share*rows.reactingForce[i] - (1 - share)*rows.pressureForce[i];
            explicitPart = K*particles_.velocity()[i] - explicitForce_[i];
        }
        const vector& J = particles_.impulse()[i];

        scalar* v = &values[nValues*i];
        v[0] = K;
        for (direction d = 0; d < 3; ++d)
        {
            v[1 + d] = explicitPart[d];
            v[4 + d] = -J[d];
        }
    }

    scalarField placed;
    voidFraction_.place(nValues, values, placed);

    // Per volume of cell: K', K' v - F + B/D
    constexpr label nSources = 4;
    scalarField sources(nSources*mesh_.nCells());

    // A first exchange without a run before has no interval to settle
    const bool settles = clock_.nExchanges() > 0 || isRestart_;
    if (settles)
    {
        for (const bridgeParticles::strayImpulse& stray : particles_.strays())
        {
            balance_[stray.cell] -= stray.impulse/(rho*mesh_.V()[stray.cell]);
        }
    }
    forAll(balance_, celli)
    {
        const scalar* d = &placed[nValues*celli];
        if (settles)
        {
            balance_[celli] += vector(d[4], d[5], d[6])/rho;
        }
        scalar* s = &sources[nSources*celli];
        s[0] = d[0];
        for (direction k = 0; k < 3; ++k)
        {
            s[1 + k] = d[1 + k] + rho*balance_[celli][k]/D;
        }
    }
    voidFraction_.smooth(nSources, sources);

    if (!settings_.semiImplicit)
    {
        scalarField drag(mesh_.nCells());
        forAll(drag, celli)
        {
            drag[celli] = sources[nSources*celli];
        }
        checkExplicit(drag);
    }

    forAll(Su, celli)
    {
        const scalar* s = &sources[nSources*celli];
        Sp[celli] = settings_.semiImplicit ? -s[0]/rho : 0;
        Su[celli] = vector(s[1], s[2], s[3])/rho;
    }
}


void Foam::momentumAccount::addStep
(
    const scalar dt,
    const volVectorField& U,
    const volVectorField::Internal& Su,
    const volScalarField::Internal& Sp
)
{
    const scalar rho = settings_.fluid.rho;
    vector given(Zero);
    forAll(Su, celli)
    {
        const vector impulse = dt*(Su[celli] + Sp[celli]*U[celli]);
        path_[celli] += dt*U[celli];
        given += rho*mesh_.V()[celli]*impulse;
    }
    reduce(given, sumOp<vector>());
    toFluid_ += given;
}


void Foam::momentumAccount::endInterval()
{
    const tmp<vectorField> tpath = voidFraction_.gather(path_);
    const vectorField& path = tpath();
    const scalar D = clock_.interval();

    constexpr label nValues = vector::nComponents;
    scalarField given(nValues*particles_.size(), Zero);
    if (settings_.semiImplicit)
    {
        forAll(path, i)
        {
            const vector I =
                relaxedDrag_[i]*(path[i] - D*particles_.velocity()[i])
              + D*explicitForce_[i];
            for (direction d = 0; d < nValues; ++d)
            {
                given[nValues*i + d] = I[d];
            }
        }
    }
    // Smoothed together with the impulses, at the next exchange
    scalarField densities;
    voidFraction_.place(nValues, given, densities);
    forAll(balance_, celli)
    {
        const scalar* d = &densities[nValues*celli];
        balance_[celli] = vector(d[0], d[1], d[2])/settings_.fluid.rho;
    }
}


void Foam::momentumAccount::report() const
{
    const vector stillOpen = open();
    const vector wrong =
        toFluid_ + toParticles_ + stillOpen - balanceAtStart_;

    Info<< "momentum [N s]: fluid " << toFluid_
        << " particles " << toParticles_
        << " open " << stillOpen
        << " closure " << mag(wrong)/max(scale_, VSMALL) << endl;
}


// ************************************************************************* //
