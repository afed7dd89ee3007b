// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshExtent.H"
#include "boundBox.H"
#include "OSspecific.H"
#include "pointIOField.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * //

namespace Foam
{

static void addPoints(const fileName& folder, boundBox& box)
{
    const fileName points(folder/"constant"/"polyMesh"/"points");
    if (!isFile(points)) return;

    // The case's own controlDict plays no part: its libraries are not loaded
    dictionary control;
    control.add("deltaT", scalar(1));
    control.add("writeFrequency", label(1));
    const Time time
    (
        control, folder.path(), folder.name(), "system", "constant", false, false
    );

    const pointIOField all
    (
        IOobject
        (
            "points",
            "constant",
            "polyMesh",
            time,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    for (const point& p : all) box.add(p);
}

} // End namespace Foam

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

nlohmann::json Foam::meshExtent(const fileName& caseFolder)
{
    boundBox box;
    addPoints(caseFolder, box);

    if (!box.valid())
    {
        for (label i = 0; isDir(caseFolder/("processor" + Foam::name(i))); ++i)
        {
            addPoints(caseFolder/("processor" + Foam::name(i)), box);
        }
    }

    if (!box.valid()) return nullptr;

    const auto corner = [](const point& p)
    {
        return nlohmann::json({p.x(), p.y(), p.z()});
    };

    return {{"low", corner(box.min())}, {"high", corner(box.max())}};
}


// ************************************************************************* //
