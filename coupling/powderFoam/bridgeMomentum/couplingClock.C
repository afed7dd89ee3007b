// SPDX-License-Identifier: GPL-3.0-or-later

#include "couplingClock.H"
#include "Time.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingClock::couplingClock(const fvMesh& mesh)
:
    IOdictionary
    (
        IOobject
        (
            "couplingClock",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

powderlink::bridge::Clock Foam::couplingClock::start() const
{
    powderlink::bridge::Clock clock;
    clock.time_s = time().value();
    clock.continues = found("particlesAhead");
    clock.ahead_s = -lookupOrDefault<scalar>("particlesAhead", 0);
    return clock;
}


void Foam::couplingClock::set(const scalar particlesAhead)
{
    IOdictionary::set("particlesAhead", particlesAhead);
}


bool Foam::couplingClock::writeData(Ostream& os) const
{
    string names;
    for (const word& name : writtenFiles::needed(mesh_))
    {
        names += (names.empty() ? "" : " ") + name;
    }
    dictionary all(*this);
    all.set("files", names);
    all.write(os, false);
    return os.good();
}


// ************************************************************************* //
