// SPDX-License-Identifier: GPL-3.0-or-later

#include "superficialInletVelocityFvPatchVectorField.H"
#include "dictionaryChecks.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField>
Foam::superficialInletVelocityFvPatchVectorField::interstitialVelocity() const
{
    const scalar t = db().time().timeOutputValue();

    tmp<vectorField> tU;
    if (velocity_.valid())
    {
        tU = tmp<vectorField>::New(patch().size(), velocity_->value(t));
    }
    else
    {
        tU = -flowRate_->value(t)/gSum(patch().magSf())*patch().nf();
    }
    if (db().foundObject<volScalarField>(alphafName_))
    {
        tU.ref() /=
            patch().lookupPatchField<volScalarField, scalar>(alphafName_);
    }
    return tU;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::superficialInletVelocityFvPatchVectorField::
superficialInletVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    flowRate_(),
    velocity_(),
    alphafName_("alphaf")
{}


Foam::superficialInletVelocityFvPatchVectorField::
superficialInletVelocityFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    flowRate_(),
    velocity_(),
    alphafName_(dict.getOrDefault<word>("alphaf", "alphaf"))
{
    const bool hasVelocity = dict.found("superficialVelocity");
    const bool hasFlowRate = dict.found("volumetricFlowRate");
    if (hasVelocity == hasFlowRate)
    {
        dictionaryChecks::badValue
        (
            dict,
            "superficialVelocity",
            hasVelocity
          ? "superficialVelocity and volumetricFlowRate"
          : "neither superficialVelocity nor volumetricFlowRate",
            "one of them, a constant or a function of time",
            "keep or add one: superficialVelocity (0 0 0.1); in m/s, or"
            " volumetricFlowRate 1e-6; in m3/s"
        );
    }
    if (hasVelocity)
    {
        velocity_ = Function1<vector>::New("superficialVelocity", dict);
    }
    else
    {
        flowRate_ = Function1<scalar>::New("volumetricFlowRate", dict);
    }

    if (dict.found("value"))
    {
        fvPatchVectorField::operator=(vectorField("value", dict, p.size()));
    }
    else
    {
        fvPatchVectorField::operator=(interstitialVelocity());
    }
}


Foam::superficialInletVelocityFvPatchVectorField::
superficialInletVelocityFvPatchVectorField
(
    const superficialInletVelocityFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper),
    flowRate_(ptf.flowRate_.clone()),
    velocity_(ptf.velocity_.clone()),
    alphafName_(ptf.alphafName_)
{}


Foam::superficialInletVelocityFvPatchVectorField::
superficialInletVelocityFvPatchVectorField
(
    const superficialInletVelocityFvPatchVectorField& ptf
)
:
    fixedValueFvPatchVectorField(ptf),
    flowRate_(ptf.flowRate_.clone()),
    velocity_(ptf.velocity_.clone()),
    alphafName_(ptf.alphafName_)
{}


Foam::superficialInletVelocityFvPatchVectorField::
superficialInletVelocityFvPatchVectorField
(
    const superficialInletVelocityFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF),
    flowRate_(ptf.flowRate_.clone()),
    velocity_(ptf.velocity_.clone()),
    alphafName_(ptf.alphafName_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::superficialInletVelocityFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }
    operator==(interstitialVelocity());
    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::superficialInletVelocityFvPatchVectorField::write(Ostream& os) const
{
    fvPatchVectorField::write(os);
    if (flowRate_.valid())
    {
        flowRate_->writeData(os);
    }
    if (velocity_.valid())
    {
        velocity_->writeData(os);
    }
    os.writeEntryIfDifferent<word>("alphaf", "alphaf", alphafName_);
    writeEntry("value", os);
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    makePatchTypeField
    (
        fvPatchVectorField,
        superficialInletVelocityFvPatchVectorField
    );
}


// ************************************************************************* //
