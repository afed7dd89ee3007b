// SPDX-License-Identifier: GPL-3.0-or-later

#include "alphafTurbulenceModel.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    //- The base keeps a reference
    const Foam::geometricOneField ones;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::alphafTurbulenceModel::alphafTurbulenceModel
(
    const word& type,
    const volScalarField& alpha,
    const geometricOneField& rho,
    const volVectorField& U,
    const surfaceScalarField& alphaRhoPhi,
    const surfaceScalarField& phi,
    const transportModel& transport,
    const word& propertiesName
)
:
    incompressible::turbulenceModel
    (
        type, ones, rho, U, alphaRhoPhi, phi, transport, propertiesName
    ),
    alpha_(alpha)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::alphafTurbulenceModel> Foam::alphafTurbulenceModel::New
(
    const volScalarField& alphaf,
    const volVectorField& U,
    const surfaceScalarField& alphaPhi,
    const surfaceScalarField& phi,
    const transportModel& transport
)
{
    const word propertiesName(turbulenceModel::propertiesName);
    const IOdictionary dict
    (
        IOobject
        (
            propertiesName,
            U.time().constant(),
            U.db(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const word simulationType
    (
        dictionaryChecks::getWord
        (
            dict, "simulationType", {"laminar", "RAS", "LES"}
        )
    );
    Info<< "Selecting turbulence model type " << simulationType << endl;

    // The cases differ in type, the pointer does not
    const auto select = [&](auto newModel)
    {
        return autoPtr<alphafTurbulenceModel>
        (
            newModel
            (
                alphaf, ones, U, alphaPhi, phi, transport, propertiesName
            ).ptr()
        );
    };
    if (simulationType == "RAS")
    {
        return select(RASModel<alphafTurbulenceModel>::New);
    }
    if (simulationType == "LES")
    {
        return select(LESModel<alphafTurbulenceModel>::New);
    }
    return select(laminarModel<alphafTurbulenceModel>::New);
}


// ************************************************************************* //
