#!/usr/bin/env bash
# coupled_test.sh TEST REPOSITORY BIN FAKE_DEM WORK: powderFoam coupled with a stand-in for LIGGGHTS in the
# periodic box of foam_cases/closed_box (8 x 8 x 8 cells, 4 mm), 216 steel spheres of 60 um.
set -euo pipefail
test=$1 root=$2 bin=$3 fake_dem=$4 work=$5/$1
export WM_PROJECT_DIR=${WM_PROJECT_DIR:-/usr/share/openfoam}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
rm -rf "$work"
mkdir -p "$work"
status=0 under_srun=()
failed() { echo "FAILED: $*" >&2; status=1; }
limit_s=60

new_case() {  # name
  case_dir=$work/$1
  mkdir -p "$case_dir"
  cd "$case_dir"
  cp -r "$root"/foam_cases/closed_box/{0,constant,system} .
  cat >system/caseSettings <<'SETTINGS'
side 4e-3; cells (8 8 8); endTime 4e-4; deltaT 1e-5;
SETTINGS
  # So that fields can be compared and a restart loses nothing.
  sed -i -E 's/^(writePrecision *).*/\118;/' system/controlDict
  cat >constant/couplingProperties <<'DICT'
FoamFile { version 2.0; format ascii; class dictionary; object couplingProperties; }
model               B;
couplingInterval    2;
particleMomentum
{
    type                bridge;
    transport           mpi;
    timeout             20;
    caseName            closed_box;
    coupling            twoWay;
    schedule            staggered;
    momentumExchange    semiImplicit;
    voidFraction        { type smooth; length 5e-4; }
    interpolation       cellPoint;
    forces              (schiller_naumann);
}
DICT
  if [[ -d $work/mesh ]]; then
    cp -r "$work/mesh" constant/polyMesh
  else
    blockMesh >log.blockMesh 2>&1
    cp -r constant/polyMesh "$work/mesh"
  fi
}
change() { sed -i -E "s/^( *$1 +)[^;{]*;/\1$2;/" constant/couplingProperties; }
control() { sed -i -E "s/^($1 +)[^;]*;/\1$2;/" system/controlDict; }
mpi() {  # one mpirun; ranks of the DEM, ranks of powderFoam, words for the DEM
  local dem=$1 foam=$2 parallel=
  shift 2
  local solver=("${under_srun[@]}" "$bin/powderFoam")
  # Longer files fail as on a full disk; in blocks of 512 bytes.
  [[ -z ${limit_blocks:-} ]] || solver=(sh -c "trap '' XFSZ; ulimit -f $limit_blocks; exec \"\$@\"" sh "${solver[@]}")
  [[ $foam == 1 ]] || { parallel=-parallel; decomposePar -force >log.decomposePar 2>&1; }
  timeout $limit_s mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 \
    -np "$dem" "$fake_dem" "$@" : -np "$foam" "${solver[@]}" $parallel >log 2>&1
}
run() { mpi 1 1 "$@" || { failed "$case_dir: exit status $?"; tail -n 20 log >&2; }; }
solver_is_silent() { ! grep -q . <(find . -maxdepth 1 -name '*e-*'); }
below() { awk -v v="$2" -v l="$3" 'BEGIN { exit !(v != "" && v + 0 <= l) }' || failed "$1: $2, above $3"; }
# Largest difference of the numbers of two files, relative to the largest number.
difference() {
  awk '{ gsub(/[();]/, " ") } NR == FNR { for (i = 1; i <= NF; i++) a[FNR, i] = $i; n = FNR; next }
    { for (i = 1; i <= NF; i++) if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) {
        d = $i - a[FNR, i]; if (d < 0) d = -d; if (d > e) e = d
        m = $i < 0 ? -$i : $i; if (m > s) s = m; k++ } }
    END { print (FNR == n && k) ? e/(s > 0 ? s : 1) : "other length" }' "$1" "$2"
}
same_fields() {  # what folder folder tolerance
  for field in U phi p alphaf; do
    below "$1, $field" "$(difference "$2/$field" "$3/$field")" "$4"
  done
}
# Columns of velocity of the DEM's last state, one particle per line.
velocities() { awk 'NR > 1 { print $6, $7, $8 }' "$1"; }
# What the gas holds, what is open and what the particles were given add up to zero; NAME of the run.
books_close() {
  worst=$(awk '/^momentum / { if ($NF > w) w = $NF } END { print NR ? w : "" }' log)
  below "$1, closure in the solver's books" "$worst" 1e-10
  # Independent of those books: the gas's momentum from its fields, the impulse from the DEM.
  awk -v name="$1" '
    FILENAME ~ /log$/ && /^momentum / { gsub(/[()]/, " "); for (c = 0; c < 3; c++) {
      fluid[c] = $(5 + c); dem[c] = $(9 + c); open[c] = $(13 + c) } }
    FILENAME ~ /log$/ && /^taken:/ { for (c = 0; c < 3; c++) taken[c] = $(2 + c) }
    # The last row but one is at the last exchange that the log has; argon of 1.66 kg/m3.
    FILENAME ~ /dat$/ && !/^#/ { gsub(/[()]/, " "); for (c = 0; c < 3; c++) {
      gas[c] = 1.66*row[c]; row[c] = $(2 + c) } }
    END {
      solids = 216*4/3*3.14159265358979*(3e-5)^3
      gas[0] -= 1.66*5*(6.4e-8 - solids)
      for (c = 0; c < 3; c++) { scale += taken[c]^2; a += (taken[c] - dem[c])^2
        b += (fluid[c] + dem[c] + open[c])^2; d += (gas[c] - fluid[c])^2 }
      scale = sqrt(scale)
      a = sqrt(a)/scale; b = sqrt(b)/scale; d = sqrt(d)/scale
      printf "%s: DEM against the books %.3g, their sum %.3g, gas against the books %.3g\n", name, a, b, d
      # PISO leaves a little of the momentum equation.
      exit !(scale > 0 && a < 1e-10 && b < 1e-10 && d < 1e-4) }' \
    log postProcessing/gasMomentum/0/volFieldValue.dat || failed "$1: momentum"
}
error_text() {  # what, texts
  local what=$1
  shift
  for text in "given:" "allowed:" "to do:" "$@"; do
    grep -qF -- "$text" log || failed "$what: the message lacks '$text'"
  done
}
refused() {  # what, texts that the message must hold; words for the DEM in dem_words
  local what=$1 code=0
  shift
  limit_s=30 mpi 1 1 grid=2 ${dem_words:-} || code=$?
  [[ $code != 0 && $code != 124 ]] || failed "$what: exit status $code"
  error_text "$what" "$@"
  solver_is_silent || failed "$what: fields were written"
}

case $test in
  vanished)
    # Particles that fly out of the mesh, or vanish in the middle of an interval: the fluid hears of all
    # that it gave them. In a channel, as their volume must be able to leave the fluid.
    for ranks in 1 2; do
      for how in open=1 "open=1 vanish=0"; do
        new_case "vanished_${ranks}_${how##* }"
        sed -i -E '/^ *(left|right)$/,/}/ { s/cyclic/patch/; /neighbourPatch/d }' system/blockMeshDict
        blockMesh >log.blockMesh 2>&1
        sed -i 's/^boundaryField/bounds/; s/^    ".\*"/    "(front|back|bottom|top)"/' 0/U 0/p
        sed -i 's/^bounds/boundaryField/' 0/U 0/p
        sed -i '/^boundaryField/,/^{/ s/^{/{\n    left { type fixedValue; value uniform (5 0 0); }\n    right { type inletOutlet; inletValue uniform (0 0 0); value uniform (5 0 0); }/' 0/U
        sed -i '/^boundaryField/,/^{/ s/^{/{\n    left { type zeroGradient; }\n    right { type fixedValue; value uniform 0; }/' 0/p
        # shellcheck disable=SC2086
        mpi 1 $ranks $how || { tail -n 20 log >&2; failed "$ranks ranks, $how"; }
        worst=$(awk '/^momentum / { n++; if ($NF > w) w = $NF } END { print n == 20 ? w : "" }' log)
        below "$ranks ranks, $how: closure of 20 exchanges" "$worst" 1e-10
        # Their sum by the DEM.
        differs=$(awk '/^momentum / { gsub(/[()]/, " "); for (c = 0; c < 3; c++) dem[c] = $(9 + c) }
          /^taken:/ { for (c = 0; c < 3; c++) { s += $(2 + c)^2; d += ($(2 + c) - dem[c])^2 } }
          END { print (s > 0) ? sqrt(d/s) : "" }' log)
        below "$ranks ranks, $how: DEM against the books" "$differs" 1e-10
        if [[ $how == *vanish* ]]; then
          last=$(awk '/^exchange 19:/ { print $3 }' log)
          [[ $last -gt 0 && $last -lt 216 ]] || failed "$how: $last of 216 particles at the last exchange"
          grep -q '^exchange 19: .* 0 outside' log || failed "$how: those that have vanished are outside"
        else
          grep -qE '^exchange 19: 216 particles, [1-9]' log || failed "$how: none has left the mesh"
        fi
      done
    done
    ;;
  momentum)
    for exchange in semiImplicit explicit; do
      new_case "$exchange"
      change momentumExchange "$exchange"
      run
      books_close "$exchange"
    done
    ;;
  outer_correctors)
    # PIMPLE repeats the step, not the exchange; with an adjusted step too.
    new_case piso
    run
    new_case pimple
    sed -i -E 's/^(nOuterCorrectors|    nOuterCorrectors) .*/\1 3;/' system/fvSolution
    run
    [[ $(grep -c '^PIMPLE: iteration 3' log) == 40 ]] || failed "not three outer correctors in each of 40 steps"
    books_close "3 outer correctors"
    differs=$(difference <(velocities ../piso/dem.state) <(velocities dem.state))
    echo "particles' velocities with 3 outer correctors instead of 1: $differs"
    # Both are of first order in the time step; the particles change little over a step.
    awk -v d="$differs" 'BEGIN { exit !(d > 0 && d < 1e-4) }' || failed "3 outer correctors: particles differ by $differs"
    cp -r "$PWD" ../adjusted
    case_dir=$work/adjusted
    cd "$case_dir"
    rm -rf 0.0* postProcessing dem.state*
    sed -i -E 's/^couplingInterval.*/couplingTime 2e-5;/' constant/couplingProperties
    sed -i 's/deltaT 1e-5/deltaT 4e-6/' system/caseSettings
    control adjustTimeStep yes
    printf 'maxCo 0.07; maxDeltaT 1;\n' >>system/controlDict
    run
    worst=$(awk '/^momentum / { n++; if ($NF > w) w = $NF } END { print n == 20 ? w : "" }' log)
    below "adjusted step, closure of 20 exchanges" "$worst" 1e-10
    ;;
  turbulent)
    # Force laws take their stress from the model's viscosity.
    turbulent_case() { # name
      new_case "$1"
      change model A
      change forces "(schiller_naumann pressure_gradient viscous_stress)"
      echo 'FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }
simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }' >constant/turbulenceProperties
      sed -i 's/default         none/default Gauss upwind/' system/fvSchemes
      sed -i 's/"U\.\*"/"(U|k|epsilon).*"/' system/fvSolution
      local name dims value
      while read -r name value dims; do
        echo "FoamFile { version 2.0; format ascii; class volScalarField; object $name; }
dimensions $dims; internalField uniform $value; boundaryField { \".*\" { type cyclic; } }" >"0/$name"
      done <<'FIELDS'
k 0.1 [0 2 -2 0 0 0 0]
epsilon 10 [0 2 -3 0 0 0 0]
nut 0 [0 2 -1 0 0 0 0]
FIELDS
    }
    turbulent_case serial
    run
    worst=$(awk '/^momentum / { if ($NF > w) w = $NF } END { print NR ? w : "" }' log)
    below "closure" "$worst" 1e-10
    turbulent_case ranks
    mpi 1 2 || { tail -n 20 log >&2; failed "2 ranks"; }
    below "2 ranks: particles" "$(difference <(velocities ../serial/dem.state) <(velocities dem.state))" 1e-8
    ;;
  fields)
    # Held particles in a stream of 5 m/s, one interval: summed over the mesh, the flux of their volume
    # and the drag coefficients of Schiller and Naumann.
    for ranks in 1 2; do
      new_case "fields_$ranks"
      sed -i 's/^ *forces .*/&\n    writeFields (Us Ksl);/' constant/couplingProperties
      sed -i 's/endTime 4e-4/endTime 2e-5/' system/caseSettings
      mpi 1 $ranks fixed=1 || { tail -n 20 log >&2; failed "$ranks ranks"; }
      [[ $ranks == 1 ]] || reconstructPar >log.reconstructPar 2>&1
      for name in alphaf Us Ksl; do
        awk '/^internalField/ { on = 1 } /^boundaryField/ { exit }
          on && /^\(?-?[0-9.]+(e-?[0-9]+)?( |$)/ && NR > 1 { gsub(/[()]/, " "); if (n++) print }' "2e-05/$name" >"$name"
      done
      paste alphaf Us Ksl | awk 'FILENAME == "-" { cell = 6.4e-8/512; V += (1 - $1)*cell; K += $5*cell
            for (c = 1; c <= 3; c++) q[c] += (1 - $1)*cell*$(1 + c); next }
        FNR > 1 { v = 4/3*3.14159265358979*$2^3; volume += v; slip = 0
          for (c = 1; c <= 3; c++) { flux[c] += v*$(5 + c); slip += ((c == 1 ? 5 : 0) - $(5 + c))^2 }
          Re = sqrt(slip)*2*$2/1.3433734940e-5
          drag += 6*3.14159265358979*2.23e-5*$2*(1 + 0.15*Re^0.687) }
        END { for (c = 1; c <= 3; c++) { d += (q[c] - flux[c])^2; s += flux[c]^2 }
          printf "%.3g %.3g %.3g\n", V/volume - 1, (s > 0) ? sqrt(d/s) : "", K/drag - 1 }' - dem.state >sums
      read -r volume flux drag <sums
      echo "$ranks ranks: solids, flux and drag differ by $volume $flux $drag"
      below "$ranks ranks: volume of the solids" "${volume#-}" 1e-10
      below "$ranks ranks: Us" "${flux#-}" 1e-10
      # Drag in model B is larger by 1/alphaf.
      below "$ranks ranks: Ksl" "${drag#-}" 2e-3
    done
    ;;
  one_way)
    new_case two
    run
    new_case one
    change coupling oneWay
    run
    # The uniform stream in a periodic box stays as it is.
    awk '/^momentum/ { exit 1 }' log || failed "one way: momentum was exchanged"
    bad=$(awk '/^internalField/ { u = 1 } u && /^\(/ && NF == 3 { gsub(/[()]/, " ")
      e = ($1 - 5)^2 + $2^2 + $3^2; if (e > w) w = e } /^boundaryField/ { exit } END { print sqrt(w) }' 0.0004/U)
    below "one way: change of the stream" "$bad" 1e-9
    below "one way: particles differ from two-way ones" \
      "$(awk -v d="$(difference <(velocities dem.state) <(velocities ../two/dem.state))" \
        'BEGIN { print (d + 0 > 1e-6) ? 0 : 1 }')" 0
    ;;
  transports)
    new_case mpi
    run
    new_case socket
    change transport socket
    timeout $limit_s "$bin/powderFoam" >log 2>&1 &
    foam=$!
    timeout $limit_s "$fake_dem" transport=socket >log.dem 2>&1 || failed "socket: DEM"
    wait $foam || { tail -n 20 log >&2; failed "socket: powderFoam"; }
    same_fields "mpi and socket" ../mpi/0.0004 0.0004 1e-14
    ;;
  decomposed)
    # All directions are cyclic: values at points of the patches must not depend on the ranks either.
    new_case serial
    run
    for ranks in "1 2" "2 2"; do
      new_case "ranks_${ranks// /_}"
      # shellcheck disable=SC2086
      mpi $ranks || { tail -n 20 log >&2; failed "$ranks ranks"; }
      differs=$(difference <(velocities ../serial/dem.state) <(velocities dem.state))
      echo "$ranks ranks: particles' velocities differ by $differs"
      below "$ranks ranks: particles" "$differs" 1e-8
      worst=$(awk '/^momentum / { if ($NF > w) w = $NF } END { print w }' log)
      below "$ranks ranks: closure" "$worst" 1e-10
    done
    ;;
  ties)
    # Grains on faces, edges and corners of cells, on cyclic patches and on the planes between ranks, held.
    # Their cell is what counts: it gives the velocity of the gas and takes their volume and drag.
    for ranks in 1 "2 (1 1 2)" "2 (2 1 1)" "4 (1 2 2)"; do
      name=ranks_${ranks//[ ()]/}
      new_case "$name"
      sed -i 's/endTime 4e-4/endTime 6e-5/' system/caseSettings
      change interpolation cell
      sed -i -E 's/type smooth; length 5e-4/type centre/' constant/couplingProperties
      sed -i -E "s/^( *n +).*/\1${ranks#* };/" system/decomposeParDict
      sed -i -E "s/^(numberOfSubdomains +).*/\1${ranks%% *};/" system/decomposeParDict
      awk 'BEGIN { printf "0 10\n"; split("0.50 2.25 2.25|2.00 2.25 2.75|1.25 2.00 2.00|2.00 2.00 2.00|3.0 1.0 3.5|" \
          "0.00 1.25 1.25|0.00 0.00 3.25|0.00 0.00 0.00|3.25 0.00 2.00|1.00 3.00 1.25", at, "|")
        for (i = 1; i <= 10; i++) { split(at[i], x, " ")
          print i, 5e-5, x[1]*1e-3, x[2]*1e-3, x[3]*1e-3, 0, 0.3*i, 0.1*i, 0, 0, 0 } }' >dem.start
      mpi 1 "${ranks%% *}" state=dem.start fixed=1 || { tail -n 20 log >&2; failed "$ranks ranks"; }
      grep -q '^exchange 2: 10 particles, 0 outside' log || failed "$ranks ranks: grains are outside"
      impulses() { awk 'NR > 1 { print $9, $10, $11 }' "$1"; }
      differs=$(difference <(impulses ../ranks_1/dem.state) <(impulses dem.state))
      echo "$ranks ranks: impulses differ by $differs"
      # As far as the solution of the equations is closed.
      below "$ranks ranks: impulses of grains on faces" "$differs" 1e-8
    done
    ;;
  restart)
    # With each exchange, and with the ramp and the open balance in full swing.
    for exchange in semiImplicit explicit; do
      new_case "whole_$exchange"
      change momentumExchange "$exchange"
      control writeInterval 2e-4
      run
      [[ -f dem.state.100 ]] || failed "no checkpoint of the DEM at the write time"
      whole=$PWD
      new_case "again_$exchange"
      change momentumExchange "$exchange"
      control writeInterval 2e-4
      control startFrom latestTime
      cp -r "$whole/0.0002" .
      run state="$whole/dem.state.100"
      same_fields "$exchange, restart" "$whole/0.0004" 0.0004 1e-10
      below "$exchange, restart: particles" "$(difference "$whole/dem.state" dem.state)" 1e-10
      # From the first exchange on, when nothing but the open balance has been taken over.
      worst=$(awk '/^momentum / { n++; if ($NF > w) w = $NF } END { print n == 10 ? w : "" }' log)
      below "$exchange, restart: closure of 10 exchanges" "$worst" 1e-10
    done
    ;;
  halves)
    # A time folder that is no whole checkpoint is refused before it is read, by all ranks and once.
    new_case whole
    control writeInterval 2e-4
    run
    new_case whole_2
    control writeInterval 2e-4
    mpi 1 2 || failed "2 ranks: status $?"
    names=$(sed -n -E 's/^files +"(.*)";$/\1/p' ../whole/0.0002/uniform/couplingClock)
    [[ $names == "U alphaf momentumBalance p phi" ]] || failed "the checkpoint names '$names'"
    damaged() {  # what, ranks, the message's text, a command that damages the files of time 0.0002
      local code=0
      new_case "damaged_${1// /_}"
      control startFrom latestTime
      control writeInterval 2e-4
      if [[ $2 == 1 ]]; then cp -r ../whole/0.0002 .; else
        cp -r ../whole_2/processor? .
        rm -r processor?/0.0004
      fi
      eval "$4"
      limit_s=30 mpi 1 "$2" state="$work/whole/dem.state.100" || code=$?
      [[ $code != 0 && $code != 124 ]] || failed "$1: exit status $code"
      error_text "$1" "checkpoint of the fluid at the start, time 0.0002 s" "$3" "powderlink restart CASE"
      [[ $(grep -c 'given:' log) == 1 ]] || failed "$1: said more than once"
      [[ ! -e 0.0004 && ! -e processor0/0.0004 ]] || failed "$1: the run went on"
    }
    cut() { truncate -s $(($(stat -c %s "$1")/2)) "$1"; }
    damaged "no balance" 1 "0.0002/momentumBalance is missing" "rm 0.0002/momentumBalance"
    damaged "no clock" 1 "0.0002/uniform/couplingClock is missing" "rm 0.0002/uniform/couplingClock"
    damaged "cut flux" 1 "0.0002/phi breaks off" "cut 0.0002/phi"
    decomposePar() { :; }  # the processors' folders are there
    damaged "no balance on 2 ranks" 2 "0.0002/momentumBalance is missing" "rm processor?/0.0002/momentumBalance"
    damaged "no flux of one rank" 2 "processor1/0.0002/phi is missing" "rm processor1/0.0002/phi"
    damaged "empty clock of one rank" 2 "processor1/0.0002/uniform/couplingClock breaks off" \
      ": >processor1/0.0002/uniform/couplingClock"
    ;;
  between)
    # The end between two exchanges is said, before and after; at one nothing is.
    new_case at_one
    run
    ! grep -q 'between two exchanges' log || failed "an end at an exchange is warned of"
    new_case step_before
    sed -i 's/endTime 4e-4/endTime 3.9e-4/' system/caseSettings
    control writeInterval 2e-4
    control writePrecision 8  # of the log's numbers, too
    run
    error_text "endTime between" "Warning: endTime lies between two exchanges" "given:   endTime 0.00039 s" \
      "set endTime 0.00038 or 0.0004" "the gas is at 0.00039 s, the particles are at 0.00038 s"
    new_case stopped
    control runTimeModifiable true
    control stopAt nextWrite
    control writeInterval 2e-4
    run
    [[ -f dem.state.100 ]] || failed "stopped at a write: no checkpoint"
    ! grep -q 'between two exchanges' log || failed "stopped at an exchange: a warning"
    # Steps that do not come to the time of the exchange.
    new_case steps
    sed -i -E 's/^couplingInterval.*/couplingTime 2.5e-5;/' constant/couplingProperties
    refused "couplingTime that is no whole number of steps" "entry deltaT" "with couplingTime 2.5e-05 s" \
      "set deltaT 8.33333e-06"
    ;;
  moments)
    # A difference of the clocks is kept with the fields; other pairs are refused by both programs.
    new_case ahead
    control writeInterval 2e-4
    run first_step=1000
    grep -q 'time is ours plus 0.0020*[0-9]* s' log || failed "the clocks do not differ"
    ahead=$PWD
    again() {
      new_case "$1"
      control writeInterval 2e-4
      control startFrom latestTime
      cp -r "$ahead/0.0002" .
    }
    again same
    run state="$ahead/dem.state.1100"
    same_fields "clocks that differ, restart" "$ahead/0.0004" 0.0004 1e-10
    for state in first_step=1000 first_step=0 state="$ahead/dem.state.1200"; do
      again "other_${state##*[=.]}"
      refused "particles of another moment, $state" "solver goes on from its checkpoint of 0.0002 s" \
        "dem at 0.0022 s"
      [[ ! -d 0.0004 ]] || failed "$state: the run went on"
    done
    ;;
  full_disk)
    # Files that cannot be looked at.
    new_case collated
    code=0
    FOAM_FILEHANDLER=collated mpi 1 2 || code=$?
    [[ $code != 0 && $code != 124 ]] || failed "collated files: status $code"
    error_text "collated files" "file handler of a coupled run" "given:   collated" "uncollated"
    # Of both kinds: a file that breaks off in the middle, and one that lacks its last bytes only, which
    # OpenFOAM does not notice. Both programs stop, and the DEM is not told to make its part of a pair.
    new_case enough
    control writeInterval 2e-4
    run
    for ranks in 1 2; do
      largest=$(find ../enough/0.0002 -type f -printf '%s\n' | sort -n | tail -n 1)
      for limit_blocks in $((largest/512/ranks/2)) $(((largest - 1)/512)); do
        # The sizes of two ranks' files are not known before.
        [[ $ranks == 2 && $limit_blocks == $(((largest - 1)/512)) ]] && continue
        new_case "full_${ranks}_$limit_blocks"
        control writeInterval 2e-4
        what="full disk, $ranks ranks, $limit_blocks blocks" code=0
        mpi 1 $ranks || code=$?
        [[ $code != 0 && $code != 124 ]] || failed "$what: status $code"
        error_text "$what" "checkpoint of the fluid" "the disk did not take the whole file" "0.0002/"
        [[ ! -e dem.state.100 ]] || failed "$what: half a pair"
      done
      unset limit_blocks
    done
    ;;
  post_process)
    # Function objects on a run of before, which has nobody to couple with, over either transport.
    new_case run
    run
    for transport in mpi socket; do
      change transport $transport
      timeout 20 "$bin/powderFoam" -postProcess -func 'mag(U)' >log.post 2>&1 ||
        failed "$transport: status $? of -postProcess"
      [[ -s 0.0004/mag\(U\) && -s 0/mag\(U\) ]] || { failed "$transport: no mag(U)"; tail -n 20 log.post >&2; }
      ! grep -qi warning log.post || failed "$transport: warnings of -postProcess"
      [[ ! -e bridge.address ]] || failed "$transport: an address was published"
      rm -f {0,0.0004}/mag\(U\)
    done
    ;;
  slow_start)
    # The first thing that powderFoam does, with one rank too, is to meet the other program, whose wait for
    # that is short: here the settings of the case come only after that one has met it.
    new_case serial
    cp system/caseSettings settings
    rm system/caseSettings
    mkfifo dem.start system/caseSettings
    { printf '0 1\n3 3e-5 1e-3 1e-3 1e-3 0 0 0 0 0 0\n' >dem.start && cat settings >system/caseSettings; } &
    feeder=$!
    run state=dem.start exchanges=2
    kill $feeder 2>/dev/null || true
    # srun --mpi=pmix tells the number of its processes in another variable than mpirun.
    rm -rf 0.0* dem.state*
    { printf '0 1\n3 3e-5 1e-3 1e-3 1e-3 0 0 0 0 0 0\n' >dem.start && cat settings >system/caseSettings; } &
    feeder=$!
    under_srun=(env -u OMPI_COMM_WORLD_SIZE SLURM_STEP_NUM_TASKS=2)
    run state=dem.start exchanges=2
    kill $feeder 2>/dev/null || true
    ;;
  traps)
    # MPI starts in a powderFoam that traps floating-point exceptions already. Where it reads the machine's
    # topology as XML, as SLURM hands it out, libxml2 makes its infinity and its NaN by dividing by zero.
    new_case topology
    sets='cpuset="0x1" complete_cpuset="0x1" nodeset="0x1" complete_nodeset="0x1"'
    cat >topology.xml <<XML
<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE topology SYSTEM "hwloc2.dtd">
<topology version="2.0">
  <object type="Machine" os_index="0" $sets allowed_cpuset="0x1" allowed_nodeset="0x1" gp_index="1">
    <object type="NUMANode" os_index="0" $sets gp_index="2" local_memory="1073741824"/>
    <object type="Core" os_index="0" $sets gp_index="3">
      <object type="PU" os_index="0" $sets gp_index="4"/>
    </object>
  </object>
</topology>
XML
    for ranks in 1 2; do
      HWLOC_XMLFILE=$PWD/topology.xml mpi 1 $ranks exchanges=2 || {
        failed "topology as XML, $ranks ranks: status $?"
        tail -n 20 log >&2
      }
    done
    # What divides by zero afterwards is caught as ever.
    new_case trapped
    echo "libs (\"$(dirname "$fake_dem")/libdividesByZero.so\");" >>system/controlDict
    code=0
    limit_s=30 mpi 1 1 || code=$?
    [[ $code != 0 && $code != 124 ]] || failed "division by zero: status $code"
    grep -q 'sigFpe::sigHandler' log || failed "division by zero: not trapped"
    ;;
  schedules)
    # Both are of first order in the interval D: the distance from a run with short intervals halves with
    # it. Concurrent lags in all, staggered in all but the fluid's velocity that the particles see.
    velocity_of() {  # name schedule steps-per-interval
      new_case "$1"
      change schedule "$2"
      change couplingInterval "$3"
      sed -i 's/deltaT 1e-5/deltaT 5e-6/; s/endTime 4e-4/endTime 9.6e-4/' system/caseSettings
      run dt=5e-7 every=$((10*$3)) radius=1.5e-5
      velocities dem.state >velocities
    }
    velocity_of reference staggered 1
    for schedule in staggered concurrent; do
      velocity_of "coarse_$schedule" $schedule 16
      velocity_of "fine_$schedule" $schedule 8
      coarse=$(difference ../reference/velocities ../coarse_$schedule/velocities)
      fine=$(difference ../reference/velocities ../fine_$schedule/velocities)
      echo "error of $schedule: $coarse with D, $fine with D/2"
      awk -v a="$coarse" -v b="$fine" 'BEGIN { exit !(a > 1e-5 && a/b > 1.6 && a/b < 2.6) }' ||
        failed "$schedule: errors $coarse and $fine are not of first order"
    done
    # The fluid fraction comes without jumps: the pressure has no peak at exchanges.
    new_case ramp
    change couplingInterval 4
    cat >>system/controlDict <<'DICT'
functions
{
    pressure { type fieldMinMax; libs (fieldFunctionObjects); fields (p);
        location no; mode component; writeControl timeStep; writeInterval 1; log no; }
}
DICT
    run every=20 radius=6e-5
    # The ramp's slope changes at exchanges, which one step's pressure feels: 1.6. Without a ramp it is 5.
    peak=$(awk '!/^#/ { p = $3 > -$2 ? $3 : -$2; if (n >= 8) s[n%4 < 2] += p; n++ }
      END { print (n > 20) ? s[1]/s[0] : "" }' postProcessing/pressure/0/fieldMinMax.dat)
    below "pressure after exchanges over that before them" "$peak" 2.5
    ;;
  ends)
    new_case solver_first
    run
    [[ -f dem.state.200 && -f 0.0004/U ]] || failed "no pair of checkpoints at the end"
    grep -q '^coupling share: ' log || failed "no coupling share"
    new_case dem_first
    run exchanges=5
    grep -q 'The program of the particles has finished at time 0.0001 s' log || failed "DEM first: no message"
    [[ -f 0.0001/U ]] || failed "DEM first: no fields"
    for ranks in 1 2; do
      new_case "dem_ends_$ranks"
      begin=$(date +%s)
      mpi 1 $ranks exchanges=5 || failed "DEM ends, $ranks ranks: status $?"
      limit_death_s=$(($(date +%s) - begin + 5)) # start and five exchanges on this machine
      new_case "dem_dies_$ranks"
      code=0 begin=$(date +%s)
      mpi 1 $ranks die_at=5 || code=$?
      # Of a program that is killed nobody but mpirun can tell.
      [[ $code != 0 && $code != 124 && $(($(date +%s) - begin)) -le $limit_death_s ]] ||
        failed "DEM dies, $ranks ranks: status $code after $(($(date +%s) - begin)) s"
      grep -q 'Exit code: *3' log || failed "DEM dies, $ranks ranks: mpirun does not say who died"
    done
    new_case dem_dies_socket
    change transport socket
    timeout $limit_s "$fake_dem" transport=socket die_at=5 >log.dem 2>&1 &
    dem=$! code=0
    timeout 10 "$bin/powderFoam" >log 2>&1 || code=$?
    wait $dem || true
    [[ $code != 0 && $code -lt 124 ]] || failed "DEM dies, socket: status $code"
    error_text "DEM dies, socket" "dem"
    # An error of the solver in the middle of the run ends both.
    for ranks in 1 2; do
      new_case "solver_fails_$ranks"
      sed -i '/^model/a maxCoFatal 0.01;' constant/couplingProperties
      code=0
      limit_s=15 mpi 1 $ranks || code=$?
      [[ $code != 0 && $code != 124 ]] || failed "solver fails, $ranks ranks: status $code"
      error_text "solver fails, $ranks ranks" "Courant number above its limit" \
        "fake_dem: run of solver" "its error: Courant number above its limit"
    done
    # The program of the particles says why, too.
    new_case solver_fails_socket
    change transport socket
    sed -i '/^model/a maxCoFatal 0.01;' constant/couplingProperties
    code=0
    timeout 10 "$bin/powderFoam" >log.foam 2>&1 &
    foam=$!
    timeout 10 "$fake_dem" transport=socket >log 2>&1 || code=$?
    [[ $code != 0 && $code != 124 ]] || failed "solver fails, socket: status $code of the DEM"
    error_text "solver fails, socket" "its error: Courant number above its limit"
    code=0
    wait $foam || code=$?
    [[ $code != 0 && $code -lt 124 ]] || failed "solver fails, socket: status $code"
    grep -qF "Courant number above its limit" log.foam || failed "solver fails, socket: no message"
    ;;
  adjusted_step)
    new_case adjusted
    sed -i -E 's/^couplingInterval.*/couplingTime 2e-5;/' constant/couplingProperties
    sed -i 's/deltaT 1e-5/deltaT 4e-6/' system/caseSettings
    control adjustTimeStep yes
    printf 'maxCo 0.07; maxDeltaT 1;\n' >>system/controlDict
    run
    # 21 exchanges from 0 on, of which the last is answered by the end.
    [[ $(grep -c '^momentum ' log) == 20 ]] || failed "exchanges: $(grep -c '^momentum ' log) instead of 20"
    [[ -f 0.0004/U ]] || failed "no fields at the end time"
    grep -q '^Coupling: model B, every 2[.0-9]*e-05 s, ' log || failed "the log does not have couplingTime"
    steps=$(grep -c '^Time = ' log)
    [[ $steps -gt 40 && $steps -lt 100 ]] || failed "$steps steps"
    ;;
  refusals)
    new_case bad
    cp constant/couplingProperties good
    again() { cp good constant/couplingProperties; rm -rf 0.0*; }
    change caseName other
    refused "case name" "closed_box" "other"
    again; change couplingInterval 4
    refused "interval" "interval between exchanges"
    again; sed -i 's/interpolation /interpolaton /' constant/couplingProperties
    refused "misspelt entry" "unknown entry" "interpolaton" "voidFraction interpolation forces"
    again; sed -i '/voidFraction/d' constant/couplingProperties
    refused "missing entry" "missing entry voidFraction" "voidFraction interpolation forces"
    again; sed -i -E 's/^( *voidFraction).*/\1 smooth;/' constant/couplingProperties
    refused "no dictionary" "entry voidFraction" "given:   smooth" "{ type smooth; length"
    again; change forces gidaspow
    refused "no list" "entry forces" "given:   gidaspow" "schiller_naumann"
    again; change timeout soon
    refused "no number" "entry timeout" "given:   soon"
    again; change schedule stagered
    refused "misspelt value" "stagered" "staggered"
    again; sed -i 's/schiller_naumann/schiler_naumann/' constant/couplingProperties
    refused "misspelt force" "schiler_naumann" "schiller_naumann"
    again; sed -i 's/type smooth/type smoth/' constant/couplingProperties
    refused "misspelt void fraction" "smoth" "divided"
    again; control writeInterval 3e-5
    refused "write interval" "writeInterval"
    control writeInterval 4e-4
    control adjustTimeStep yes
    refused "adjusted step without couplingTime" "couplingTime"
    # Steps of unknown length have no known step at an exchange.
    sed -i -E 's/^couplingInterval.*/couplingTime 2e-5;/' constant/couplingProperties
    control writeControl timeStep
    control writeInterval 20
    refused "writing by steps that are adjusted" "writeControl" "timeStep, with adjustTimeStep yes"
    again
    control adjustTimeStep no
    control writeControl clockTime
    refused "writing by the wall clock" "entry writeControl" "given:   clockTime"
    control writeControl adjustableRunTime
    control writeInterval 4e-4
    # The older pair would be gone before the newer one is whole.
    again; echo 'purgeWrite 1;' >>system/controlDict
    refused "purge to one" "entry purgeWrite" "given:   1" "at least 2"
    sed -i '/^purgeWrite/d' system/controlDict
    again; sed -i '/^model/a couplingTime 2e-5;' constant/couplingProperties
    refused "couplingTime beside couplingInterval" "couplingTime"
    again; sed -i '/^rho/d' constant/transportProperties
    refused "no density" "rho"
    cp "$root/foam_cases/closed_box/constant/transportProperties" constant
    again; sed -i 's/^transportModel .*/transportModel powerLaw; powerLawCoeffs { nuMax 1e-3; nuMin 1e-6; k 1e-5; n 1; }/' constant/transportProperties
    refused "a viscosity that varies" "transportModel" "powerLaw" "Newtonian"
    cp "$root/foam_cases/closed_box/constant/transportProperties" constant
    again; change forces "(schiller_naumann buoyancy)"
    refused "buoyancy without gravity" "entry forces" "given:   buoyancy, and no gravity" "constant/g"
    again; sed -i 's/length 5e-4/length 0.1/' constant/couplingProperties
    refused "smoothing beyond the mesh" "entry length" "on this mesh, because of its smallest cells"
    # What shows at an exchange: the program of the particles says why it stops, too.
    again; change momentumExchange explicit
    sed -i -E 's/^(nu +).*/\11;/' constant/transportProperties
    refused "drag that is too strong for explicit" "its error: bad value of entry momentumExchange" \
      "given:   explicit, where the drag changes" "set momentumExchange semiImplicit"
    cp "$root/foam_cases/closed_box/constant/transportProperties" constant
    again; sed -i -E 's/type smooth; length 5e-4/type centre/' constant/couplingProperties
    dem_words=radius=3e-4 refused "particles as large as cells" "its error: void fraction model centre cannot serve this mesh" \
      "minFluidFraction = 0.2"
    again
    dem_words=skip=3 refused "clocks" "its error: the clocks of the two programs go apart" "a constant difference"
    # One mpirun, and a powderFoam that does not couple over it.
    again; change transport socket
    refused "socket in one mpirun" "transport socket, which is for two jobs"
    again; rm constant/couplingProperties
    refused "no coupling in one mpirun" "a run of powderFoam without particles"
    # Particles beside the mesh.
    again
    code=0
    limit_s=30 mpi 1 1 low=1 side=4e-3 || code=$?
    [[ $code != 0 && $code != 124 ]] || failed "domains apart: status $code"
    error_text "domains apart" "do not overlap" "(0 0 0)"
    # Half of them: counted, with ids, and the run goes on.
    again
    mpi 1 1 low=-1e-3 exchanges=2 fixed=1 || failed "some outside: status $?"
    # Three of six layers of the lattice lie below 0, in each direction.
    grep -qE '^exchange 0: 216 particles, [1-9][0-9]* outside' log || failed "some outside: not counted"
    grep -qE 'outside the mesh.* 3 at \(-' log || failed "some outside: no ids and positions"
    ;;
  *)
    echo "unknown test: $test" >&2
    exit 2
    ;;
esac
exit $status
