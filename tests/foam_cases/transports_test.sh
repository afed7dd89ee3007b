#!/usr/bin/env bash
# transports_test.sh REPOSITORY CASE RANKS DEM_RANKS WORK: the same case as one MPI job and as two jobs
# over a socket gives the same particles, forces and fields, to round-off. Runs a copy of the case that
# writes all of them in full.
set -euo pipefail
root=$1 case=$2 ranks=$3 dem_ranks=$4 work=$5
failed() { echo "FAILED: $*" >&2; exit 1; }
rm -rf "$work"
mkdir -p "$work"/foam_cases
cp -r "$root/scripts" "$work"
cp -r "$root/foam_cases/$case" "$work/foam_cases"
copy=$work/foam_cases/$case

columns=(id)
for vector in x:y:z vx:vy:vz omegax:omegay:omegaz fx:fy:fz; do
  IFS=: read -r a b c <<<"$vector"
  columns+=("$a" "$b" "$c")
done
for vector in fluidVelocity fluidForce reactingForce pressureForce reactionImpulse; do
  columns+=("f_${vector}[1]" "f_${vector}[2]" "f_${vector}[3]")
done
columns+=(f_fluidFraction f_dragCoefficient)
numbers="$(printf ' %%.17g%.0s' "${columns[@]:1}")"
# Ten times as often as the case's own dump.
every=$(awk '$1 == "dump" && $2 == "dmp" { print int($5/10) }' "$copy/in.$case")
sed -i "s|^run  |dump full all custom $every post/full_*.dump ${columns[*]}\ndump_modify full sort id format \"%d$numbers\"\n&|" \
  "$copy/in.$case"
grep -q '^dump_modify full' "$copy/in.$case" || failed "no dump was added"
sed -i -E 's/^(writePrecision +).*/\117;/' "$copy/system/controlDict"

for transport in mpi socket; do
  "$copy/run.sh" --short --ranks "$ranks" --dem-ranks "$dem_ranks" --transport "$transport" \
    --out "$work/$transport"
done

# Both runs do the same sums in the same order; what is left is that of compilers and libraries.
round_off=1e-12

# compare NAME FILE FILE FIRST: the numbers from column FIRST on differ by at most round_off times the
# largest one of their column (all columns as one with FIRST 0) and are not all the same throughout.
compare() {
  awk -v name="$1" -v first="$4" -v tolerance="$round_off" '
    function size(v) { return v < 0 ? -v : v }
    FILENAME == ARGV[1] { line[FNR] = $0; lines = FNR; next }
    {
      if (split(line[FNR], other) != NF) { wrong = "other length in line " FNR; exit }
      for (i = 1; i < first; i++) if ($i != other[i]) { wrong = "other particles in line " FNR; exit }
      for (; i <= NF; i++) {
        column = first ? i : 0
        if (size($i) > largest[column]) largest[column] = size($i)
        if (size($i - other[i]) > off[column]) { off[column] = size($i - other[i]); place[column] = FNR }
        if (!(column in least) || $i + 0 < least[column]) least[column] = $i
        if (!(column in most) || $i + 0 > most[column]) most[column] = $i
        count++
      }
    }
    END {
      if (wrong == "" && (FNR != lines || !count)) wrong = "nothing to compare, or other length"
      for (c in largest) {
        if (off[c] > tolerance*largest[c] && wrong == "") wrong = "column " c ", line " place[c] ": off by " off[c]
        if (most[c] > least[c]) varied++
        if (off[c]/(largest[c] > 0 ? largest[c] : 1) > worst) worst = off[c]/largest[c]
      }
      if (wrong == "" && !varied) wrong = "all numbers are the same: nothing that could differ"
      if (wrong != "") { print "FAILED: " name ": " wrong; exit 1 }
      printf "%s: %d numbers, off by %.2g at most\n", name, count, worst
    }' "$2" "$3"
}

states() {  # folder: name of the dump, id, values
  (cd "$1/post" && awk '/^ITEM: ATOMS/ { rows = 1; next } /^ITEM/ { rows = 0 } rows { print FILENAME, $0 }' full_*.dump)
}
# Numbers of the inner field, those of one cell per line.
values() { awk '/^boundaryField/ { exit } /nonuniform/ { inside = 1 } /^\($/ { list = inside } /^\)/ { if (list) exit } list && /[0-9]/ { gsub(/[()]/, ""); print }' "$1"; }
# The last time, of each processor.
last_times() {  # folder
  (cd "$1" && find . -path './*/uniform/time' ! -path './constant/*') | sed -E 's|^\./||; s|/uniform/time$||' |
    awk -F/ '{ time = $NF + 0; where = NF > 1 ? $1 : "."; if (time > last[where]) { last[where] = time; path[where] = $0 } }
      END { for (w in path) print path[w] }'
}

same_case() {  # name of its folder
  local transport field folder fields=0
  for transport in mpi socket; do states "$work/$transport/$1" >"$work/$transport.txt"; done
  compare "$1: particles" "$work/mpi.txt" "$work/socket.txt" 3
  # The fluid acts: a particle without force would agree with anything.
  awk '{ for (i = 18; i <= 20; i++) if ($i != 0) acts[$1] = 1 } END { for (a in acts) n++; exit !(n >= 5) }' \
    "$work/mpi.txt" || failed "fluid forces in fewer than five dumps"
  # Only weight, along z, and contacts are in LIGGGHTS's own forces.
  if [[ $case == closed_box ]]; then
    awk '$12 != 0 { n++ } END { exit !n }' "$work/mpi.txt" || failed "no contacts between particles"
  fi
  while read -r folder; do
    for field in U p alphaf phi momentumBalance; do
      for transport in mpi socket; do values "$work/$transport/$1/$folder/$field" >"$work/$transport.field"; done
      # No list when it is uniform: alphaf of a one-way run, the balance where nothing is open.
      if [[ $field == alphaf || $field == momentumBalance ]] && [[ ! -s $work/mpi.field ]]; then
        cmp "$work"/{mpi,socket}/"$1/$folder/$field" || failed "$folder/$field differs"
        continue
      fi
      compare "$1/$folder/$field" "$work/mpi.field" "$work/socket.field" 0
      fields=$((fields + 1))
    done
  done < <(last_times "$work/mpi/$1")
  ((fields >= 3*ranks)) || failed "fields of $ranks rank(s): only $fields compared"
}
for folder in "$work"/mpi/case*; do same_case "$(basename "$folder")"; done
