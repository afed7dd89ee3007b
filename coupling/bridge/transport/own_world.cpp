// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/own_world.h"

#include <boost/preprocessor/cat.hpp>
#include <boost/preprocessor/punctuation/comma_if.hpp>
#include <boost/preprocessor/seq/for_each_i.hpp>
#include <boost/preprocessor/variadic/to_seq.hpp>

namespace {

MPI_Comm own_ranks = MPI_COMM_WORLD;

inline MPI_Comm own(MPI_Comm comm) { return comm == MPI_COMM_WORLD ? own_ranks : comm; }
template <class Other>
inline Other own(Other other) {
  return other;
}

}  // namespace

namespace powderlink::bridge {

void take_as_world(MPI_Comm local) { own_ranks = local; }

}  // namespace powderlink::bridge

#define POWDERLINK_PARAMETER(r, data, n, Type) BOOST_PP_COMMA_IF(n) Type BOOST_PP_CAT(a, n)
#define POWDERLINK_ARGUMENT(r, data, n, Type) BOOST_PP_COMMA_IF(n) own(BOOST_PP_CAT(a, n))
#define POWDERLINK_FOR_EACH(what, types) \
  BOOST_PP_SEQ_FOR_EACH_I(what, , BOOST_PP_VARIADIC_TO_SEQ types)
#define POWDERLINK_OWN_WORLD(name, ...)                                          \
  int MPI_##name(POWDERLINK_FOR_EACH(POWDERLINK_PARAMETER, (__VA_ARGS__))) {     \
    return PMPI_##name(POWDERLINK_FOR_EACH(POWDERLINK_ARGUMENT, (__VA_ARGS__))); \
  }

extern "C" {
#include "coupling/bridge/transport/own_world.def"
}
