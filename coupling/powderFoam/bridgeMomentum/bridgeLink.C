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

    // The longest that the bridge takes: three years
    constexpr scalar longest = 1e8;
    const string times("above 0 s, at most 1e8 s");
    options.timeout_s = dictionaryChecks::getOrDefault<scalar>
    (
        dict, "timeout", options.timeout_s, times
    );
    if (!(options.timeout_s > 0 && options.timeout_s <= longest))
    {
        dictionaryChecks::badValue
        (
            dict, "timeout", Foam::name(options.timeout_s), times
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

    mpiWorld::refusePartner
    (
        "transport socket, which is for two jobs",
        "set transport mpi in both programs, or start each by itself"
    );

    options.route = bridge::LinkOptions::Route::socket;
    options.listens = true;
    options.socket.rendezvous_file = "bridge.address";
    options.socket.timeout_s = options.timeout_s;

    if (dict.found("socket"))
    {
        const dictionary& socket = dictionaryChecks::subDict
        (
            dict, "socket", "{ side listen; rendezvous bridge.address; }"
        );
        const string addresses("unix:PATH or HOST:PORT in quotation marks");
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
            dictionaryChecks::getOrDefault<string>
            (
                socket, "address", string(), addresses
            );
        options.socket.token =
            dictionaryChecks::getOrDefault<string>
            (
                socket, "token", string(), "a word or text in quotation marks"
            );
        if (!options.socket.address.empty())
        {
            options.socket.rendezvous_file.clear();
        }
        if (socket.found("rendezvous"))
        {
            options.socket.rendezvous_file = dictionaryChecks::get<string>
            (
                socket, "rendezvous", "a file name in quotation marks"
            );
        }
    }
    return options;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::bridgeLink::stop(const std::exception& error)
{
    if (link_)
    {
        link_->fail(error.what());
    }
    mpiWorld::letFirstRankSpeak();
    FatalErrorInFunction
        << "the link to the program of the particles failed at time "
        << time_.timeName() << " s" << nl
        << "    " << error.what() << nl
        << exit(FatalError);
    std::abort();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bridgeLink::bridgeLink
(
    const dictionary& dict,
    const Time& time,
    const std::vector<bridge::FieldSpec>& needs,
    const std::vector<bridge::FieldSpec>& offers,
    const scalar interval,
    const bridge::Clock& clock,
    const rankMap& map
)
:
    time_(time)
{
    const bridge::LinkOptions options = readOptions(dict);

    bridge::Hello hello;
    hello.role = "solver";
    hello.case_name = dictionaryChecks::getOrDefault<word>
    (
        dict,
        "caseName",
        time.globalCaseName(),
        "one word, as in fix couple/bridge"
    );
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

    try
    {
        link_ = std::make_unique<bridge::SolverLink>
        (
            options.world.local, options, hello, voxels
        );
    }
    catch (const std::exception& e)
    {
        stop(e);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::bridgeLink::optionalEntries()
{
    return wordList({"transport", "socket", "timeout", "caseName"});
}


bool Foam::bridgeLink::receiveParticles()
{
    try
    {
        return link_->receive_particles();
    }
    catch (const std::exception& e)
    {
        stop(e);
    }
}


void Foam::bridgeLink::fail(const string& why)
{
    link_->fail(why);
}


void Foam::bridgeLink::sendValues
(
    const bridge::SolverWord& word,
    const std::vector<bridge::ColumnView>& columns
)
{
    try
    {
        link_->send_values(word, columns);
    }
    catch (const std::exception& e)
    {
        stop(e);
    }
}


// ************************************************************************* //
