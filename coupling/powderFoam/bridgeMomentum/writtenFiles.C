// SPDX-License-Identifier: GPL-3.0-or-later

#include "writtenFiles.H"
#include "IFstream.H"
#include "Time.H"
#include "fileOperation.H"
#include "ListOps.H"

#include <fstream>

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

    List<string> broken(Pstream::nProcs());
    for (const fileName& file : files)
    {
        if (!endsFile(tail(file)))
        {
            broken[Pstream::myProcNo()] = file;
            break;
        }
    }
    Pstream::gatherList(broken);
    Pstream::scatterList(broken);
    for (const string& file : broken)
    {
        if (!file.empty())
        {
            return file;
        }
    }
    return string();
}


// ************************************************************************* //
