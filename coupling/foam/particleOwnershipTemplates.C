// SPDX-License-Identifier: GPL-3.0-or-later

#include "PstreamReduceOps.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "contiguous.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::particleOwnership::exchange
(
    const List<List<Type>>& send,
    const labelUList& nReceive,
    List<List<Type>>& receive
) const
{
    static_assert(is_contiguous<Type>::value, "sent as bytes");

    const label startOfRequests = Pstream::nRequests();

    receive.setSize(Pstream::nProcs());
    forAll(receive, proci)
    {
        receive[proci].setSize(nReceive[proci]);
        if (nReceive[proci])
        {
            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                proci,
                reinterpret_cast<char*>(receive[proci].data()),
                receive[proci].byteSize()
            );
        }
    }
    forAll(send, proci)
    {
        if (send[proci].size())
        {
            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                proci,
                reinterpret_cast<const char*>(send[proci].cdata()),
                send[proci].byteSize()
            );
        }
    }

    Pstream::waitRequests(startOfRequests);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::particleOwnership::toOwner
(
    const UList<Type>& received,
    List<Type>& owned
) const
{
    owned.setSize(nOwned());
    forAll(stay_, i)
    {
        owned[i] = received[stay_[i]];
    }
    if (nMovedGlobal_ == 0)
    {
        return;
    }

    List<List<Type>> send(Pstream::nProcs());
    forAll(send, proci)
    {
        send[proci] = List<Type>(received, send_[proci]);
    }
    List<List<Type>> guests;
    exchange(send, nGuests_, guests);

    label row = stay_.size();
    for (const List<Type>& some : guests)
    {
        for (const Type& value : some)
        {
            owned[row++] = value;
        }
    }
}


template<class Type>
void Foam::particleOwnership::toReceiver
(
    const UList<Type>& owned,
    List<Type>& received,
    const Type& outside
) const
{
    received.setSize(nReceived_);
    forAll(stay_, i)
    {
        received[stay_[i]] = owned[i];
    }
    for (const labelList* ownerless : {&outside_, &passed_})
    {
        for (const label row : *ownerless)
        {
            received[row] = outside;
        }
    }
    if (nMovedGlobal_ == 0)
    {
        return;
    }

    List<List<Type>> send(Pstream::nProcs());
    labelList nBack(Pstream::nProcs());
    label start = stay_.size();
    forAll(send, proci)
    {
        send[proci] = SubList<Type>(owned, nGuests_[proci], start);
        start += nGuests_[proci];
        nBack[proci] = send_[proci].size();
    }
    List<List<Type>> back;
    exchange(send, nBack, back);

    forAll(back, proci)
    {
        forAll(back[proci], i)
        {
            received[send_[proci][i]] = back[proci][i];
        }
    }
}


// ************************************************************************* //
