// SPDX-License-Identifier: GPL-3.0-or-later

#include "fluidScalarTransport.H"
#include "addToRunTimeSelectionTable.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "surfaceInterpolate.H"
#include "turbulentTransportModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(fluidScalarTransport, 0);
    addToRunTimeSelectionTable
    (
        functionObject,
        fluidScalarTransport,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::functionObjects::fluidScalarTransport::diffusivity() const
{
    const word name("D" + fieldName_);
    if (D_ >= 0)
    {
        return tmp<volScalarField>::New
        (
            IOobject
            (
                name,
                time_.timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh_,
            dimensionedScalar(name, dimViscosity, D_)
        );
    }
    const auto& turbulence =
        mesh_.lookupObject<incompressible::turbulenceModel>
        (
            turbulenceModel::propertiesName
        );
    return tmp<volScalarField>::New
    (
        name, alphaD_*turbulence.nu() + alphaDt_*turbulence.nut()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::fluidScalarTransport::fluidScalarTransport
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    fieldName_(dict.getOrDefault<word>("field", "T")),
    D_(-1),
    alphaD_(1),
    alphaDt_(1),
    nCorr_(0),
    options_(mesh_),
    T_
    (
        new volScalarField
        (
            IOobject
            (
                fieldName_,
                runTime.timeName(),
                mesh_,
                IOobject::MUST_READ,
                IOobject::AUTO_WRITE
            ),
            mesh_
        )
    )
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::fluidScalarTransport::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    dict.readIfPresent("D", D_);
    dict.readIfPresent("alphaD", alphaD_);
    dict.readIfPresent("alphaDt", alphaDt_);
    dict.readIfPresent("nCorr", nCorr_);
    if (dict.found("fvOptions"))
    {
        options_.reset(dict.subDict("fvOptions"));
    }
    return true;
}


bool Foam::functionObjects::fluidScalarTransport::execute()
{
    const auto& alphaf = mesh_.lookupObject<volScalarField>("alphaf");
    const auto& alphaPhi = mesh_.lookupObject<surfaceScalarField>("alphaPhi");
    volScalarField& T = T_();

    const surfaceScalarField alphafD
    (
        fvc::interpolate(alphaf*diffusivity())
    );
    scalar relaxation = 0;
    if (mesh_.relaxEquation(fieldName_))
    {
        relaxation = mesh_.equationRelaxationFactor(fieldName_);
    }
    for (label i = 0; i <= nCorr_; ++i)
    {
        fvScalarMatrix TEqn
        (
            fvm::ddt(alphaf, T)
          + fvm::div(alphaPhi, T, "div(phi," + fieldName_ + ")")
          - fvm::laplacian(alphafD, T, "laplacian(D," + fieldName_ + ")")
         ==
            options_(T)
        );
        TEqn.relax(relaxation);
        options_.constrain(TEqn);
        TEqn.solve(mesh_.solverDict(fieldName_));
        options_.correct(T);
    }
    return true;
}


bool Foam::functionObjects::fluidScalarTransport::write()
{
    // With the other fields the one of the step before was written
    return !time_.writeTime() || T_->write();
}


// ************************************************************************* //
