// SPDX-License-Identifier: GPL-3.0-or-later

#include "particleMomentum.H"
#include "dictionaryChecks.H"
#include "functionObject.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(particleMomentum, 0);
    defineRunTimeSelectionTable(particleMomentum, dictionary);
    addToRunTimeSelectionTable(particleMomentum, particleMomentum, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleMomentum::particleMomentum
(
    const fvMesh& mesh,
    const couplingProperties&
)
:
    mesh_(mesh),
    Su_
    (
        IOobject("particleMomentumSu", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimAcceleration, Zero)
    ),
    Sp_
    (
        IOobject("particleMomentumSp", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless/dimTime, Zero)
    )
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::particleMomentum> Foam::particleMomentum::New
(
    const fvMesh& mesh,
    const couplingProperties& coupling
)
{
    const dictionary& dict = coupling.particleMomentumDict();
    // Function objects on a run of before: no step is made, nobody to couple with
    if (dict.empty() || functionObject::postProcess)
    {
        return autoPtr<particleMomentum>::New(mesh, coupling);
    }

    const word modelType
    (
        dictionaryChecks::getWord
        (
            dict, "type", dictionaryConstructorTablePtr_->sortedToc()
        )
    );

    if (modelType == typeName)
    {
        dictionaryChecks::checkEntries(dict, {"type"}, {});
    }

    Info<< "Selecting particleMomentum " << modelType << nl << endl;

    return autoPtr<particleMomentum>
    (
        dictionaryConstructorTablePtr_->cfind(modelType)()(mesh, coupling)
    );
}


// ************************************************************************* //
