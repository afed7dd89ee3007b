#!/usr/bin/env bash
# pipe_test.sh TEST SOURCE WORK: see CMakeLists.txt. run.sh itself fails when a grain is missing at any
# of its counts, or the rate or the momentum balance is off.
set -euo pipefail
test=$1 case=$2/foam_cases/pipe out=$3/$1
# Of the source's inputs: 5e-7 s.
steps_per_ms=2000
run() { timeout 170 "$case/run.sh" --short --out "$out" "$@"; }
fail() {
  echo "pipe_test: $*" >&2
  exit 1
}
# Nothing in these runs is random or depends on timing: fields, grains and counts agree in every bit.
same_run() {  # folder
  local file folder
  for folder in "$out"/case/0.002 "$out"/case/processor*/0.002; do
    [[ -d $folder ]] || continue
    folder=${folder#"$out/"}
    for file in U p phi alphaf momentumBalance; do
      cmp "$out/$folder/$file" "$1/$folder/$file" || fail "$folder/$file differs from the uninterrupted run"
    done
  done
  # A run that was killed after its last checkpoint dumps the same grains in another order.
  cmp <(sort "$out/case/post/particles_$((2*steps_per_ms)).dump") <(sort "$1/case/post/particles_$((2*steps_per_ms)).dump") ||
    fail "grains differ"
  cmp "$out/case/post/particle_count.csv" "$1/case/post/particle_count.csv" || fail "counts differ"
}
# What fix ave/spatial wrote by parts is what it wrote at once.
same_forces() {  # folder
  cmp <(sed '/^#/d' "$1"/case/post/powder_forces_{0,[1-9]*}.txt) \
    <(sed '/^#/d' "$out/case/post/powder_forces_0.txt") || fail "forces along the pipe differ"
}
# Sets victim to a process of this case, by the beginning of its name; without a fork, so quickly.
find_victim() {
  local process name
  for process in /proc/[0-9]*; do
    if { read -r name <"$process/comm"; } 2>/dev/null && [[ $name == "$1"* ]] &&
      [[ $process/cwd -ef $out/killed/case ]]; then
      victim=${process#/proc/}
      return
    fi
  done
}
# Starts or continues the run and kills a program of it when a file (or FILE.part) of the case appears, or
# a moment [ms] after the first pair of checkpoints. Status 1: the run ended before.
kill_in_run() {  # beginning of the program's name, file or any, moment
  local go_on=() job victim= code=0 begin=$SECONDS state killed=no
  [[ ! -f $out/killed/case/post/restart.$((steps_per_ms/2)) ]] || go_on=(--continue)
  run "${options[@]}" --out "$out/killed" ${go_on[@]+"${go_on[@]}"} >"$out/log.killed" 2>&1 &
  job=$!
  while kill -0 $job 2>/dev/null; do
    [[ -n $victim ]] || find_victim "$1"
    if [[ -z $victim ]]; then
      :
    elif [[ $2 == any ]]; then
      if [[ -f $out/killed/case/post/restart.$((steps_per_ms/2)) ]]; then
        sleep "$(printf '0.%03d' "$3")"
        break
      fi
    elif [[ -e $out/killed/case/$2 || -e $out/killed/case/$2.part ]]; then
      break
    fi
    ((SECONDS < begin + 60)) || fail "nothing to kill within 60 s"
    sleep 0.002
  done
  # A signal reaches a program that has ended and is not waited for yet, too.
  state=$(sed -n 's/^State:[[:space:]]*//p' "/proc/${victim:-none}/status" 2>/dev/null) || true
  if [[ -n $state && $state != [ZX]* ]] && kill -KILL "$victim" 2>/dev/null; then killed=yes; fi
  wait $job || code=$?
  echo "killed $1 at $2${3:+ ($3 ms)}: $killed, status $code"
  [[ $code != 124 ]] || fail "the other program went on after $1 was killed"
  if [[ $killed == no ]]; then
    [[ $code == 0 ]] || fail "the run ended with status $code before $1 was killed: see $out/log.killed"
    return 1
  fi
  [[ $code != 0 ]] || fail "$1 was killed at $2, and the run ended with status 0"
}
# One kill; a run that was quicker is put back to where it began, and the next moment is earlier.
kill_once() {  # beginning of the program's name, file or any
  local moment=
  [[ $2 != any ]] || moment=$((RANDOM%500))
  for attempt in 1 2 3 4; do
    rm -rf "$out/before"
    [[ ! -d $out/killed ]] || cp -a "$out/killed" "$out/before"
    if kill_in_run "$1" "$2" "$moment"; then return; fi
    rm -rf "$out/killed"
    [[ ! -d $out/before ]] || mv "$out/before" "$out/killed"
    [[ -z $moment ]] || moment=$((moment/2))
  done
  fail "$1 was not killed at $2 in $attempt attempts"
}

rm -rf "$out"
case $test in
  one_rank) run --end-time 0.003 ;;
  assumed) run --end-time 0.003 --inputs assumed --case B ;;
  two_ranks) run --end-time 0.002 --ranks 2 --dem-ranks 2 ;;
  socket)
    options=(--end-time 0.002)
    run "${options[@]}"
    run "${options[@]}" --transport socket --out "$out/socket"
    same_run "$out/socket"
    ;;
  jkr) run --end-time 0.002 --contact jkr ;;
  continued | continued_ranks)
    # Stopped at a write time, or after it, so that what was done since is lost.
    options=(--write-interval 0.001) stop=0.001
    [[ $test == continued ]] || options+=(--ranks 2 --dem-ranks 2 --contact jkr) stop=0.0015
    run "${options[@]}" --end-time 0.002
    run "${options[@]}" --end-time $stop --out "$out/stopped"
    run "${options[@]}" --end-time 0.002 --out "$out/stopped" --continue
    [[ $test != continued ]] || same_forces "$out/stopped"
    same_run "$out/stopped"
    [[ $test == continued ]] || exit 0
    code=0
    run --end-time 0.002 --out "$out/stopped" --continue --set friction=0.3 >"$out/refused" 2>&1 || code=$?
    [[ $code == 1 ]] && grep -q 'a run keeps its inputs' "$out/refused" || fail "other inputs in a continued run"
    # New particles beside the fields of 2 ms.
    cd "$out/stopped/case"
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    code=0
    timeout 60 mpirun --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 \
      -np 1 "$POWDERLINK_BIN/liggghts-powderlink" -in in.pipe -var length 0.03 : \
      -np 1 "$POWDERLINK_BIN/powderFoam" >log.other 2>&1 || code=$?
    [[ $code != 0 && $code != 124 ]] || fail "new particles beside old fields: status $code"
    grep -q 'solver goes on from its checkpoint of 0.002 s, dem starts at 0 s' log.other ||
      fail "new particles beside old fields: no clear error in $PWD/log.other"
    ;;
  killed)
    options=(--write-interval 0.0005 --end-time 0.002)
    run "${options[@]}"
    # Again and again one of the programs is killed: when the fluid begins to write its part of a
    # checkpoint (twice, so that two runs go on from one time), when the particles begin theirs, and at
    # some moment.
    seed=${PIPE_TEST_SEED:-20241}
    echo "moments of PIPE_TEST_SEED=$seed"
    RANDOM=$seed
    for round in powderFoam/0.001 powderFoam/0.001 liggghts/post/restart.$((3*steps_per_ms/2)) powderFoam/any liggghts/any; do
      kill_once "${round%%/*}" "${round#*/}"
    done
    run "${options[@]}" --out "$out/killed" --continue
    same_run "$out/killed"
    ;;
  full_disk)
    # The disk of the fluid is full after the first pair of checkpoints, which stays and is enough.
    options=(--write-interval 0.0005 --end-time 0.002)
    run "${options[@]}"
    # A file that gets too long then fails as on a full disk, instead of ending the program.
    mkdir "$out/bin"
    ln -s "$POWDERLINK_BIN"/* "$out/bin"
    rm "$out/bin/powderFoam"
    printf '#!/bin/sh\ntrap "" XFSZ\nexec "%s" "$@"\n' "$POWDERLINK_BIN/powderFoam" >"$out/bin/powderFoam"
    chmod +x "$out/bin/powderFoam"
    POWDERLINK_BIN=$out/bin run "${options[@]}" --out "$out/killed" >"$out/log.killed" 2>&1 &
    job=$! begin=$SECONDS victim= code=0
    until [[ -f $out/killed/case/post/restart.$((steps_per_ms/2)) ]]; do
      [[ -n $victim ]] || find_victim powderFoam
      ((SECONDS < begin + 60)) || fail "no pair of checkpoints within 60 s"
      sleep 0.002
    done
    # Between the log and the fields.
    prlimit --pid "$victim" --fsize=60000 || fail "powderFoam had ended before its disk was full"
    wait $job || code=$?
    [[ $code != 0 && $code != 124 ]] || fail "full disk: status $code"
    cd "$out/killed/case"
    grep -q 'the disk did not take the whole file' log.powderFoam || fail "full disk: no clear error"
    "$POWDERLINK_BIN/powderlink" restart . --dt 5e-7 --json "$out/pair.json" 2>"$out/refused" ||
      fail "full disk: no pair is left"
    grep -qE 'later, but of no use: fields of time 0\.00(1|15|2):' "$out/refused" ||
      fail "full disk: all fields are whole"
    run "${options[@]}" --out "$out/killed" --continue
    same_run "$out/killed"
    ;;
  *) fail "unknown test $test" ;;
esac
