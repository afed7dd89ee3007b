// SPDX-License-Identifier: GPL-3.0-or-later

#include "bridgeParticles.H"

#include "coupling/bridge/exchange/coupling_fields.h"

#include <cstring>

namespace bridge = powderlink::bridge;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    template<class Type>
    Foam::List<Type> rowsOf
    (
        const bridge::ParticleTable& table,
        const bridge::ExchangePlan& plan,
        const bridge::FieldSpec& spec
    )
    {
        Foam::List<Type> rows(Foam::label(table.particles));
        for (std::size_t i = 0; i < plan.to_solver.size(); ++i)
        {
            if (plan.to_solver[i] == spec && rows.size())
            {
                std::memcpy
                (
                    static_cast<void*>(rows.data()),
                    table.fields[i].view().data(),
                    rows.size()*sizeof(Type)
                );
            }
        }
        return rows;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::bridgeParticles::takeStrays
(
    const labelUList& rows,
    const UList<point>& received,
    const UList<vector>& impulse
)
{
    for (const label row : rows)
    {
        // One that was outside before has none
        if (impulse[row] == vector::zero)
        {
            continue;
        }
        const label celli = locator_.nearest(received[row]);
        if (celli >= 0)
        {
            strays_.append({celli, impulse[row]});
        }
    }
}


void Foam::bridgeParticles::checkOutside
(
    const label exchange,
    const List<point>& received,
    const List<int64_t>& ids,
    const labelUList& vanished
) const
{
    const label nOutside = ownership_.nOutsideGlobal();
    const label nAll =
        returnReduce(received.size() - vanished.size(), sumOp<label>());
    Info<< "exchange " << exchange << ": " << nAll
        << " particles, " << nOutside << " outside" << endl;
    if (!nOutside)
    {
        return;
    }
    const boundBox bounds(received, true);

    if (nOutside == nAll)
    {
        FatalErrorInFunction
            << "the domains of the two programs do not overlap: no particle"
            << " is in the mesh" << nl
            << "    given:   " << nAll << " particles within " << bounds << nl
            << "    allowed: particles within the mesh, "
            << locator_.mesh().bounds() << nl
            << "    to do:   check units and origin of the mesh and of the"
            << " particles" << nl
            << exit(FatalError);
    }

    // The first ones of every rank
    constexpr label nNamed = 5;
    const labelList& rows = ownership_.outsideRows();
    OStringStream here;
    for (label i = 0; i < min(nNamed, rows.size()); ++i)
    {
        here << ' ' << ids[rows[i]] << " at " << received[rows[i]];
    }
    List<string> texts(Pstream::nProcs());
    texts[Pstream::myProcNo()] = here.str();
    Pstream::gatherList(texts);

    Info<< "Warning: particles outside the mesh feel no fluid; id and place:";
    for (const string& text : texts)
    {
        Info<< text.c_str();
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::bridgeParticles::bridgeParticles(const fvMesh& mesh)
:
    locator_(mesh),
    images_(mesh),
    ownership_(locator_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<bridge::FieldSpec> Foam::bridgeParticles::needs()
{
    namespace f = bridge::fields;
    return
    {
        f::id,
        f::position,
        f::velocity,
        f::spin,
        f::radius,
        f::density,
        f::reaction_impulse,
        f::held
    };
}


void Foam::bridgeParticles::take
(
    const bridge::ParticleTable& table,
    const bridge::ExchangePlan& plan,
    const label exchange
)
{
    namespace f = bridge::fields;

    List<point> position = rowsOf<point>(table, plan, f::position);
    for (point& place : position)
    {
        place = images_.onBoundary(place, locator_.shift());
    }
    const List<scalar> radius = rowsOf<scalar>(table, plan, f::radius);
    const List<vector> impulse =
        rowsOf<vector>(table, plan, f::reaction_impulse);

    DynamicList<label> vanished;
    forAll(radius, row)
    {
        if (radius[row] == 0)
        {
            vanished.append(row);
        }
    }
    ownership_.update(position, vanished);
    checkOutside
    (
        exchange, position, rowsOf<int64_t>(table, plan, f::id), vanished
    );
    strays_.clear();
    takeStrays(vanished, position, impulse);
    takeStrays(ownership_.outsideRows(), position, impulse);

    ownership_.toOwner(position, position_);
    ownership_.toOwner(rowsOf<vector>(table, plan, f::velocity), velocity_);
    ownership_.toOwner(rowsOf<vector>(table, plan, f::spin), spin_);
    ownership_.toOwner(radius, radius_);
    ownership_.toOwner(rowsOf<scalar>(table, plan, f::density), density_);
    ownership_.toOwner(impulse, impulse_);
    ownership_.toOwner(rowsOf<scalar>(table, plan, f::held), held_);
}


// ************************************************************************* //
