// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousStress.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // S & (nu dev2(T(grad(U)))) of nu grad(U)
    inline Foam::vector transposed
    (
        const Foam::vector& S,
        const Foam::tensor& nuGradU
    )
    {
        return (nuGradU & S) - 2.0/3.0*Foam::tr(nuGradU)*S;
    }


    // Stress on the faces of a patch, out of the domain [m4/s2]
    Foam::tmp<Foam::vectorField> patchForce
    (
        const Foam::fvPatchVectorField& U,
        const Foam::fvPatchTensorField& gradU,
        const Foam::fvPatchScalarField& nuEff
    )
    {
        using namespace Foam;

        const fvPatch& patch = U.patch();
        const vectorField& S = patch.Sf();
        tensorField nuGradU(nuEff*gradU);
        tmp<vectorField> tforce(new vectorField(patch.size()));
        vectorField& force = tforce.ref();
        if (patch.coupled())
        {
            // The patch's own values are those of the other side on some
            const scalarField& w = patch.weights();
            const scalarField nuHere(w*nuEff.patchInternalField());
            const scalarField nuThere((1 - w)*nuEff.patchNeighbourField());
            const tensorField gradHere(gradU.patchInternalField());
            const tensorField gradThere(gradU.patchNeighbourField());
            nuGradU = nuHere*gradHere + nuThere*gradThere;

            const surfaceInterpolation& geometry = patch.boundaryMesh().mesh();
            const label patchi = patch.index();
            force =
                (nuHere + nuThere)*patch.magSf()
               *(
                    U.snGrad
                    (
                        geometry.nonOrthDeltaCoeffs().boundaryField()[patchi]
                    )
                  + (
                        geometry.nonOrthCorrectionVectors()
                       .boundaryField()[patchi]
                      & (w*gradHere + (1 - w)*gradThere)
                    )
                );
        }
        else
        {
            force = nuEff*patch.magSf()*U.snGrad();
        }
        forAll(force, facei)
        {
            force[facei] += transposed(S[facei], nuGradU[facei]);
        }
        return tforce;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField> Foam::viscousStress::divergence
(
    const volVectorField& U,
    const volTensorField& gradU,
    const volScalarField& nuEff
)
{
    const fvMesh& mesh = U.mesh();
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject("divTau", mesh.time().timeName(), mesh),
            mesh,
            dimensionedVector(U.dimensions()*nuEff.dimensions()/dimArea, Zero),
            extrapolatedCalculatedFvPatchVectorField::typeName
        )
    );
    vectorField& result = tresult.ref().primitiveFieldRef();

    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const vectorField& Sf = mesh.Sf();
    const scalarField& magSf = mesh.magSf();
    const scalarField& weights = mesh.weights();
    const scalarField& deltaCoeffs = mesh.nonOrthDeltaCoeffs();
    const vectorField& corrections = mesh.nonOrthCorrectionVectors();
    forAll(neighbour, facei)
    {
        const label own = owner[facei];
        const label other = neighbour[facei];
        const scalar w = weights[facei];

        const scalar nu = w*nuEff[own] + (1 - w)*nuEff[other];
        const tensor grad(w*gradU[own] + (1 - w)*gradU[other]);
        const tensor nuGrad
        (
            w*nuEff[own]*gradU[own] + (1 - w)*nuEff[other]*gradU[other]
        );
        const vector force
        (
            nu*magSf[facei]
           *(
                deltaCoeffs[facei]*(U[other] - U[own])
              + (corrections[facei] & grad)
            )
          + transposed(Sf[facei], nuGrad)
        );
        result[own] += force;
        result[other] -= force;
    }
    forAll(mesh.boundary(), patchi)
    {
        const tmp<vectorField> tforce
        (
            patchForce
            (
                U.boundaryField()[patchi],
                gradU.boundaryField()[patchi],
                nuEff.boundaryField()[patchi]
            )
        );
        const labelUList& cells = mesh.boundary()[patchi].faceCells();
        forAll(cells, facei)
        {
            result[cells[facei]] += tforce()[facei];
        }
    }
    result /= mesh.V();
    tresult.ref().correctBoundaryConditions();
    return tresult;
}


// ************************************************************************* //
