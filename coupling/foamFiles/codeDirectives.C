// SPDX-License-Identifier: GPL-3.0-or-later

#include "codeDirectives.H"
#include "dictionary.H"
#include "functionEntry.H"
#include "primitiveEntry.H"
#include "StringStream.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const char* const notRun = "codeThatIsNotRun";

static bool values_ = false, entries_ = false, conditions_ = false;

typedef bool (*conditionFunction)(dictionary&, Istream&);
static std::map<std::string, conditionFunction> conditionTable_;


// What follows the directive: a string, or the dictionary of a #codeStream
static void skipCode(const dictionary& parentDict, Istream& is)
{
    token first(is);
    is.putBack(first);

    if (first == token::BEGIN_BLOCK)
    {
        const dictionary code("code", parentDict, is);
    }
    else
    {
        const token text(is);
    }
}


static bool codeAsValue
(
    const dictionary& parentDict,
    primitiveEntry& e,
    Istream& is
)
{
    skipCode(parentDict, is);
    values_ = true;

    IStringStream word(notRun);
    e.read(parentDict, word);

    return true;
}


static bool codeAsEntries(dictionary& parentDict, Istream& is)
{
    skipCode(parentDict, is);
    entries_ = true;

    return true;
}


template<int Kind>
static bool condition(dictionary& parentDict, Istream& is)
{
    conditions_ = true;

    return conditionTable_[Kind == 0 ? "if" : "ifeq"](parentDict, is);
}

} // End namespace Foam

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::codeDirectives::replace()
{
    auto& values =
        *functionEntry::executeprimitiveEntryIstreamMemberFunctionTablePtr_;
    auto& entries =
        *functionEntry::executedictionaryIstreamMemberFunctionTablePtr_;

    for (const char* name : {"calc", "codeStream"})
    {
        values.set(name, codeAsValue);
        entries.set(name, codeAsEntries);
    }

    for (const char* name : {"if", "ifeq"})
    {
        if (entries.found(name)) conditionTable_[name] = entries[name];
    }
    if (conditionTable_.count("if")) entries.set("if", condition<0>);
    if (conditionTable_.count("ifeq")) entries.set("ifeq", condition<1>);
}


void Foam::codeDirectives::reset()
{
    values_ = entries_ = conditions_ = false;
}


bool Foam::codeDirectives::hideEntries()
{
    return entries_ || (values_ && conditions_);
}


bool Foam::codeDirectives::made(const entry& e)
{
    if (e.isDict()) return false;

    for (const token& t : e.stream())
    {
        if (t.isWord() && t.wordToken() == notRun) return true;
    }

    return false;
}


// ************************************************************************* //
