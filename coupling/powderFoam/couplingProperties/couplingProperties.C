// SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingProperties.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    Foam::IOdictionary readDict(const Foam::fvMesh& mesh)
    {
        return Foam::IOdictionary
        (
            Foam::IOobject
            (
                "couplingProperties",
                mesh.time().constant(),
                mesh,
                Foam::IOobject::READ_IF_PRESENT,
                Foam::IOobject::NO_WRITE,
                false
            )
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingProperties::couplingProperties(const fvMesh& mesh)
:
    pressureShared_(true),
    couplingInterval_(1),
    couplingTime_(0),
    maxCoFatal_(5),
    particleMomentumDict_()
{
    const IOdictionary dict(readDict(mesh));

    if (dict.empty())
    {
        Info<< "No constant/couplingProperties: model A, no particles\n"
            << endl;
        return;
    }

    dictionaryChecks::checkEntries
    (
        dict,
        {"model"},
        {"couplingInterval", "couplingTime", "maxCoFatal", "particleMomentum"}
    );

    const string models
    (
        "A (pressure gradient shared by fluid and particles),"
        " B (in the fluid only)"
    );
    const word model(dictionaryChecks::get<word>(dict, "model", models));
    if (model != "A" && model != "B")
    {
        dictionaryChecks::badValue(dict, "model", model, models);
    }
    pressureShared_ = (model == "A");

    const string steps("CFD steps from exchange to exchange, at least 1");
    couplingInterval_ = dictionaryChecks::getOrDefault<label>
    (
        dict, "couplingInterval", couplingInterval_, steps
    );
    if (couplingInterval_ < 1)
    {
        dictionaryChecks::badValue
        (
            dict, "couplingInterval", Foam::name(couplingInterval_), steps
        );
    }

    if (dict.found("couplingTime"))
    {
        const string times("a time above 0 s, instead of couplingInterval");
        couplingTime_ =
            dictionaryChecks::get<scalar>(dict, "couplingTime", times);
        if (!(couplingTime_ > 0) || dict.found("couplingInterval"))
        {
            dictionaryChecks::badValue
            (
                dict,
                "couplingTime",
                Foam::name(couplingTime_) + " s"
              + (dict.found("couplingInterval") ? " and couplingInterval" : ""),
                times
            );
        }
    }

    const string limits("a Courant number above 0");
    maxCoFatal_ = dictionaryChecks::getOrDefault<scalar>
    (
        dict, "maxCoFatal", maxCoFatal_, limits
    );
    if (!(maxCoFatal_ > 0))
    {
        dictionaryChecks::badValue
        (
            dict, "maxCoFatal", Foam::name(maxCoFatal_), limits
        );
    }

    if (dict.found("particleMomentum"))
    {
        particleMomentumDict_ = dictionaryChecks::subDict
        (
            dict, "particleMomentum", "{ type none; }"
        );
    }

    Info<< "Coupling: model " << model << ", every ";
    if (couplingTime_ > 0)
    {
        Info<< couplingTime_ << " s";
    }
    else
    {
        Info<< couplingInterval_ << " step(s)";
    }
    Info<< ", stop above Courant number " << maxCoFatal_ << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::couplingProperties::isPressureShared(const fvMesh& mesh)
{
    return readDict(mesh).getOrDefault<word>("model", "A") != "B";
}


// ************************************************************************* //
