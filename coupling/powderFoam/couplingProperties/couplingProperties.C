// SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingProperties.H"

// * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * * //

void Foam::couplingProperties::checkEntries
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


void Foam::couplingProperties::badValue
(
    const dictionary& dict,
    const word& keyword,
    const string& given,
    const string& allowed
)
{
    FatalIOErrorInFunction(dict)
        << "bad value of entry " << keyword << nl
        << "    given:   " << given.c_str() << nl
        << "    allowed: " << allowed.c_str() << nl
        << "    to do:   correct the entry" << nl
        << exit(FatalIOError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingProperties::couplingProperties(const fvMesh& mesh)
:
    pressureShared_(true),
    couplingInterval_(1),
    maxCoFatal_(5),
    particleMomentumDict_()
{
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

    if (dict.empty())
    {
        Info<< "No constant/couplingProperties: model A, no particles\n"
            << endl;
        return;
    }

    checkEntries
    (
        dict,
        {"model"},
        {"couplingInterval", "maxCoFatal", "particleMomentum"}
    );

    const word model(dict.get<word>("model"));
    if (model != "A" && model != "B")
    {
        badValue
        (
            dict,
            "model",
            model,
            "A (pressure gradient shared by fluid and particles),"
            " B (in the fluid only)"
        );
    }
    pressureShared_ = (model == "A");

    dict.readIfPresent("couplingInterval", couplingInterval_);
    if (couplingInterval_ < 1)
    {
        badValue
        (
            dict,
            "couplingInterval",
            Foam::name(couplingInterval_),
            "CFD steps from exchange to exchange, at least 1"
        );
    }

    dict.readIfPresent("maxCoFatal", maxCoFatal_);
    if (!(maxCoFatal_ > 0))
    {
        badValue
        (
            dict,
            "maxCoFatal",
            Foam::name(maxCoFatal_),
            "a Courant number above 0"
        );
    }

    if (dict.found("particleMomentum"))
    {
        particleMomentumDict_ = dict.subDict("particleMomentum");
    }

    Info<< "Coupling: model " << model << ", every " << couplingInterval_
        << " step(s), stop above Courant number " << maxCoFatal_ << nl
        << endl;
}


// ************************************************************************* //
