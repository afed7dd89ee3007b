/*---------------------------------------------------------------------------*\
Class
    Foam::waveMomentum

Description
    Particles that move with one velocity through a periodic box, for tests:
    model `wave` of particleMomentum, from a library (entry `libs` of
    controlDict). They give no momentum to the fluid and set

        alphaf(x, t) = mean + amplitude sin(2 pi (x - speed t)/length)

SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleMomentum.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{

class waveMomentum
:
    public particleMomentum
{
    const dictionary dict_;

public:

    TypeName("wave");

    waveMomentum(const fvMesh& mesh, const couplingProperties& coupling)
    :
        particleMomentum(mesh, coupling),
        dict_(coupling.particleMomentumDict())
    {}

    virtual void advanceFluidFraction()
    {
        const scalar mean = dict_.get<scalar>("mean");
        const scalar amplitude = dict_.get<scalar>("amplitude");
        const scalar speed = dict_.get<scalar>("speed");
        const scalar waveNumber =
            constant::mathematical::twoPi/dict_.get<scalar>("length");
        const scalar t = mesh_.time().value();

        auto& alphaf = mesh_.lookupObjectRef<volScalarField>("alphaf");
        alphaf.primitiveFieldRef() =
            mean
          + amplitude
           *sin(waveNumber*(mesh_.C().primitiveField().component(0) - speed*t));
        alphaf.correctBoundaryConditions();
    }
};

defineTypeNameAndDebug(waveMomentum, 0);
addToRunTimeSelectionTable(particleMomentum, waveMomentum, dictionary);

} // End namespace Foam


// ************************************************************************* //
