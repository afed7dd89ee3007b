/*---------------------------------------------------------------------------*\
Application
    powderFoam

Group
    grpLagrangianSolvers

Description
    Transient solver for incompressible, turbulent flow of a Newtonian fluid
    that shares its volume with particles (volume-averaged equations), by the
    PISO or PIMPLE algorithm.

    Continuity and momentum, with fluid fraction alphaf, interstitial velocity
    U and kinematic pressure p:

        ddt(alphaf) + div(alphaf U) = 0

        ddt(alphaf U) + div(alphaf U U)
      - div(share nuEff (grad(U) + dev2(T(grad(U)))))
      = - share grad(p) + Su + Sp U + fvOptions

    Uniform sources among fvOptions are a mean pressure gradient and shared as
    grad(p) is (drivingGradient.H).

    share is alphaf in model A (pressure gradient and viscous stress shared
    with the particles) and 1 in model B (both in the fluid only). Su and Sp come from
    a particleMomentum model and, like fvOptions, are per volume of cell.

    The turbulence model is one of OpenFOAM's, with alphaf in its transport
    equations (alphafTurbulenceModel.H).

    Required fields: U, p and what the turbulence model needs.
    Optional: alphaf (1 when absent), constant/couplingProperties.

    With alphaf = 1 and no particles this is pisoFoam/pimpleFoam on a static
    mesh, and uses the same entries of fvSchemes and fvSolution.

SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "singlePhaseTransportModel.H"
#include "alphafTurbulenceModel.H"
#include "unmarkedWalls.H"
#include "pimpleControl.H"
#include "fvOptions.H"
#include "caseChecks.H"
#include "couplingProperties.H"
#include "drivingGradient.H"
#include "inletCheck.H"
#include "particleMomentum.H"
#include "mpiWorld.H"
#include "breakOff.H"
#include "writtenFiles.H"

#define CREATE_CONTROL createPimpleAlgorithm.H

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Transient solver for incompressible, turbulent flow that shares its"
        " volume with particles, by the PISO or PIMPLE algorithm."
    );

    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCaseLists.H"
    mpiWorld::meet();
    #include "createTime.H"
    #include "createMesh.H"
    caseChecks::check(mesh);
    writtenFiles::checkStart(mesh);
    #include "createPimpleAlgorithm.H"
    #include "createTimeControls.H"
    #include "createFields.H"

    // From here on the program of the particles is told why this one stops
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    try
    {
        if (!particles->coupled())
        {
            mpiWorld::refusePartner
            (
                "a run of powderFoam without particles",
                "couple the case, or start powderFoam alone"
            );
        }

        #include "createFvOptions.H"
        if (particles->coupled() || gMin(alphaf) < 1)
        {
            drivingGradient::report(mesh, coupling.pressureShared());
        }
        inletCheck inlets(U);
        #include "initContinuityErrs.H"
        #include "CourantNo.H"
        #include "setInitialDeltaT.H"

        turbulence->validate();

        Info<< "\nStarting time loop\n" << endl;

        while (runTime.run())
        {
            #include "readTimeControls.H"
            #include "CourantNo.H"
            const scalar deltaTOfCoNum = runTime.deltaTValue();
            #include "setDeltaT.H"
            #include "meetExchange.H"
            #include "checkCourantNo.H"

            if (!particles->startStep())
            {
                runTime.writeNow();
                break;
            }

            ++runTime;

            Info<< "Time = " << runTime.timeName() << nl << endl;

            particles->advanceFluidFraction();

            alphaff = fvc::interpolate(alphaf);
            alphaPhi = alphaff*phi;
            inlets.check(phi, alphaPhi);

            // --- Pressure-velocity PIMPLE corrector loop
            while (pimple.loop())
            {
                #include "UEqn.H"

                // --- Pressure corrector loop
                while (pimple.correct())
                {
                    #include "pEqn.H"
                }

                if (pimple.turbCorr())
                {
                    laminarTransport.correct();
                    turbulenceFlux = alphaPhi;
                    turbulence->correct();
                }
            }

            particles->endStep();

            particles->write(runTime);

            runTime.printExecutionTime(Info);
        }

        particles->finish();
    }
    catch (const Foam::IOerror& problem)
    {
        breakOff(problem, particles());
    }
    catch (const Foam::error& problem)
    {
        breakOff(problem, particles());
    }

    Info<< "End\n" << endl;

    // Afterwards the end of the other program may end this one, too
    mpiWorld::finalise();

    return 0;
}


// ************************************************************************* //
