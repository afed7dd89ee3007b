// SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingProperties.H"
#include "dictionaryChecks.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingProperties::couplingProperties(const fvMesh& mesh)
:
    pressureShared_(true),
    couplingInterval_(1),
    couplingTime_(0),
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

    dictionaryChecks::checkEntries
    (
        dict,
        {"model"},
        {"couplingInterval", "couplingTime", "maxCoFatal", "particleMomentum"}
    );

    const word model(dict.get<word>("model"));
    if (model != "A" && model != "B")
    {
        dictionaryChecks::badValue
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
        dictionaryChecks::badValue
        (
            dict,
            "couplingInterval",
            Foam::name(couplingInterval_),
            "CFD steps from exchange to exchange, at least 1"
        );
    }

    if (dict.readIfPresent("couplingTime", couplingTime_))
    {
        if (!(couplingTime_ > 0) || dict.found("couplingInterval"))
        {
            dictionaryChecks::badValue
            (
                dict,
                "couplingTime",
                Foam::name(couplingTime_) + " s"
              + (dict.found("couplingInterval") ? " and couplingInterval" : ""),
                "a time above 0 s, instead of couplingInterval"
            );
        }
    }

    dict.readIfPresent("maxCoFatal", maxCoFatal_);
    if (!(maxCoFatal_ > 0))
    {
        dictionaryChecks::badValue
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
