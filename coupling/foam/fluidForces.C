// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidForces.H"
#include "dictionaryChecks.H"
#include "fvcGrad.H"
#include "viscousStress.H"

#include "physics/fluid_forces/force_registry.h"

namespace forces = powderlink::forces;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    inline forces::Vec3 toVec3(const Foam::vector& v)
    {
        return {v.x(), v.y(), v.z()};
    }

    inline Foam::vector toVector(const forces::Vec3& v)
    {
        return Foam::vector(v[0], v[1], v[2]);
    }

    Foam::wordList known()
    {
        Foam::wordList names;
        for (const forces::ForceEntry& entry : forces::force_registry())
        {
            names.append(entry.info->name);
        }
        return names;
    }

    Foam::string listOfKnown()
    {
        Foam::OStringStream text;
        text << Foam::flatOutput(known());
        return text.str();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fluidForces::need(const std::string& field)
{
    if (field == "pressure_gradient_Pa_m")
    {
        needsPressureGradient_ = true;
    }
    else if (field == "viscous_stress_divergence_N_m3")
    {
        needsViscousStress_ = true;
    }
    else if (field == "velocity_curl_1_s")
    {
        needsCurl_ = true;
    }
    else if (field == "acceleration_m_s2")
    {
        needsAcceleration_ = true;
    }
    else if (field != "gravity_m_s2")
    {
        FatalErrorInFunction
            << "a force law looks at a field of the fluid that is not made"
            << nl
            << "    given:   " << field << nl
            << "    allowed: pressure_gradient_Pa_m,"
            << " viscous_stress_divergence_N_m3, velocity_curl_1_s,"
            << " acceleration_m_s2, gravity_m_s2" << nl
            << "    to do:   make it in fluidForces::interpolate" << nl
            << abort(FatalError);
    }
}


Foam::scalar Foam::fluidForces::readSphericity(const dictionary& dict)
{
    const string allowed("above 0, at most 1: a sphere");
    const scalar sphericity =
        dictionaryChecks::getOrDefault<scalar>(dict, "sphericity", 1, allowed);
    if (!(sphericity > 0 && sphericity <= 1))
    {
        dictionaryChecks::badValue
        (
            dict,
            "sphericity",
            Foam::name(sphericity),
            allowed
        );
    }
    return sphericity;
}


void Foam::fluidForces::readLaws(const dictionary& dict)
{
    const wordList valid(known());
    forces::ForceSettings settings;
    settings.model =
        properties_.modelA
      ? forces::MomentumModel::A
      : forces::MomentumModel::B;
    settings.weight_in_dem = true;
    settings.virtual_mass_coefficient =
        dictionaryChecks::getOrDefault<scalar>
        (
            dict, "virtualMassCoefficient", 0.5, "a number, 0.5: a sphere"
        );


    word drag;
    wordHashSet names;
    for (const word& name : chosen(dict))
    {
        if (!valid.found(name))
        {
            dictionaryChecks::badValue(dict, "forces", name, listOfKnown());
        }
        if (!names.insert(name))
        {
            dictionaryChecks::badValue
            (
                dict,
                "forces",
                name + " more than once",
                "every force once",
                "remove one of them"
            );
        }

        const forces::ForceEntry& entry = forces::find_force(name);
        if (entry.info->kind == forces::ForceKind::drag)
        {
            if (!drag.empty())
            {
                dictionaryChecks::badValue
                (
                    dict,
                    "forces",
                    drag + " and " + name,
                    "one drag law or none",
                    "keep one of them"
                );
            }
            drag = name;
        }

        try
        {
            laws_.push_back
            (
                {entry.make(settings), entry.info->reacts_on_fluid}
            );
        }
        catch (const powderlink::InvalidInput& error)
        {
            FatalIOErrorInFunction(dict)
                << error.what() << nl << exit(FatalIOError);
        }
        for (const std::string& field : entry.info->fields)
        {
            need(field);
        }
        hasTorque_ |= entry.info->kind == forces::ForceKind::rotation;
        hasAddedMass_ |= entry.info->kind == forces::ForceKind::inertia;
    }

    if (properties_.modelA && !(needsPressureGradient_ && needsViscousStress_))
    {
        Info<< "Warning: model A shares pressure gradient and viscous stress"
            << " with the particles, but not both pressure_gradient and"
            << " viscous_stress are among the forces: what is missing acts on"
            << " nothing" << endl;
    }
    if (!properties_.modelA && (needsPressureGradient_ || needsViscousStress_))
    {
        Info<< "Warning: pressure_gradient and viscous_stress are zero in"
            << " model B, whose drag has their share" << endl;
    }

    // In B these forces are zero whatever the fields are
    needsPressureGradient_ = needsPressureGradient_ && properties_.modelA;
    needsViscousStress_ = needsViscousStress_ && properties_.modelA;

    // The DEM is given the spin of the fluid
    needsCurl_ = needsCurl_ || hasTorque_;

    Info<< "Forces on particles: "
        << flatOutput(chosen(dict))
        << (drag.empty() ? ", no drag" : "") << endl;
}


void Foam::fluidForces::resize(const label n, forceRows& rows) const
{
    rows.dragCoefficient.setSize(n);
    rows.reactingForce.setSize(n);
    rows.pressureForce.setSize(n);

    const label nTorque = hasTorque_ ? n : 0;
    rows.fluidSpin.setSize(nTorque);
    rows.rotationalDrag.setSize(nTorque);
    rows.fluidTorque.setSize(nTorque);
    rows.addedMass.setSize(hasAddedMass_ ? n : 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidForces::fluidForces
(
    const dictionary& dict,
    const fluidProperties& properties
)
:
    properties_(properties),
    sphericity_(readSphericity(dict)),
    needsPressureGradient_(false),
    needsViscousStress_(false),
    needsCurl_(false),
    needsAcceleration_(false),
    hasTorque_(false),
    hasAddedMass_(false)
{
    readLaws(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fluidForces::chosen(const dictionary& dict)
{
    return dictionaryChecks::get<wordList>
    (
        dict,
        "forces",
        "names in brackets, as in (gidaspow pressure_gradient), of "
      + listOfKnown()
    );
}


Foam::fluidForces::fluidRows Foam::fluidForces::interpolate
(
    const fluidFields& fluid,
    const fluidInterpolation& interpolation,
    const scalar minFluidFraction
) const
{
    const volVectorField& U = fluid.U;

    fluidRows rows;
    rows.velocity = interpolation.interpolate(U);
    rows.fraction = max
    (
        minFluidFraction,
        min(scalar(1), interpolation.interpolate(fluid.alphaf))
    );
    if (needsPressureGradient_)
    {
        rows.pressureGradient =
            properties_.rho
           *(interpolation.interpolate(fvc::grad(fluid.p)()) - fluid.drive);
    }

    tmp<volTensorField> tgradU;
    if (needsVelocityGradient())
    {
        tgradU = fvc::grad(U);
    }
    if (needsViscousStress_)
    {
        rows.stressDivergence =
            properties_.rho
           *interpolation.interpolate
            (
                viscousStress::divergence(U, tgradU(), *fluid.nuEff)()
            );
    }
    if (needsCurl_)
    {
        rows.curl = interpolation.interpolate
        (
            volVectorField("curlU", 2*(*skew(tgradU())))
        );
    }
    if (needsAcceleration_)
    {
        rows.acceleration = interpolation.interpolate
        (
            volVectorField("DUDt", *fluid.ddtU + (U & tgradU()))
        );
    }
    return rows;
}


void Foam::fluidForces::evaluate
(
    const fluidRows& fluid,
    const particleRows& particles,
    forceRows& rows
) const
{
    rows.fluidVelocity = fluid.velocity;
    rows.fluidFraction = fluid.fraction;
    const label n = rows.fluidVelocity.size();
    resize(n, rows);

    forces::FluidState f;
    f.density_kg_m3 = properties_.rho;
    f.kinematic_viscosity_m2_s = properties_.nu;
    f.gravity_m_s2 = toVec3(properties_.g);
    forces::ParticleState p;
    p.sphericity = sphericity_;

    for (label i = 0; i < n; ++i)
    {
        f.velocity_m_s = toVec3(fluid.velocity[i]);
        f.fluid_fraction = fluid.fraction[i];
        if (needsPressureGradient_)
        {
            f.pressure_gradient_Pa_m = toVec3(fluid.pressureGradient[i]);
        }
        if (needsViscousStress_)
        {
            f.viscous_stress_divergence_N_m3 = toVec3(fluid.stressDivergence[i]);
        }
        if (needsCurl_)
        {
            f.velocity_curl_1_s = toVec3(fluid.curl[i]);
        }
        if (needsAcceleration_)
        {
            f.acceleration_m_s2 = toVec3(fluid.acceleration[i]);
        }
        p.velocity_m_s = toVec3(particles.velocity[i]);
        p.spin_rad_s = toVec3(particles.spin[i]);
        p.diameter_m = 2*particles.radius[i];
        p.density_kg_m3 = particles.density[i];

        forces::ForceTerms all;
        forces::Vec3 reacting{};
        forces::Vec3 pressure{};
        try
        {
            forces::require_valid(f, p);
            for (const law& l : laws_)
            {
                const forces::ForceTerms terms = l.force->evaluate_valid(f, p);
                all += terms;
                forces::Vec3& part = l.reactsOnFluid ? reacting : pressure;
                part = forces::sum(part, terms.force_N);
            }
        }
        catch (const powderlink::InvalidInput& error)
        {
            FatalErrorInFunction
                << error.what() << nl
                << "    of the particle in row " << i << " of rank "
                << Pstream::myProcNo() << ": diameter " << p.diameter_m
                << " m, velocity " << particles.velocity[i]
                << " m/s, fluid velocity " << rows.fluidVelocity[i] << " m/s"
                << nl << exit(FatalError);
        }

        rows.dragCoefficient[i] = all.drag_kg_s;
        rows.reactingForce[i] = toVector(reacting);
        rows.pressureForce[i] = toVector(pressure);
        if (hasTorque_)
        {
            rows.fluidSpin[i] = 0.5*fluid.curl[i];
            rows.rotationalDrag[i] = all.rotational_drag_Nms;
            rows.fluidTorque[i] = toVector(all.torque_Nm);
        }
        if (hasAddedMass_)
        {
            rows.addedMass[i] = all.added_mass_kg;
        }
    }
}


// ************************************************************************* //
