// SPDX-License-Identifier: GPL-3.0-or-later

#include "bridgeLink.H"
#include "dictionaryChecks.H"
#include "mpiWorld.H"

namespace bridge = powderlink::bridge;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bridge::LinkOptions readOptions(const dictionary& dict)
{
    bridge::LinkOptions options;
    options.world = mpiWorld::world();

    dict.readIfPresent("timeout", options.timeout_s);
    if (!(options.timeout_s > 0))
    {
        dictionaryChecks::badValue
        (
            dict, "timeout", Foam::name(options.timeout_s), "above 0 s"
        );
    }

    const word transport =
        dictionaryChecks::getWord(dict, "transport", {"mpi", "socket"});

    if (transport == "mpi")
    {
        if (!bridge::holds_other_program(options.world))
        {
            dictionaryChecks::badValue
            (
                dict,
                "transport",
                "mpi, but powderFoam is alone in its mpirun",
                "mpi when both programs are in one mpirun, socket otherwise",
                "start: mpirun -np 1 liggghts-powderlink -in in.case :"
                " -np 2 powderFoam -parallel; or set transport socket"
            );
        }
        return options;
    }

    options.route = bridge::LinkOptions::Route::socket;
    options.listens = true;
    options.socket.rendezvous_file = "bridge.address";
    options.socket.timeout_s = options.timeout_s;

    if (dict.found("socket"))
    {
        const dictionary& socket = dict.subDict("socket");
        dictionaryChecks::checkEntries
        (
            socket, {}, {"side", "rendezvous", "address", "token"}
        );
        if (socket.found("side"))
        {
            options.listens =
                dictionaryChecks::getWord(socket, "side", {"listen", "connect"})
             == "listen";
        }
        options.socket.address =
            socket.lookupOrDefault<string>("address", string());
        options.socket.token =
            socket.lookupOrDefault<string>("token", string());
        if (!options.socket.address.empty())
        {
            options.socket.rendezvous_file.clear();
        }
        if (socket.found("rendezvous"))
        {
            options.socket.rendezvous_file = socket.get<string>("rendezvous");
        }
    }
    return options;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::bridgeLink::optionalEntries()
{
    return wordList({"transport", "socket", "timeout", "caseName"});
}


std::unique_ptr<bridge::SolverLink> Foam::bridgeLink::open
(
    const dictionary& dict,
    const word& defaultCaseName,
    const std::vector<bridge::FieldSpec>& needs,
    const std::vector<bridge::FieldSpec>& offers,
    const scalar interval,
    const bridge::Clock& clock,
    const rankMap& map
)
{
    const bridge::LinkOptions options = readOptions(dict);

    bridge::Hello hello;
    hello.role = "solver";
    hello.case_name = dict.lookupOrDefault<word>("caseName", defaultCaseName);
    hello.ranks = Pstream::nProcs();
    hello.exchange_interval_s = interval;
    hello.clock = clock;
    hello.needs = needs;
    hello.offers = offers;

    bridge::RankMap voxels;
    voxels.origin_m = map.origin;
    voxels.spacing_m = map.spacing;
    voxels.voxels = map.voxels;
    voxels.rank = map.rank;

    Info<< "Waiting for the program of the particles, case "
        << hello.case_name.c_str() << ", at most " << options.timeout_s
        << " s" << endl;

    return std::make_unique<bridge::SolverLink>
    (
        options.world.local, options, hello, voxels
    );
}


// ************************************************************************* //
