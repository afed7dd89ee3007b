// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleFields.H"
#include "dictionaryChecks.H"
#include "mathematicalConstants.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    template<class Type>
    void make
    (
        Foam::autoPtr<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>&
            field,
        const Foam::word& name,
        const Foam::fvMesh& mesh,
        const Foam::dimensionSet& dimensions
    )
    {
        field.reset
        (
            new Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>
            (
                Foam::IOobject
                (
                    name,
                    mesh.time().timeName(),
                    mesh,
                    Foam::IOobject::NO_READ,
                    Foam::IOobject::AUTO_WRITE
                ),
                mesh,
                Foam::dimensioned<Type>(dimensions, Foam::Zero),
                Foam::zeroGradientFvPatchField<Type>::typeName
            )
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleFields::particleFields(const fvMesh& mesh, const dictionary& dict)
{
    const string allowed("names in brackets, of (Us Ksl)");
    for
    (
        const word& name
      : dictionaryChecks::getOrDefault<wordList>
        (
            dict, "writeFields", wordList(), allowed
        )
    )
    {
        if (name == "Us")
        {
            make(Us_, name, mesh, dimVelocity);
        }
        else if (name == "Ksl")
        {
            make(Ksl_, name, mesh, dimDensity/dimTime);
        }
        else
        {
            dictionaryChecks::badValue(dict, "writeFields", name, allowed);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleFields::set
(
    const bridgeParticles& particles,
    const UList<scalar>& dragCoefficient,
    const voidFraction& voidFraction
)
{
    if (!Us_.valid() && !Ksl_.valid())
    {
        return;
    }

    // Volume, volume times velocity, K
    constexpr label n = 5;
    scalarField values(n*particles.size());
    for (label i = 0; i < particles.size(); ++i)
    {
        const scalar volume =
            4.0/3.0*constant::mathematical::pi*pow3(particles.radius()[i]);
        scalar* v = &values[n*i];
        v[0] = volume;
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            v[1 + d] = volume*particles.velocity()[i][d];
        }
        v[4] = dragCoefficient[i];
    }
    scalarField densities;
    voidFraction.deposit(n, values, densities);

    if (Us_.valid())
    {
        volVectorField& Us = Us_();
        forAll(Us, celli)
        {
            const scalar* s = &densities[n*celli];
            Us[celli] =
                s[0] > VSMALL ? vector(s[1], s[2], s[3])/s[0] : vector::zero;
        }
        Us.correctBoundaryConditions();
    }
    if (Ksl_.valid())
    {
        volScalarField& Ksl = Ksl_();
        forAll(Ksl, celli)
        {
            Ksl[celli] = densities[n*celli + 4];
        }
        Ksl.correctBoundaryConditions();
    }
}


// ************************************************************************* //
