// SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM's turbulence models that powderFoam offers, one line each, with its
// header. A model whose stress is not linear in grad(U) (Maxwell, LRR, SSG)
// does not fit the momentum equation.

#include "alphafTurbulenceModel.H"
#include "makeTurbulenceModel.H"
#include "addToRunTimeSelectionTable.H"

#include "Stokes.H"

#include "kEpsilon.H"
#include "RNGkEpsilon.H"
#include "realizableKE.H"
#include "LaunderSharmaKE.H"
#include "kOmega.H"
#include "kOmegaSST.H"
#include "SpalartAllmaras.H"

#include "Smagorinsky.H"
#include "WALE.H"
#include "kEqn.H"
#include "dynamicKEqn.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    typedef laminarModel<alphafTurbulenceModel> laminaralphafTurbulenceModel;
    typedef RASModel<alphafTurbulenceModel> RASalphafTurbulenceModel;
    typedef LESModel<alphafTurbulenceModel> LESalphafTurbulenceModel;

    defineNamedTemplateTypeNameAndDebug(laminaralphafTurbulenceModel, 0);
    defineNamedTemplateTypeNameAndDebug(RASalphafTurbulenceModel, 0);
    defineNamedTemplateTypeNameAndDebug(LESalphafTurbulenceModel, 0);

    defineTemplateRunTimeSelectionTable
    (
        laminaralphafTurbulenceModel, dictionary
    );
    defineTemplateRunTimeSelectionTable(RASalphafTurbulenceModel, dictionary);
    defineTemplateRunTimeSelectionTable(LESalphafTurbulenceModel, dictionary);
}

makeTemplatedTurbulenceModel(alphafTurbulenceModel, laminar, Stokes);

makeTemplatedTurbulenceModel(alphafTurbulenceModel, RAS, kEpsilon);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, RAS, RNGkEpsilon);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, RAS, realizableKE);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, RAS, LaunderSharmaKE);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, RAS, kOmega);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, RAS, kOmegaSST);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, RAS, SpalartAllmaras);

makeTemplatedTurbulenceModel(alphafTurbulenceModel, LES, Smagorinsky);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, LES, WALE);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, LES, kEqn);
makeTemplatedTurbulenceModel(alphafTurbulenceModel, LES, dynamicKEqn);


// ************************************************************************* //
