// SPDX-License-Identifier: GPL-3.0-or-later

#include "voidFraction.H"
#include "dictionaryChecks.H"
#include "mathematicalConstants.H"
#include "Tuple2.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(voidFraction, 0);
    defineRunTimeSelectionTable(voidFraction, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::voidFraction::spread(const label, scalarField&) const
{}


Foam::string Foam::voidFraction::remedy(const scalar largestDiameter) const
{
    // With this width a single particle fills less than 2 % of its place, so
    // that the fraction is that of the packing around it.
    return
        "use voidFraction { type smooth; length "
      + Foam::name(3*largestDiameter)
      + "; } or a longer length (three of the largest particles' diameters),"
        " or larger cells";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFraction::voidFraction(const cellLocator& locator)
:
    solidsFraction_
    (
        IOobject
        (
            "solidsFraction",
            locator.mesh().time().timeName(),
            locator.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        locator.mesh(),
        dimensionedScalar(dimless, Zero)
    ),
    maxRadius_(0),
    locator_(locator),
    mesh_(locator.mesh())
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::voidFraction> Foam::voidFraction::New
(
    const cellLocator& locator,
    const dictionary& dict
)
{
    const word modelType
    (
        dictionaryChecks::getWord
        (
            dict,
            "type",
            dictionaryConstructorTablePtr_->sortedToc()
        )
    );

    Info<< "Selecting voidFraction " << modelType << endl;

    return autoPtr<voidFraction>
    (
        dictionaryConstructorTablePtr_->cfind(modelType)()(locator, dict)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::voidFraction::set
(
    const UList<point>& positions,
    const UList<scalar>& radii,
    const labelUList& cells
)
{
    cells_ = cells;
    setWeights(positions, radii);

    scalarField volumes(radii.size());
    maxRadius_ = 0;
    forAll(radii, i)
    {
        volumes[i] = 4.0/3.0*constant::mathematical::pi*pow3(radii[i]);
        maxRadius_ = max(maxRadius_, radii[i]);
    }
    deposit(1, volumes, solidsFraction_.field());
}


void Foam::voidFraction::checkFluidFraction(const scalar minFluidFraction) const
{
    // Solids fraction and place of the fullest cell
    Tuple2<scalar, Tuple2<label, point>> fullest(-GREAT, {-1, point::zero});
    const label celli = findMax(solidsFraction_.field());
    if (celli >= 0)
    {
        fullest.first() = solidsFraction_[celli];
        fullest.second() = {celli, mesh_.C()[celli]};
    }
    const scalar here = fullest.first();
    const scalar largest = returnReduce(here, maxOp<scalar>());
    if (largest <= 1 - minFluidFraction)
    {
        return;
    }

    const label rank = returnReduce
    (
        here == largest ? Pstream::myProcNo() : labelMax,
        minOp<label>()
    );
    List<Tuple2<scalar, Tuple2<label, point>>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = fullest;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    const Tuple2<label, point>& place = all[rank].second();

    FatalErrorInFunction
        << "void fraction model " << type() << " cannot serve this mesh:"
        << " too little fluid in cell " << place.first() << " of rank " << rank
        << " at " << place.second() << nl
        << "    given:   solids fraction " << largest << ", fluid fraction "
        << 1 - largest << nl
        << "    allowed: fluid fraction at least minFluidFraction = "
        << minFluidFraction << nl
        << "    to do:   "
        << remedy(2*returnReduce(maxRadius_, maxOp<scalar>())).c_str() << nl
        << exit(FatalError);
}


Foam::tmp<Foam::scalarField> Foam::voidFraction::deposit
(
    const UList<scalar>& quantity
) const
{
    tmp<scalarField> tdensities(new scalarField());
    deposit(1, quantity, tdensities.ref());
    return tdensities;
}


Foam::tmp<Foam::vectorField> Foam::voidFraction::deposit
(
    const UList<vector>& quantity
) const
{
    scalarField values(3*quantity.size());
    forAll(quantity, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            values[3*i + d] = quantity[i][d];
        }
    }
    scalarField densities;
    deposit(3, values, densities);

    tmp<vectorField> tresult(new vectorField(mesh_.nCells()));
    vectorField& result = tresult.ref();
    forAll(result, celli)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            result[celli][d] = densities[3*celli + d];
        }
    }
    return tresult;
}


Foam::tmp<Foam::vectorField> Foam::voidFraction::gather
(
    const UList<vector>& field
) const
{
    // One more than components: a width that smoothing likes
    constexpr label n = 4;
    scalarField cellValues(n*field.size(), Zero);
    forAll(field, celli)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            cellValues[n*celli + d] = field[celli][d];
        }
    }
    spread(n, cellValues);

    scalarField values(n*cells_.size(), Zero);
    collect(n, cellValues, values);

    tmp<vectorField> tresult(new vectorField(cells_.size()));
    vectorField& result = tresult.ref();
    forAll(result, i)
    {
        for (direction d = 0; d < vector::nComponents; ++d)
        {
            result[i][d] = values[n*i + d];
        }
    }
    return tresult;
}


void Foam::voidFraction::deposit
(
    const label n,
    const UList<scalar>& values,
    scalarField& densities
) const
{
    place(n, values, densities);
    spread(n, densities);
}


void Foam::voidFraction::place
(
    const label n,
    const UList<scalar>& values,
    scalarField& densities
) const
{
    densities.setSize(n*mesh_.nCells());
    densities = 0;
    share(n, values, densities);

    const scalarField& V = mesh_.V();
    forAll(V, celli)
    {
        const scalar rV = 1/V[celli];
        for (label k = celli*n; k < (celli + 1)*n; ++k)
        {
            densities[k] *= rV;
        }
    }
}


// ************************************************************************* //
