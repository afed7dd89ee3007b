// SPDX-License-Identifier: GPL-3.0-or-later
/*---------------------------------------------------------------------------*\
Application
    powderlink-foam

Description
    Files of OpenFOAM cases for programs that are not linked to OpenFOAM, read
    by OpenFOAM's own classes. Called by powderlink and powderlink-render:

        powderlink-foam QUESTIONS.json ANSWERS.json

        {"reads": [{"file": ..., "entry": ...}, ...]}   foamDictionaries.H
        {"change": {"file": ..., "entry": ..., "value": ...}}
        {"extentOf": CASE}                              meshExtent.H

    The answers have the same keys. Paths are absolute. $FOAM_CASE in
    dictionaries is what the caller has set.

Tests
    tests/coupling/foam/foam_files_test.sh

\*---------------------------------------------------------------------------*/

#include <nlohmann/json.hpp>

#include "codeDirectives.H"
#include "error.H"
#include "foamDictionaries.H"
#include "meshExtent.H"

#include <fstream>
#include <iostream>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// What OpenFOAM says, in one line. It quotes what it finds, at the end of a
// file that breaks off a NUL, which would end the caller's message too
static std::string lineOf(const error& e)
{
    std::string line;
    for (const char c : std::string(e.message()))
    {
        const unsigned char byte = c;
        const bool blank = byte <= ' ' || byte == 127;
        if (!blank) line += c;
        else if (!line.empty() && line.back() != ' ') line += ' ';
    }

    return line;
}


template<class Answer>
static nlohmann::json orError(const Answer& answer)
{
    try
    {
        return answer();
    }
    catch (const IOerror& e)
    {
        std::string text = lineOf(e);
        if (!e.ioFileName().empty())
        {
            text += " in " + e.ioFileName() + ", line "
              + std::to_string(e.ioStartLineNumber());
        }

        return {{"state", "error"}, {"text", text}};
    }
    catch (const error& e)
    {
        return {{"state", "error"}, {"text", lineOf(e)}};
    }
}


static nlohmann::json answersTo(const nlohmann::json& questions)
{
    foamDictionaries dictionaries;
    nlohmann::json answers;

    if (questions.contains("reads"))
    {
        answers["reads"] = nlohmann::json::array();
        for (const nlohmann::json& question : questions["reads"])
        {
            answers["reads"].push_back
            (
                orError([&]{ return dictionaries.answer(question); })
            );
        }
    }
    if (questions.contains("change"))
    {
        answers["change"] =
            orError([&]{ return foamDictionaries::change(questions["change"]); });
    }
    if (questions.contains("extentOf"))
    {
        answers["extentOf"] = orError
        (
            [&]
            {
                return meshExtent(questions["extentOf"].get<std::string>());
            }
        );
    }

    return answers;
}

} // End namespace Foam

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    if (argc != 3)
    {
        std::cerr
            << "powderlink-foam: wrong arguments; given: " << argc - 1
            << "; allowed: QUESTIONS.json ANSWERS.json; to do: call powderlink,"
            << " which calls this program\n";
        return 2;
    }

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    Foam::codeDirectives::replace();

    nlohmann::json questions;
    try
    {
        std::ifstream(argv[1]) >> questions;
        std::ofstream out(argv[2]);
        // Bytes of the files need not be UTF-8.
        out << Foam::answersTo(questions).dump
        (
            -1, ' ', false, nlohmann::json::error_handler_t::replace
        );
        out.close();
        if (!out)
        {
            std::cerr << "powderlink-foam: cannot write " << argv[2] << '\n';
            return 1;
        }
    }
    catch (const nlohmann::json::exception& e)
    {
        std::cerr << "powderlink-foam: " << e.what() << '\n';
        return 1;
    }

    // The answer is out; OpenFOAM's own destructors of static data have nothing
    // to add.
    std::cout.flush();
    _exit(0);
}


// ************************************************************************* //
