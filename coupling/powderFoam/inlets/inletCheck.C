// SPDX-License-Identifier: GPL-3.0-or-later

#include "inletCheck.H"
#include "superficialInletVelocityFvPatchVectorField.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::inletCheck::inletCheck(const volVectorField& U)
:
    U_(U),
    patches_()
{
    DynamicList<label> patches;
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Up = U.boundaryField()[patchi];
        // By pressure: the velocity follows from the flux
        if
        (
            Up.fixesValue()
         && !Up.coupled()
         && !isA<wallFvPatch>(Up.patch())
         && !isA<superficialInletVelocityFvPatchVectorField>(Up)
         && Up.type() != "interstitialInletVelocity"
         && Up.type().find("pressure") != 0
        )
        {
            patches.append(patchi);
        }
    }
    patches_.transfer(patches);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::inletCheck::check
(
    const surfaceScalarField& phi,
    const surfaceScalarField& alphaPhi
)
{
    if (patches_.empty())
    {
        return;
    }

    // What comes in: of U, of the fluid
    List<scalar> flows(2*patches_.size(), Zero);
    forAll(patches_, i)
    {
        const scalarField& phip = phi.boundaryField()[patches_[i]];
        const scalarField& alphaPhip = alphaPhi.boundaryField()[patches_[i]];
        forAll(phip, facei)
        {
            if (phip[facei] < 0)
            {
                flows[2*i] -= phip[facei];
                flows[2*i + 1] -= alphaPhip[facei];
            }
        }
    }
    Pstream::listCombineGather(flows, plusEqOp<scalar>());
    Pstream::listCombineScatter(flows);

    // Of the flow; a smoothed fluid fraction has tails
    constexpr scalar allowed = 0.01;
    DynamicList<label> silent;
    forAll(patches_, i)
    {
        if (flows[2*i + 1] >= (1 - allowed)*flows[2*i])
        {
            silent.append(patches_[i]);
            continue;
        }
        const fvPatchVectorField& Up = U_.boundaryField()[patches_[i]];
        Info<< "Warning: particles in the inlet " << Up.patch().name() << nl
            << "    given:   " << Up.type() << ", whose velocity is that between"
            << " the particles: " << flows[2*i + 1] << " m3/s come in, "
            << flows[2*i] << " m3/s if it were empty" << nl
            << "    allowed: yes, if that is meant" << nl
            << "    to do:   for a volume flow or a superficial velocity take"
            << " superficialInletVelocity with volumetricFlowRate or"
            << " superficialVelocity" << nl << endl;
    }
    patches_.transfer(silent);
}


// ************************************************************************* //
