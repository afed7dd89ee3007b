// SPDX-License-Identifier: GPL-3.0-or-later

#include "superficialVelocityForce.H"
#include "couplingProperties.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(superficialVelocityForce, 0);
    addToRunTimeSelectionTable(option, superficialVelocityForce, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::fv::superficialVelocityForce::stateObject() const
{
    return IOobject
    (
        name_ + "Properties",
        mesh_.time().timeName(),
        "uniform",
        mesh_,
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::fv::superficialVelocityForce::writeState() const
{
    IOobject io(stateObject());
    io.readOpt() = IOobject::NO_READ;
    IOdictionary state(io);
    state.add("gradient", gradient_ + change_);

    // A run that goes on must not lose digits
    constexpr unsigned int allDigits = 17;
    const unsigned int usual = IOstream::defaultPrecision(allDigits);
    state.regIOobject::write();
    IOstream::defaultPrecision(usual);
}


Foam::vector Foam::fv::superficialVelocityForce::directionAhead() const
{
    const Time& time = mesh_.time();
    constexpr label looks = 1000;
    const scalar step =
        max(time.endTime().value() - time.value(), scalar(0))/looks;
    for (label look = 0; look <= looks; ++look)
    {
        const vector w(velocity_->value(time.value() + look*step));
        if (mag(w) > VSMALL)
        {
            return w/mag(w);
        }
    }
    return Zero;
}


Foam::scalar Foam::fv::superficialVelocityForce::target()
{
    const vector w(velocity_->value(mesh_.time().value()));
    if (mag(w) > VSMALL)
    {
        direction_ = w/mag(w);
    }
    return w & direction_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::superficialVelocityForce::superficialVelocityForce
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    velocity_(),
    relaxation_(1),
    pressureShared_(couplingProperties::isPressureShared(mesh)),
    direction_(Zero),
    gradient_(0),
    change_(0),
    response_()
{
    read(dict);
    target();
    fieldNames_ = wordList(1, coeffs_.getOrDefault<word>("U", "U"));
    applied_.setSize(1, false);

    const IOdictionary state(stateObject());
    state.readIfPresent("gradient", gradient_);
    Info<< "    superficial velocity "
        << velocity_->value(mesh_.time().value())
        << " m/s, pressure gradient " << gradient_ << " m/s2" << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::superficialVelocityForce::addSup
(
    fvMatrix<vector>& eqn,
    const label
)
{
    eqn +=
        DimensionedField<vector, volMesh>
        (
            IOobject
            (
                name_ + "Su",
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh_,
            dimensionedVector
            (
                name_,
                eqn.dimensions()/dimVolume,
                direction_*(gradient_ + change_)
            )
        );
}


void Foam::fv::superficialVelocityForce::constrain
(
    fvMatrix<vector>& eqn,
    const label
)
{
    response_.reset(new scalarField(1.0/eqn.A()().primitiveField()));
    if (pressureShared_)
    {
        *response_ *=
            mesh_.lookupObject<volScalarField>("alphaf").primitiveField();
    }
    gradient_ += change_;
    change_ = 0;
}


void Foam::fv::superficialVelocityForce::correct(volVectorField& U)
{
    const scalarField& alphaf =
        mesh_.lookupObject<volScalarField>("alphaf").primitiveField();
    const scalarField& V = mesh_.V().field();
    const scalarField& response = *response_;

    const scalar wanted = target();
    scalar flow = 0;
    scalar gain = 0;
    forAll(V, celli)
    {
        flow += alphaf[celli]*V[celli]*(U[celli] & direction_);
        gain += alphaf[celli]*V[celli]*response[celli];
    }
    const scalar volume = gSum(V);
    reduce(flow, sumOp<scalar>());
    reduce(gain, sumOp<scalar>());

    change_ = relaxation_*(wanted*volume - flow)/gain;
    U.primitiveFieldRef() += response*change_*direction_;
    U.correctBoundaryConditions();

    Info<< "Superficial velocity: uncorrected " << flow/volume
        << " m/s, pressure gradient " << gradient_ + change_ << " m/s2"
        << endl;

    if (mesh_.time().writeTime())
    {
        writeState();
    }
}


bool Foam::fv::superficialVelocityForce::read(const dictionary& dict)
{
    if (!option::read(dict))
    {
        return false;
    }
    const string velocities
    (
        "a vector [m/s] that is not zero, or a function of time"
    );
    if (!coeffs_.found("superficialVelocity"))
    {
        dictionaryChecks::badValue
        (
            coeffs_,
            "superficialVelocity",
            "missing",
            velocities,
            "add superficialVelocity (0 0 0.1);"
        );
    }
    velocity_ = Function1<vector>::New("superficialVelocity", coeffs_);
    direction_ = directionAhead();
    if (direction_ == vector::zero)
    {
        dictionaryChecks::badValue
        (
            coeffs_, "superficialVelocity", "zero until endTime", velocities
        );
    }
    const string shares("above 0, at most 1");
    relaxation_ = dictionaryChecks::getOrDefault<scalar>
    (
        coeffs_, "relaxation", 1, shares
    );
    if (!(relaxation_ > 0 && relaxation_ <= 1))
    {
        dictionaryChecks::badValue
        (
            coeffs_, "relaxation", Foam::name(relaxation_), shares
        );
    }
    return true;
}


// ************************************************************************* //
