#!/usr/bin/env bash
# own_world_test.sh REPOSITORY MPI_COMPILER DEFINING=PROGRAM...: every MPI function with a communicator that
# the libraries of PROGRAM call is in own_world.def, and DEFINING (the program or a library of it) has it.
set -euo pipefail
definitions=$1/coupling/bridge/transport/own_world.def compiler=$2
shift 2
status=0
failed() { echo "FAILED: $*" >&2; status=1; }

# Those that cannot be given MPI_COMM_WORLD: they need a topology or an intercommunicator. Attributes stay
# with the true world. MPI_Abort is each program's own.
exempt='Abort|Cart_(coords|get|rank|shift|sub)|Cartdim_get|Graph_(get|neighbors|neighbors_count)|Graphdims_get'
exempt+='|Dist_graph_neighbors|Dist_graph_neighbors_count|I?[Nn]eighbor_.*|Comm_(remote_size|remote_group)'
exempt+='|Intercomm_merge|Comm_(get|set|delete)_attr|Attr_(get|put|delete)|Comm_get_parent'

# Functions of mpi.h that take a communicator by value.
mapfile -t takes_communicator < <(echo '#include <mpi.h>' | "$compiler" -x c -E - | tr '\n' ' ' | tr ';' '\n' |
  grep -oE ' MPI_[A-Z][A-Za-z_]+\(.*MPI_Comm +[a-z_0-9]+ *[,)].*' | grep -oE '^ MPI_[A-Za-z_]+' | sed 's/^ MPI_//' | sort -u)
((${#takes_communicator[@]} > 100)) || failed "only ${#takes_communicator[@]} functions found in mpi.h"
mapfile -t listed < <(grep -oE '^POWDERLINK_OWN_WORLD\([A-Za-z_]+' "$definitions" | sed 's/.*(//' | sort -u)

for pair in "$@"; do
  defining=${pair%%=*} program=${pair#*=}
  libraries=$(ldd "$program" | grep -oE '/[^ ]+' | grep -vE '/(libmpi|libopen-|ompi|openmpi/lib/)[^/]*$' | sort -u)
  # shellcheck disable=SC2086
  called=$(nm -D --undefined-only $libraries 2>/dev/null | grep -oE ' MPI_[A-Za-z_]+' | sed 's/^ MPI_//' | sort -u)
  missing=$(comm -12 <(printf '%s\n' "$called") <(printf '%s\n' "${takes_communicator[@]}") |
    grep -vxE "$exempt" | comm -23 - <(printf '%s\n' "${listed[@]}"))
  [[ -z $missing ]] || failed "$program: libraries call, and own_world.def lacks:" $missing
  [[ $(wc -l <<<"$called") -gt 20 ]] || failed "$program: only $(wc -l <<<"$called") calls of MPI found"
  defined=$(nm -D --defined-only "$defining" | grep -oE ' MPI_[A-Za-z_]+' | sed 's/^ MPI_//' | sort -u)
  missing=$(comm -23 <(printf '%s\n' "${listed[@]}") <(printf '%s\n' "$defined"))
  [[ -z $missing ]] || failed "$defining does not define:" $missing
done
exit $status
