// SPDX-License-Identifier: GPL-3.0-or-later

#include "entryPlace.H"
#include "ISstream.H"

#include <sstream>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::optional<Foam::textPlace> Foam::lastValueOf
(
    const word& name,
    const std::string& text,
    const fileName& file
)
{
    std::istringstream content(text);
    ISstream is(content, file);
    std::optional<textPlace> last;
    textPlace value;
    label depth = 0;
    bool atKey = true, ours = false;
    token t;

    while (is.read(t) && t.good())
    {
        const bool isWord = t.isWord();

        if (depth == 0 && atKey)
        {
            if (isWord && t.wordToken()[0] == '#')
            {
                // A directive: its arguments are the rest of the line
                std::string arguments;
                is.getLine(arguments);
            }
            else if (isWord || t.isStringType())
            {
                ours = isWord && t.wordToken() == name && content.good();
                if (ours)
                {
                    const auto here = static_cast<std::size_t>(content.tellg());
                    value.begin = text.find_first_not_of(" \t", here);
                }
                // A macro may stand by itself, without a semicolon
                atKey = t.isVariable();
            }
            continue;
        }

        if (!t.isPunctuation()) continue;

        switch (t.pToken())
        {
            case token::BEGIN_LIST:
            case token::BEGIN_BLOCK:
                ++depth;
                break;

            case token::END_LIST:
                --depth;
                break;

            case token::END_BLOCK:
                atKey = (--depth == 0);
                break;

            case token::END_STATEMENT:
                if (depth == 0)
                {
                    if (ours)
                    {
                        value.end =
                            static_cast<std::size_t>(content.tellg()) - 1;
                        last = value;
                    }
                    atKey = true;
                    ours = false;
                }
                break;

            default:
                break;
        }
    }

    return last;
}


// ************************************************************************* //
