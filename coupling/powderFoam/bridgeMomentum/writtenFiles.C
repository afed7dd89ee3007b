// SPDX-License-Identifier: GPL-3.0-or-later

#include "writtenFiles.H"
#include "IFstream.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"
#include "fileOperation.H"
#include "ListOps.H"

#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using Foam::fileName;

    bool endsFile(const std::string& text)
    {
        const auto last = text.find_last_not_of(" \t\r\n");
        return last != std::string::npos && last > 4
            && text.compare(last - 4, 5, "** //") == 0;
    }

    // The end of a file; of a compressed one the last line
    std::string tail(const fileName& file)
    {
        if (Foam::isFile(file, false))
        {
            constexpr std::streamoff nTail = 200;
            std::ifstream in(file, std::ios::binary | std::ios::ate);
            const std::streamoff size = in.tellg();
            const std::streamoff n = std::min(size, nTail);
            if (n <= 0)
            {
                return {};
            }
            std::string text(std::size_t(n), '\0');
            in.seekg(size - n);
            in.read(&text[0], n);
            return text;
        }
        if (!Foam::isFile(file + ".gz", false))
        {
            return {};
        }
        Foam::IFstream in(file);
        std::string last;
        std::string line;
        while (in.good())
        {
            in.getLine(line);
            if (!line.empty())
            {
                last = line;
            }
        }
        return last;
    }

    // Empty for a whole file
    Foam::string whyNotWhole(const fileName& file)
    {
        if (!Foam::isFile(file))
        {
            return file + " is missing";
        }
        return
            endsFile(tail(file)) ? Foam::string() : file + " breaks off";
    }

    // The first that is not empty, of all ranks
    Foam::string firstOf(const Foam::string& here)
    {
        Foam::List<Foam::string> all(Foam::Pstream::nProcs());
        all[Foam::Pstream::myProcNo()] = here;
        Foam::Pstream::gatherList(all);
        Foam::Pstream::scatterList(all);
        for (const Foam::string& some : all)
        {
            if (!some.empty())
            {
                return some;
            }
        }
        return Foam::string();
    }

    bool isCoupled(const Foam::fvMesh& mesh)
    {
        using namespace Foam;
        const IOdictionary dict
        (
            IOobject
            (
                "couplingProperties",
                mesh.time().constant(),
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        );
        return
            dict.isDict("particleMomentum")
         && dict.subDict("particleMomentum").lookupOrDefault<word>
            (
                "type", word::null, keyType::LITERAL
            ) == "bridge";
    }

    // Of the checkpoint in folder; empty if all of it is there
    Foam::string firstNotWhole
    (
        const Foam::fvMesh& mesh,
        const fileName& folder,
        const fileName& clock
    )
    {
        using namespace Foam;
        const string why = whyNotWhole(clock);
        if (!why.empty())
        {
            return why;
        }
        const IOdictionary dict
        (
            IOobject
            (
                clock.name(),
                mesh.time().timeName(),
                "uniform",
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        );
        // Those of earlier releases do not name their files
        std::istringstream names
        (
            dict.lookupOrDefault<string>
            (
                "files", "momentumBalance", keyType::LITERAL
            )
        );
        for (std::string name; names >> name;)
        {
            const string wrong = whyNotWhole(folder/name);
            if (!wrong.empty())
            {
                return wrong;
            }
        }
        return string();
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::writtenFiles::refuseCollated()
{
    const word handler(fileHandler().type());
    if (Pstream::parRun() && (handler == "collated" || handler == "hostCollated"))
    {
        FatalErrorInFunction
            << "file handler of a coupled run" << nl
            << "    given:   " << handler << nl
            << "    allowed: uncollated, masterUncollated: the files of each"
            << " processor are looked at when a pair of checkpoints is made"
            << nl
            << "    to do:   leave -fileHandler and FOAM_FILEHANDLER out"
            << nl
            << exit(FatalError);
    }
}


Foam::string Foam::writtenFiles::firstBroken(const fvMesh& mesh)
{
    const Time& time = mesh.time();
    DynamicList<fileName> files;
    files.append(time.timePath()/"uniform"/"time");
    const HashTable<const regIOobject*> objects
    (
        mesh.lookupClass<regIOobject>()
    );
    forAllConstIters(objects, iter)
    {
        const regIOobject& object = *iter.val();
        if
        (
            object.writeOpt() == IOobject::AUTO_WRITE
         && object.instance() == time.timeName()
        )
        {
            files.append(object.objectPath());
        }
    }

    string broken;
    for (const fileName& file : files)
    {
        if (!endsFile(tail(file)))
        {
            broken = file;
            break;
        }
    }
    return firstOf(broken);
}


void Foam::writtenFiles::checkStart(const fvMesh& mesh)
{
    if (!isCoupled(mesh))
    {
        return;
    }
    const fileName folder(mesh.time().timePath());
    const fileName clock(folder/"uniform"/"couplingClock");
    const bool isCheckpoint = returnReduce
    (
        isFile(clock) || isFile(folder/"momentumBalance"), orOp<bool>()
    );
    if (!isCheckpoint)
    {
        return;
    }
    const string wrong = firstOf(firstNotWhole(mesh, folder, clock));
    if (!wrong.empty())
    {
        // All ranks know: the first one says so and ends the job
        constexpr unsigned int patience_s = 10;
        if (!Pstream::master())
        {
            Foam::sleep(patience_s);
            Pstream::exit(1);
        }
        FatalErrorInFunction
            << "checkpoint of the fluid at the start, time "
            << mesh.time().timeName() << " s" << nl
            << "    given:   " << wrong.c_str() << nl
            << "    allowed: all files that uniform/couplingClock names, and"
            << " itself, whole, of every processor" << nl
            << "    to do:   go on from the last complete pair: powderlink"
            << " restart CASE --prepare; or begin a new coupled run with the"
            << " fields that are there: remove momentumBalance and"
            << " uniform/couplingClock from the time folder" << nl
            << exit(FatalError);
    }
}


Foam::wordList Foam::writtenFiles::needed(const fvMesh& mesh)
{
    const Time& time = mesh.time();
    const HashTable<const regIOobject*> objects
    (
        mesh.lookupClass<regIOobject>()
    );
    DynamicList<word> names;
    forAllConstIters(objects, iter)
    {
        const regIOobject& object = *iter.val();
        if
        (
            object.writeOpt() == IOobject::AUTO_WRITE
         && object.readOpt() != IOobject::NO_READ
         && object.local().empty()
         && object.instance() != time.constant()
         && object.instance() != time.system()
        )
        {
            names.append(object.name());
        }
    }
    Foam::sort(names);
    return wordList(std::move(names));
}


// ************************************************************************* //
