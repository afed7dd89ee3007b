// SPDX-License-Identifier: GPL-3.0-or-later

#include "mpiWorld.H"
#include "error.H"
#include "OSspecific.H"
#include "Pstream.H"

#include "coupling/bridge/coupling_link.h"

#include <mpi.h>

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
            isSplit = true;
        }
        catch (const std::exception& e)
        {
            std::fprintf(stderr, "powderFoam: %s\n", e.what());
            MPI_Abort(MPI_COMM_WORLD, 1);
        }
    }

    // A run without -parallel starts MPI only if mpirun has started more than
    // itself
    bool mayShare()
    {
        const Foam::string nProcesses(Foam::getEnv("OMPI_COMM_WORLD_SIZE"));
        return
            Foam::Pstream::parRun()
         || !(nProcesses.empty() || nProcesses == "1");
    }

    inline MPI_Comm own(MPI_Comm comm)
    {
        return isSplit && comm == MPI_COMM_WORLD ? thisWorld.local : comm;
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const bridge::MpiWorld& Foam::mpiWorld::world()
{
    if (!isSplit)
    {
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
        PMPI_Finalize();
        startedHere = false;
    }
}


// * * * * * * * * * What Pstream calls instead of the library's * * * * * * //

extern "C"
{

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided)
{
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

int MPI_Comm_rank(MPI_Comm comm, int* rank)
{
    return PMPI_Comm_rank(own(comm), rank);
}

int MPI_Comm_size(MPI_Comm comm, int* size)
{
    return PMPI_Comm_size(own(comm), size);
}

int MPI_Comm_group(MPI_Comm comm, MPI_Group* group)
{
    return PMPI_Comm_group(own(comm), group);
}

int MPI_Comm_create(MPI_Comm comm, MPI_Group group, MPI_Comm* created)
{
    return PMPI_Comm_create(own(comm), group, created);
}

int MPI_Allreduce
(
    const void* send,
    void* receive,
    int count,
    MPI_Datatype type,
    MPI_Op operation,
    MPI_Comm comm
)
{
    return PMPI_Allreduce(send, receive, count, type, operation, own(comm));
}

int MPI_Alltoall
(
    const void* send,
    int nSend,
    MPI_Datatype sendType,
    void* receive,
    int nReceive,
    MPI_Datatype receiveType,
    MPI_Comm comm
)
{
    return PMPI_Alltoall
    (
        send, nSend, sendType, receive, nReceive, receiveType, own(comm)
    );
}

int MPI_Alltoallv
(
    const void* send,
    const int* nSend,
    const int* sendStarts,
    MPI_Datatype sendType,
    void* receive,
    const int* nReceive,
    const int* receiveStarts,
    MPI_Datatype receiveType,
    MPI_Comm comm
)
{
    return PMPI_Alltoallv
    (
        send, nSend, sendStarts, sendType,
        receive, nReceive, receiveStarts, receiveType, own(comm)
    );
}

int MPI_Gatherv
(
    const void* send,
    int nSend,
    MPI_Datatype sendType,
    void* receive,
    const int* nReceive,
    const int* starts,
    MPI_Datatype receiveType,
    int root,
    MPI_Comm comm
)
{
    return PMPI_Gatherv
    (
        send, nSend, sendType,
        receive, nReceive, starts, receiveType, root, own(comm)
    );
}

int MPI_Scatterv
(
    const void* send,
    const int* nSend,
    const int* starts,
    MPI_Datatype sendType,
    void* receive,
    int nReceive,
    MPI_Datatype receiveType,
    int root,
    MPI_Comm comm
)
{
    return PMPI_Scatterv
    (
        send, nSend, starts, sendType,
        receive, nReceive, receiveType, root, own(comm)
    );
}

int MPI_Send
(
    const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm
)
{
    return PMPI_Send(data, count, type, to, tag, own(comm));
}

int MPI_Bsend
(
    const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm
)
{
    return PMPI_Bsend(data, count, type, to, tag, own(comm));
}

int MPI_Isend
(
    const void* data,
    int count,
    MPI_Datatype type,
    int to,
    int tag,
    MPI_Comm comm,
    MPI_Request* request
)
{
    return PMPI_Isend(data, count, type, to, tag, own(comm), request);
}

int MPI_Recv
(
    void* data,
    int count,
    MPI_Datatype type,
    int from,
    int tag,
    MPI_Comm comm,
    MPI_Status* status
)
{
    return PMPI_Recv(data, count, type, from, tag, own(comm), status);
}

int MPI_Irecv
(
    void* data,
    int count,
    MPI_Datatype type,
    int from,
    int tag,
    MPI_Comm comm,
    MPI_Request* request
)
{
    return PMPI_Irecv(data, count, type, from, tag, own(comm), request);
}

int MPI_Probe(int from, int tag, MPI_Comm comm, MPI_Status* status)
{
    return PMPI_Probe(from, tag, own(comm), status);
}

} // extern "C"


// ************************************************************************* //
