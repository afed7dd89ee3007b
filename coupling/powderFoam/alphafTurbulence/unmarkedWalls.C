// SPDX-License-Identifier: GPL-3.0-or-later

#include "unmarkedWalls.H"
#include "noSlipFvPatchVectorField.H"
#include "volFields.H"
#include "wallDist.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::warnOfUnmarkedWalls(const volVectorField& U)
{
    const fvMesh& mesh = U.mesh();
    if (!mesh.foundObject<wallDist>(wallDist::typeName)) return;

    // Every rank has all patches but those between ranks, perhaps without faces
    label nWallFaces = 0;
    DynamicList<word> unmarked;
    forAll(U.boundaryField(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (isA<wallFvPatch>(patch))
        {
            nWallFaces += patch.size();
        }
        else if (isA<noSlipFvPatchVectorField>(U.boundaryField()[patchi]))
        {
            unmarked.append(patch.name());
        }
    }
    const bool noWall = returnReduce(nWallFaces, sumOp<label>()) == 0;

    if (!noWall && unmarked.empty()) return;

    Info<< "Warning: the turbulence model needs the distance to the wall, but ";
    if (noWall)
    {
        Info<< "no patch with faces is of type wall";
    }
    else
    {
        Info<< "the patches " << flatOutput(unmarked)
            << " with the condition noSlip are not of type wall";
    }
    Info<< ": there is no wall for it there. Give walls `type wall;` in"
        << " constant/polyMesh/boundary, before the case is decomposed" << nl
        << endl;
}


// ************************************************************************* //
