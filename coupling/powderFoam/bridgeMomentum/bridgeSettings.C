// SPDX-License-Identifier: GPL-3.0-or-later

#include "bridgeSettings.H"
#include "bridgeLink.H"
#include "dictionaryChecks.H"
#include "particleFields.H"
#include "writtenFiles.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fluidForces::fluidProperties Foam::bridgeSettings::readFluid
(
    const fvMesh& mesh,
    const couplingProperties& coupling
)
{
    const auto& transport =
        mesh.lookupObject<IOdictionary>("transportProperties");

    for (const word name : {"rho", "nu"})
    {
        if (!transport.found(name))
        {
            dictionaryChecks::badValue
            (
                transport,
                name,
                "missing",
                "density rho [kg/m3]"
                " and kinematic viscosity nu [m2/s] of the fluid",
                "add them: forces on particles need them"
            );
        }
    }

    const word viscosity
    (
        transport.getOrDefault<word>("transportModel", "Newtonian")
    );
    if (viscosity != "Newtonian")
    {
        dictionaryChecks::badValue
        (
            transport,
            "transportModel",
            viscosity,
            "Newtonian: the laws of the forces on particles have one viscosity",
            "set transportModel Newtonian, or run without particles"
        );
    }

    const uniformDimensionedVectorField g
    (
        IOobject
        (
            "g",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        dimensionedVector(dimAcceleration, Zero)
    );

    fluidForces::fluidProperties properties;
    properties.rho = dimensionedScalar("rho", dimDensity, transport).value();
    properties.nu =
        dimensionedScalar("nu", dimViscosity, transport).value();
    properties.g = g.value();
    properties.modelA = coupling.pressureShared();
    return properties;
}


bool Foam::bridgeSettings::differs
(
    const dictionary& dict,
    const word& keyword,
    const word& usual,
    const word& other
)
{
    return
        dict.found(keyword)
     && dictionaryChecks::getWord(dict, keyword, {usual, other}) == other;
}


const Foam::dictionary& Foam::bridgeSettings::checkedEntries
(
    const dictionary& dict
)
{
    wordList optional
    ({
        "coupling", "schedule", "momentumExchange", "minFluidFraction"
    });
    optional.append(bridgeLink::optionalEntries());
    optional.append(fluidForces::optionalEntries());
    optional.append(particleFields::optionalEntries());
    dictionaryChecks::checkEntries
    (
        dict,
        {"type", "transport", "voidFraction", "interpolation", "forces"},
        optional
    );
    return dict;
}


void Foam::bridgeSettings::check() const
{
    writtenFiles::refuseCollated();

    if (!(minFluidFraction > 0 && minFluidFraction < 1))
    {
        dictionaryChecks::badValue
        (
            dict,
            "minFluidFraction",
            Foam::name(minFluidFraction),
            "above 0, below 1"
        );
    }

    const bool buoyant = fluidForces::chosen(dict).found("buoyancy");
    if (!buoyant && mag(fluid.g) > VSMALL)
    {
        Info<< "Warning: gravity of constant/g" << nl
            << "    given:   " << fluid.g << " m/s2, and no buoyancy among the"
            << " forces" << nl
            << "    allowed: yes: p is without the fluid's weight, that of the"
            << " particles is fix gravity in LIGGGHTS" << nl
            << "    to do:   add buoyancy to forces where the fluid's weight"
            << " matters to particles" << nl << endl;
    }

    if (buoyant && mag(fluid.g) < VSMALL)
    {
        dictionaryChecks::badValue
        (
            dict,
            "forces",
            "buoyancy, and no gravity",
            "buoyancy with constant/g",
            "write constant/g, or remove buoyancy"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bridgeSettings::bridgeSettings
(
    const fvMesh& mesh,
    const couplingProperties& coupling
)
:
    dict(checkedEntries(coupling.particleMomentumDict())),
    twoWay(!differs(dict, "coupling", "twoWay", "oneWay")),
    concurrent(differs(dict, "schedule", "staggered", "concurrent")),
    semiImplicit
    (
        !differs(dict, "momentumExchange", "semiImplicit", "explicit")
    ),
    minFluidFraction
    (
        dictionaryChecks::getOrDefault<scalar>
        (
            dict, "minFluidFraction", 0.2, "above 0, below 1"
        )
    ),
    fluid(readFluid(mesh, coupling))
{
    check();
}


// ************************************************************************* //
