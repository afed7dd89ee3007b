// SPDX-License-Identifier: GPL-3.0-or-later

#include "globalMeshData.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::pointValues::faceValues
(
    const GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    tmp<Field<Type>> tvalues
    (
        new Field<Type>(mesh_.nFaces() - mesh_.nInternalFaces(), Zero)
    );
    for (const fvPatchField<Type>& values : field.boundaryField())
    {
        // None on patches that are empty
        SubList<Type>
        (
            tvalues.ref(),
            values.size(),
            values.patch().start() - mesh_.nInternalFaces()
        ) = values;
    }
    return tvalues;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::pointValues::interpolate
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const labelUList& points
) const
{
    const tmp<Field<Type>> tfaceValues(faceValues(field));

    tmp<Field<Type>> tvalues(new Field<Type>(mesh_.nPoints()));
    Field<Type>& values = tvalues.ref();
    const auto add = []
    (
        const sources& s,
        const label pointi,
        const UList<Type>& given,
        Type& value
    )
    {
        for (label i = s.starts[pointi]; i < s.starts[pointi + 1]; ++i)
        {
            value += s.weights[i]*given[s.from[i]];
        }
    };
    const labelUList* const lists[] = {&points, &sharedPoints_};
    for (const labelUList* some : lists)
    {
        for (const label pointi : *some)
        {
            Type value(Zero);
            add(cells_, pointi, field.primitiveField(), value);
            add(faces_, pointi, tfaceValues(), value);
            values[pointi] = value;
        }
    }

    if (returnReduce(sharedPoints_.size(), sumOp<label>()))
    {
        mesh_.globalData().syncPointData
        (
            values, plusEqOp<Type>(), mapDistribute::transform()
        );
    }
    return tvalues;
}


// ************************************************************************* //
