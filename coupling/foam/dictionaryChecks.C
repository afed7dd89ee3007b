// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionaryChecks.H"
#include "FlatOutput.H"
#include "StringStream.H"

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


Foam::word Foam::dictionaryChecks::getWord
(
    const dictionary& dict,
    const word& keyword,
    const wordList& allowed
)
{
    OStringStream names;
    names << flatOutput(allowed);

    word value;
    if (!dict.readIfPresent(keyword, value))
    {
        badValue(dict, keyword, "missing", names.str());
    }
    if (!allowed.found(value))
    {
        badValue(dict, keyword, value, names.str());
    }
    return value;
}


// ************************************************************************* //
