// SPDX-License-Identifier: GPL-3.0-or-later

#include "mpiWorld.H"
#include "error.H"
#include "OSspecific.H"
#include "Pstream.H"

#include "coupling/bridge/link/coupling_link.h"
#include "coupling/bridge/transport/own_world.h"

#include <mpi.h>

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace bridge = powderlink::bridge;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // Both programs split the world first of all; a minute is for a loaded
    // machine
    constexpr double startTimeout_s = 60;

    bridge::MpiWorld thisWorld;
    bool isSplit = false;
    bool startedHere = false;

    // OpenFOAM may have switched trapping of floating-point exceptions on
    // already. What starts MPI are libraries of others, some of which divide by
    // zero in order (hwloc, as it reads a topology from a file)
    class untrapped
    {
        std::fenv_t before_;

    public:

        untrapped()
        {
            std::feholdexcept(&before_);
        }

        ~untrapped()
        {
            std::fesetenv(&before_);
        }

        untrapped(const untrapped&) = delete;
        void operator=(const untrapped&) = delete;
    };

    // OpenFOAM leaves a serial run by exit(), which alone would end this
    // program without a word to the other one
    void abortUnlessFinalised()
    {
        int isFinalised = 0;
        PMPI_Finalized(&isFinalised);
        if (!isFinalised)
        {
            MPI_Abort(MPI_COMM_WORLD, 1);
        }
    }

    void split()
    {
        try
        {
            thisWorld = bridge::split_world_if_shared("solver", startTimeout_s);
            bridge::take_as_world(thisWorld.local);
            isSplit = true;
        }
        catch (const std::exception& e)
        {
            std::fprintf(stderr, "powderFoam: %s\n", e.what());
            MPI_Abort(MPI_COMM_WORLD, 1);
        }
    }

    // A run without -parallel starts MPI only if mpirun, or srun --mpi=pmix, has
    // started more than itself
    bool mayShare()
    {
        Foam::string nProcesses(Foam::getEnv("OMPI_COMM_WORLD_SIZE"));
        if (nProcesses.empty() && !Foam::getEnv("PMIX_RANK").empty())
        {
            nProcesses = Foam::getEnv("SLURM_STEP_NUM_TASKS");
        }
        return
            Foam::Pstream::parRun()
         || !(nProcesses.empty() || nProcesses == "1");
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const bridge::MpiWorld& Foam::mpiWorld::world()
{
    if (!isSplit)
    {
        const untrapped start;
        int isInitialised = 0;
        PMPI_Initialized(&isInitialised);
        if (!isInitialised)
        {
            PMPI_Init(nullptr, nullptr);
            startedHere = true;
            std::atexit(abortUnlessFinalised);
        }
        split();
    }
    return thisWorld;
}


void Foam::mpiWorld::meet()
{
    if (mayShare())
    {
        world();
    }
}


void Foam::mpiWorld::refusePartner(const string& why, const string& toDo)
{
    if (!mayShare() || !bridge::holds_other_program(world()))
    {
        return;
    }
    letFirstRankSpeak();
    FatalErrorInFunction
        << "powderFoam and " << thisWorld.peer_role.c_str()
        << " in one mpirun" << nl
        << "    given:   " << why.c_str() << nl
        << "    allowed: particleMomentum { type bridge; transport mpi; ... }"
        << " in constant/couplingProperties" << nl
        << "    to do:   " << toDo.c_str() << nl
        << exit(FatalError);
}


void Foam::mpiWorld::letFirstRankSpeak()
{
    constexpr unsigned int patience_s = 1;
    if (Pstream::parRun() && !Pstream::master())
    {
        Foam::sleep(patience_s);
    }
}


void Foam::mpiWorld::finalise()
{
    if (startedHere)
    {
        const untrapped end;
        PMPI_Finalize();
        startedHere = false;
    }
}


// * * * * * * Beside own_world.def, instead of the MPI library's * * * * * * //

extern "C"
{

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided)
{
    const untrapped start;
    const int error = PMPI_Init_thread(argc, argv, required, provided);
    split();
    return error;
}

// Not by the library's own: mpirun of Open MPI 4.1.4 chokes on its farewell now
// and then ("ORTE_ERROR_LOG ... show_help.c") and then crashes or leaves other
// ranks alive. That a process is gone with a status is always noticed, and ends
// the job.
int MPI_Abort(MPI_Comm, int code)
{
    std::fflush(nullptr);
    bridge::say_last_words("powderFoam ended by an error; see its log");
    std::_Exit(code == 0 ? 1 : code);
}

} // extern "C"


// ************************************************************************* //
