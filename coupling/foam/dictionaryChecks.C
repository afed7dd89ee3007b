// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionaryChecks.H"
#include "FlatOutput.H"
#include "ITstream.H"
#include "StringStream.H"
#include "vector.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    // What stands in the file, variables expanded
    Foam::string textOf(const Foam::dictionary& dict, const Foam::word& keyword)
    {
        const Foam::entry* const found = dict.findEntry(keyword);
        if (!found)
        {
            return "missing";
        }
        if (found->isDict())
        {
            return "a dictionary";
        }
        Foam::OStringStream text;
        for (const Foam::token& t : found->stream())
        {
            text << (text.str().empty() ? "" : " ") << t;
        }
        return text.str().empty() ? Foam::string("nothing") : Foam::string(text.str());
    }

    // While it lives FatalIOError is thrown, not printed
    class ioErrorsThrown
    {
        const bool before_;

    public:

        ioErrorsThrown()
        :
            before_(Foam::FatalIOError.throwExceptions())
        {}

        ~ioErrorsThrown()
        {
            if (!before_)
            {
                Foam::FatalIOError.dontThrowExceptions();
            }
        }
    };
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::dictionaryChecks::checkEntries
(
    const dictionary& dict,
    const wordList& required,
    const wordList& optional
)
{
    wordList valid(required);
    valid.append(optional);

    for (const word& key : dict.toc())
    {
        if (!valid.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "unknown entry" << nl
                << "    given:   " << key << nl
                << "    allowed: " << flatOutput(valid) << nl
                << "    to do:   correct the name or remove the entry" << nl
                << exit(FatalIOError);
        }
    }

    for (const word& key : required)
    {
        if (!dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "missing entry " << key << nl
                << "    given:   " << flatOutput(dict.toc()) << nl
                << "    allowed: " << flatOutput(valid) << "; required: "
                << flatOutput(required) << nl
                << "    to do:   add the entry " << key << nl
                << exit(FatalIOError);
        }
    }
}


void Foam::dictionaryChecks::badValue
(
    const dictionary& dict,
    const word& keyword,
    const string& given,
    const string& allowed,
    const string& toDo
)
{
    FatalIOErrorInFunction(dict)
        << "bad value of entry " << keyword << nl
        << "    given:   " << given.c_str() << nl
        << "    allowed: " << allowed.c_str() << nl
        << "    to do:   " << toDo.c_str() << nl
        << exit(FatalIOError);
}


template<class Type>
Type Foam::dictionaryChecks::get
(
    const dictionary& dict,
    const word& keyword,
    const string& allowed
)
{
    Type value{};
    bool isRead = false;
    {
        const ioErrorsThrown guard;
        try
        {
            isRead = dict.readIfPresent(keyword, value);
        }
        catch (const Foam::IOerror&)
        {}
    }
    if (!isRead)
    {
        badValue(dict, keyword, textOf(dict, keyword), allowed);
    }
    return value;
}


template<class Type>
Type Foam::dictionaryChecks::getOrDefault
(
    const dictionary& dict,
    const word& keyword,
    const Type& otherwise,
    const string& allowed
)
{
    return
        dict.found(keyword) ? get<Type>(dict, keyword, allowed) : otherwise;
}


Foam::word Foam::dictionaryChecks::getWord
(
    const dictionary& dict,
    const word& keyword,
    const wordList& allowed
)
{
    OStringStream names;
    names << flatOutput(allowed);

    const word value(get<word>(dict, keyword, names.str()));
    if (!allowed.found(value))
    {
        badValue(dict, keyword, value, names.str());
    }
    return value;
}


const Foam::dictionary& Foam::dictionaryChecks::subDict
(
    const dictionary& dict,
    const word& keyword,
    const string& form
)
{
    const dictionary* const found = dict.findDict(keyword);
    if (!found)
    {
        badValue
        (
            dict,
            keyword,
            textOf(dict, keyword),
            "a dictionary, e.g. " + keyword + " " + form
        );
    }
    return *found;
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

#define makeReaders(Type)                                                      \
    template Foam::Type Foam::dictionaryChecks::get<Foam::Type>                \
    (                                                                          \
        const dictionary&, const word&, const string&                          \
    );                                                                         \
    template Foam::Type Foam::dictionaryChecks::getOrDefault<Foam::Type>       \
    (                                                                          \
        const dictionary&, const word&, const Type&, const string&             \
    );

makeReaders(word)
makeReaders(string)
makeReaders(label)
makeReaders(scalar)
makeReaders(vector)
makeReaders(wordList)

#undef makeReaders


// ************************************************************************* //
