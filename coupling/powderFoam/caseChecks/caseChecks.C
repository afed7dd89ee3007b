// SPDX-License-Identifier: GPL-3.0-or-later

#include "caseChecks.H"
#include "mpiWorld.H"
#include "IOdictionary.H"
#include "HashSet.H"
#include "OSspecific.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    using namespace Foam;

    // Parts of a message
    struct complaint
    {
        string what;
        string given;
        string allowed;
        string toDo;
    };

    Ostream& operator<<(Ostream& os, const complaint& c)
    {
        return os
            << c.what.c_str() << nl
            << "    given:   " << c.given.c_str() << nl
            << "    allowed: " << c.allowed.c_str() << nl
            << "    to do:   " << c.toDo.c_str() << nl;
    }

    void warn(const complaint& c)
    {
        Info<< "Warning: " << c << endl;
    }

    // Of all processors, in the case's own folders
    dictionary read
    (
        const fvMesh& mesh,
        const word& name,
        const fileName& instance
    )
    {
        return IOdictionary
        (
            IOobject
            (
                name,
                instance,
                mesh,
                IOobject::READ_IF_PRESENT,
                IOobject::NO_WRITE,
                false
            )
        );
    }

    bool hasActiveZone(const dictionary& dict)
    {
        for (const entry& e : dict)
        {
            if (e.isDict() && e.dict().getOrDefault<Switch>("active", true))
            {
                return true;
            }
        }
        return false;
    }

    void findConstant(const fvMesh& mesh, DynamicList<complaint>& found)
    {
        const Time& time = mesh.time();
        const fileName& constant = time.constant();

        if (hasActiveZone(read(mesh, "MRFProperties", constant)))
        {
            found.append
            ({
                "rotating zones: constant/MRFProperties",
                "an active zone",
                "none: this solver has no rotating frames",
                "set active no, or remove the file"
            });
        }

        const dictionary motion(read(mesh, "dynamicMeshDict", constant));
        const word type
        (
            motion.getOrDefault<word>("dynamicFvMesh", "staticFvMesh")
        );
        if (type != "staticFvMesh")
        {
            found.append
            ({
                "moving mesh: constant/dynamicMeshDict",
                "dynamicFvMesh " + type,
                "staticFvMesh: the mesh of this solver stands;"
                " walls move in LIGGGHTS",
                "set dynamicFvMesh staticFvMesh, or remove the file"
            });
        }

        const Pair<string> others[] =
        {
            {"SRFProperties", "a frame at rest: remove the file"},
            {
                "porosityProperties",
                "explicitPorositySource in constant/fvOptions:"
                " move the zones there, remove the file"
            }
        };
        for (const Pair<string>& other : others)
        {
            if (!read(mesh, word(other.first()), constant).empty())
            {
                found.append
                ({
                    "constant/" + other.first(),
                    "a file that this solver does not read",
                    "cases without it",
                    other.second()
                });
            }
        }

        for (const fileName& file : readDir(time.globalPath()/constant))
        {
            const std::string ending("CloudProperties");
            if
            (
                file.size() > ending.size()
             && file.compare
                (
                    file.size() - ending.size(), ending.size(), ending
                ) == 0
            )
            {
                found.append
                ({
                    "parcels of OpenFOAM: constant/" + file,
                    "a cloud, which this solver does not move",
                    "the particles of a LIGGGHTS script with fix couple/bridge",
                    "insert the particles there, remove the file"
                });
            }
        }
    }

    void findOptions(const fvMesh& mesh, DynamicList<complaint>& found)
    {
        const Time& time = mesh.time();

        for (const word name : {"fvModels", "fvConstraints"})
        {
            for (const word& folder : {time.constant(), time.system()})
            {
                if (!read(mesh, name, folder).empty())
                {
                    found.append
                    ({
                        "sources: " + folder + "/" + name,
                        "a file of another branch of OpenFOAM",
                        "constant/fvOptions or system/fvOptions",
                        "write the sources as fvOptions, remove the file"
                    });
                }
            }
        }

        if
        (
            !read(mesh, "fvOptions", time.constant()).empty()
         && !read(mesh, "fvOptions", time.system()).empty()
        )
        {
            found.append
            ({
                "sources: fvOptions",
                "constant/fvOptions and system/fvOptions,"
                " of which OpenFOAM reads the former alone",
                "one of them",
                "put all sources into constant/fvOptions, remove the other"
            });
        }
    }

    string inOneLine(const wordList& words)
    {
        string line;
        for (const word& w : words)
        {
            line += (line.empty() ? "" : " ") + w;
        }
        return line;
    }

    // A misspelt entry would leave its default in force
    void checkControls(const fvMesh& mesh, const word& name)
    {
        const wordHashSet known
        ({
            "nOuterCorrectors", "nCorrectors", "nNonOrthogonalCorrectors",
            "momentumPredictor", "consistent", "turbOnFinalIterOnly",
            "residualControl", "pRefCell", "pRefPoint", "pRefValue"
        });
        wordList unknown;
        for (const entry& e : mesh.solutionDict().subDict(name))
        {
            if (!e.keyword().isPattern() && !known.found(e.keyword()))
            {
                unknown.append(e.keyword());
            }
        }
        if (unknown.size())
        {
            warn
            ({
                "entries of " + name + " in system/fvSolution that are not read",
                inOneLine(unknown),
                inOneLine(known.sortedToc()),
                "correct their names, or remove them"
            });
        }
    }

    void findFunctions(const fvMesh& mesh)
    {
        const dictionary functions
        (
            mesh.time().controlDict().subOrEmptyDict("functions")
        );
        for (const entry& e : functions)
        {
            if
            (
                e.isDict()
             && e.dict().getOrDefault<word>("type", "") == "scalarTransport"
             && e.dict().getOrDefault<word>("phi", "phi") == "phi"
            )
            {
                warn
                ({
                    "function object " + e.keyword(),
                    "scalarTransport with phi, the flux between the particles",
                    "where the fluid fraction is 1;"
                    " elsewhere a uniform scalar does not stay so",
                    "take type fluidScalarTransport; same entries, no libs"
                });
            }
        }
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::word Foam::caseChecks::algorithm(const fvMesh& mesh)
{
    const dictionary& solution = mesh.solutionDict();
    const bool hasPimple = solution.isDict("PIMPLE");
    const bool hasPiso = solution.isDict("PISO");
    const bool hasSimple = solution.isDict("SIMPLE");

    if (hasPimple && (hasPiso || hasSimple))
    {
        warn
        ({
            "system/fvSolution",
            string("PIMPLE and ") + (hasPiso ? "PISO" : "SIMPLE"),
            "one of PIMPLE and PISO; this run takes PIMPLE",
            "remove the other one, unless another program needs it"
        });
    }
    if (hasPimple || hasPiso)
    {
        const word name(hasPimple ? "PIMPLE" : "PISO");
        checkControls(mesh, name);
        return name;
    }

    const complaint missing
    {
        "system/fvSolution",
        hasSimple ? "SIMPLE" : "neither PIMPLE nor PISO",
        "a dictionary PIMPLE or PISO: this solver is transient",
        "add PIMPLE { nOuterCorrectors 1; nCorrectors 2; }"
    };
    if (hasSimple)
    {
        mpiWorld::letFirstRankSpeak();
        FatalErrorInFunction << missing << exit(FatalError);
    }
    warn(missing);
    return "PIMPLE";
}


void Foam::caseChecks::check(const fvMesh& mesh)
{
    DynamicList<complaint> found;
    findConstant(mesh, found);
    findOptions(mesh, found);

    if (found.size())
    {
        mpiWorld::letFirstRankSpeak();
        auto& error = FatalErrorInFunction;
        error
            << "files that would be left out" << nl << nl;
        for (const complaint& c : found)
        {
            error << c;
        }
        error << exit(FatalError);
    }

    findFunctions(mesh);
    const Time& time = mesh.time();
    if (isFile(time.globalPath()/time.constant()/"liggghtsCommands"))
    {
        warn
        ({
            "constant/liggghtsCommands",
            "a file of CFDEMcoupling that this solver does not read",
            "the LIGGGHTS script runs by itself",
            "remove the file; restart files come with the fields"
        });
    }
}


// ************************************************************************* //
