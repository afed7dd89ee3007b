// SPDX-License-Identifier: GPL-3.0-or-later

#include "foamDictionaries.H"
#include "codeDirectives.H"
#include "dimensionSet.H"
#include "entryPlace.H"
#include "Fstream.H"
#include "SHA1Digest.H"
#include "StringStream.H"

#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// As foamDictionary -value prints it
static std::string textOf(const entry& e)
{
    OStringStream text;
    text.precision(15);

    if (e.isDict())
    {
        e.dict().write(text, false);
    }
    else
    {
        bool first = true;
        for (const token& t : e.stream())
        {
            if (!first) text << token::SPACE;
            text << t;
            first = false;
        }
    }

    return text.str();
}


// As dimensioned<scalar> reads it: [name] [dimensions] value
static nlohmann::json numberOf(const entry& e)
{
    if (e.isDict()) return nullptr;

    ITstream& is = e.stream();
    is.rewind();
    token next(is);
    if (next.isWord() && is.nRemainingTokens()) is >> next;

    scalar unit = 1;
    if (next == token::BEGIN_SQR)
    {
        is.putBack(next);
        dimensionSet dimensions(dimless);
        dimensions.read(is, unit);
        is >> next;
    }

    if (!next.isNumber() || is.nRemainingTokens()) return nullptr;

    return unit*next.number();
}


static dictionary parsed(const std::string& text, const fileName& file)
{
    std::istringstream content(text);
    ISstream is(content, file);

    return dictionary(file, dictionary::null, is);
}

} // End namespace Foam

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

nlohmann::json Foam::foamDictionaries::answer(const nlohmann::json& question)
{
    const fileName file(question.at("file").get<std::string>());
    const word name(question.at("entry").get<std::string>(), false);

    if (!contents_.count(file))
    {
        IFstream is(file);
        if (!is.good()) return {{"state", "no file"}};

        content read;
        codeDirectives::reset();
        read.entries = dictionary(file, dictionary::null, is);
        read.hidden = codeDirectives::hideEntries();
        contents_[file] = read;
    }

    const content& known = contents_[file];
    if (known.hidden) return {{"state", "code"}};

    const entry* found = known.entries.findScoped(name, keyType::REGEX);
    if (!found) return {{"state", "absent"}};
    if (codeDirectives::made(*found)) return {{"state", "code"}};

    return
    {
        {"state", "value"},
        {"text", textOf(*found)},
        {"number", numberOf(*found)}
    };
}


nlohmann::json Foam::foamDictionaries::change(const nlohmann::json& question)
{
    const fileName file(question.at("file").get<std::string>());
    const word name(question.at("entry").get<std::string>(), false);
    const std::string value = question.at("value").get<std::string>();

    std::ifstream in(file, std::ios::binary);
    if (!in) return {{"state", "no file"}};
    std::stringstream all;
    all << in.rdbuf();
    const std::string text = all.str();

    dictionary before = parsed(text, file);
    const entry* found = before.findEntry(name, keyType::REGEX);
    if (found && textOf(*found) == value) return {{"state", "unchanged"}};
    before.remove(name);

    std::vector<std::string> attempts;
    if (const auto place = lastValueOf(name, text, file))
    {
        std::string replaced = text;
        replaced.replace(place->begin, place->end - place->begin, value);
        attempts.push_back(replaced);
    }
    const bool open = !text.empty() && text.back() != '\n';
    attempts.push_back
    (
        text + (open ? "\n" : "") + name + "       " + value + ";\n"
    );

    for (const std::string& attempt : attempts)
    {
        dictionary after = parsed(attempt, file);
        const entry* now = after.findEntry(name, keyType::REGEX);
        const bool seen = now && textOf(*now) == value;
        after.remove(name);

        if (seen && after.digest() == before.digest())
        {
            return {{"state", "changed"}, {"text", attempt}};
        }
    }

    return {{"state", "impossible"}};
}


// ************************************************************************* //
