// SPDX-License-Identifier: GPL-3.0-or-later

#include "bridgeValues.H"

#include "coupling/bridge/exchange/coupling_fields.h"

namespace bridge = powderlink::bridge;

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::bridgeValues::add(const UList<vector>& owned)
{
    // OpenFOAM's vectors are three doubles in a row, as in the exchange
    static_assert(sizeof(vector) == 3*sizeof(double), "vector");

    vectors_.emplace_back();
    List<vector>& rows = vectors_.back();
    ownership_.toReceiver(owned, rows, vector(Zero));
    columns_.emplace_back
    (
        reinterpret_cast<const double*>(rows.cdata()),
        std::size_t(rows.size())
    );
}


void Foam::bridgeValues::add(const UList<scalar>& owned, const scalar outside)
{
    scalars_.emplace_back();
    List<scalar>& rows = scalars_.back();
    ownership_.toReceiver(owned, rows, outside);
    columns_.emplace_back
    (
        static_cast<const double*>(rows.cdata()), std::size_t(rows.size())
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bridgeValues::bridgeValues
(
    const fluidForces& forces,
    const fluidForces::forceRows& rows,
    const particleOwnership& ownership
)
:
    ownership_(ownership)
{
    // In the order of offers()
    add(rows.fluidVelocity);
    add(rows.fluidFraction, 1);
    add(rows.dragCoefficient, 0);
    add(rows.reactingForce);
    add(rows.pressureForce);
    if (forces.hasTorque())
    {
        add(rows.fluidSpin);
        add(rows.rotationalDrag, 0);
        add(rows.fluidTorque);
    }
    if (forces.hasAddedMass())
    {
        add(rows.addedMass, 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<bridge::FieldSpec> Foam::bridgeValues::offers
(
    const fluidForces& forces
)
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
    if (forces.hasTorque())
    {
        specs.push_back(f::fluid_spin);
        specs.push_back(f::rotational_drag);
        specs.push_back(f::fluid_torque);
    }
    if (forces.hasAddedMass())
    {
        specs.push_back(f::added_mass);
    }
    return specs;
}


// ************************************************************************* //
