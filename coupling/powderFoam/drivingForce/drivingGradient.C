// SPDX-License-Identifier: GPL-3.0-or-later

#include "drivingGradient.H"
#include "superficialVelocityForce.H"
#include "fvMatrices.H"
#include "fvOptions.H"
#include "globalMeshData.H"
#include "meanVelocityForce.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using namespace Foam;

    const word fieldName("U");

    fv::options* findOptions(const fvMesh& mesh)
    {
        fv::options* options =
            mesh.thisDb().getObjectPtr<fv::options>(fv::options::typeName);

        return
            options && options->optionList::size() ? options : nullptr;
    }

    // One that acts in some of the cells is a fan
    bool actsEverywhere(const fv::option& source)
    {
        return
            !isA<fv::cellSetOption>(source)
         || returnReduce
            (
                refCast<const fv::cellSetOption>(source).cells().size(),
                sumOp<label>()
            ) == source.mesh().globalData().nTotalCells();
    }

    bool mayDrive(const fv::option& source)
    {
        return
            isA<fv::meanVelocityForce>(source)
         || isA<fv::superficialVelocityForce>(source)
         || source.type() == "vectorSemiImplicitSource";
    }

    // Source of an option if it is uniform, at rest: without implicit parts
    bool uniformSource
    (
        fv::option& source,
        const label fieldi,
        volVectorField& atRest,
        vector& G
    )
    {
        fvVectorMatrix matrix(atRest, dimVolume*dimAcceleration);
        source.addSup(matrix, fieldi);
        const vectorField Su(-matrix.source()/atRest.mesh().V().field());

        G = gAverage(Su);
        // Sources and volumes have round-off
        return gMax(mag(Su - G)()) <= 1e-9*mag(G) + VSMALL;
    }

    template<class Visitor>
    void visitDriving(const fvMesh& mesh, const Visitor& visitor)
    {
        fv::options* options = findOptions(mesh);
        if (!options)
        {
            return;
        }
        volVectorField atRest
        (
            IOobject
            (
                fieldName,
                mesh.time().timeName(),
                mesh,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh,
            dimensionedVector(dimVelocity, Zero)
        );
        fv::optionList& list = *options;
        forAll(list, i)
        {
            fv::option& source = list[i];
            const label fieldi = source.applyToField(fieldName);
            vector G(Zero);
            if
            (
                fieldi != -1
             && mayDrive(source)
             && source.isActive()
             && actsEverywhere(source)
             && uniformSource(source, fieldi, atRest, G)
            )
            {
                visitor(source, G);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::vector Foam::drivingGradient::value(const fvMesh& mesh)
{
    vector sum(Zero);
    visitDriving
    (
        mesh, [&](const fv::option&, const vector& G) { sum += G; }
    );
    return sum;
}


void Foam::drivingGradient::report
(
    const fvMesh& mesh,
    const bool pressureShared
)
{
    visitDriving
    (
        mesh,
        [&](const fv::option& source, const vector&)
        {
            Info<< "fvOptions: " << source.name() << " is a mean pressure"
                << " gradient, "
                << (
                       pressureShared
                     ? "shared by fluid and particles as that of p is"
                     : "which the fluid has alone (model B)"
                   )
                << endl;

            if (isA<fv::meanVelocityForce>(source))
            {
                Info<< "Warning: mean velocity of " << source.name() << nl
                    << "    given:   Ubar of " << source.type()
                    << ", which is the mean of U, the velocity between the"
                    << " particles" << nl
                    << "    allowed: yes, if that is meant" << nl
                    << "    to do:   for a superficial velocity (volume flow"
                    << " over area) take superficialVelocityForce with"
                    << " superficialVelocity" << nl << endl;
            }
        }
    );
}


// ************************************************************************* //
