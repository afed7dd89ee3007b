#!/usr/bin/env bash
# layers_test.sh LAYERS_SH WORK: the table of allowed includes is held: a small tree passes, and each way to
# break it is refused with file, line, arrow and what to do.
set -euo pipefail
layers=$1
work=$2
failed() { echo "layers_test: $*" >&2; exit 1; }

rm -rf "$work"
tree() {  # a tree that passes
  rm -rf "$work/tree"
  mkdir -p "$work"/tree/{base/files,physics/contact,analysis/program,coupling/foam,scripts}
  cd "$work/tree"
  printf '%s\n' '# folder | includes' 'base | - | ground | a' 'physics/contact | base | laws | b' \
    'coupling/foam | base | fields | c' 'analysis/program | base physics/contact | commands | d' >scripts/layers.txt
  echo '#pragma once' >base/files/text.h
  printf '%s\n' '#pragma once' '' '#include "base/files/text.h"' >physics/contact/law.h
  printf '%s\n' '#include <vector>' '#include "physics/contact/law.h"' '#include "main.h"' >analysis/program/main.cpp
  echo '#pragma once' >analysis/program/main.h
  echo '#include "base/files/text.h"' >coupling/foam/voidFraction.H
}
passes() { "$layers" --root "$work/tree" 2>"$work/said" || { cat "$work/said" >&2; failed "refused: $1"; }; }
refused() {  # case, text that must be said
  local text
  if "$layers" --root "$work/tree" 2>"$work/said"; then failed "not refused: $1"; fi
  shift
  for text in "$@" 'given: ' 'allowed: ' 'to do: '; do
    grep -qF -- "$text" "$work/said" || { cat "$work/said" >&2; failed "does not say '$text'"; }
  done
}

tree
passes "a tree without a fault"

tree
echo '#include "analysis/program/main.h"' >>physics/contact/law.h
refused "an include that goes up" 'physics/contact/law.h:4: physics/contact -> analysis/program' \
  '#include "analysis/program/main.h"'

tree
echo '  #  include "physics/contact/law.h"' >>base/files/text.h
refused "one with blanks, in a folder below that of the row" 'base/files/text.h:2: base -> physics/contact'

tree
echo '#include "voidFraction.H"' >>physics/contact/law.h
refused "OpenFOAM's bare name" 'physics/contact/law.h:4: physics/contact -> coupling/foam'

tree
echo 'never physics: mpi.h' >>scripts/layers.txt
passes "a tree that does not include what it never may"
sed -i '2s/.*/#include <mpi.h>/' physics/contact/law.h
refused "a header that a folder never includes" 'physics/contact/law.h:2: physics never includes it' 'mpi.h'

tree
mkdir -p analysis/other
echo '#pragma once' >analysis/other/other.h
refused "a folder without a row" 'analysis/other/other.h' 'its folder has no row'

tree
sed -i 's/^base | -/base | physics\/contact/' scripts/layers.txt
refused "a row that may include one below it" 'row base' 'physics/contact is no row above it'
