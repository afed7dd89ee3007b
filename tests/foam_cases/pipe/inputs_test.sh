#!/usr/bin/env bash
# inputs_test.sh SOURCE WORK: what follows from the inputs of foam_cases/pipe, against figures of the
# source and closed forms, and what is refused, before anything runs.
set -euo pipefail
case=$1/foam_cases/pipe out=$2/inputs
fail() {
  echo "inputs_test: $*" >&2
  exit 1
}
rm -rf "$out"
mkdir -p "$out"
cd "$case"
. ../../scripts/foam_case.sh
. ./inputs.sh

derive() {  # variant, case, NAME=VALUE...
  pipe_inputs_read "inputs/$1"
  pipe_inputs_set "${@:3}"
  pipe_inputs_derive "$2" "$out/in.powder"
}
near() {  # name, value, relative tolerance
  awk -v x="${input[$1]}" -v y="$2" -v t="$3" 'BEGIN { exit !((x - y)^2 <= (t*y)^2) }' ||
    fail "$1 is ${input[$1]}, not $2 within $3"
}
printed=0.005  # three digits are printed

# The source prints a Rayleigh time of 2.13e-6 s for its smallest grain, of 40 um.
derive source A
near rayleighTime "$(pipe_calculate '2.13e-6*smallestGrain/20e-6')" $printed
near restitution 0.845 $printed
near inletSpeed 10 1e-9
near grainMass 1.009e-9 1e-4
near largestGrain 53.75e-6 1e-9
near sliderStep "$(pipe_calculate '5e-6/83')" 1e-3  # steps that the source prints
derive source B
near sliderStep "$(pipe_calculate '1e-5/144')" 1e-3
near inletSpeed 5 1e-9
near grainMass 1.028e-9 1e-4
# e = 0.9, printed beside alpha = 0.12, belongs to 0.0749; each leads back to the other.
derive source A restitution=0.9
near alpha 0.0749 $printed
derive source A alpha="${input[alpha]}"
near restitution 0.9 1e-8
derive source A alpha=0
near restitution 1 1e-12
derive source A reducedModulus=1.1593e7
near youngsModulus 2.11e7 1e-4
derive assumed B
near reducedModulus 2.11e7 $printed
near grainMass 9.421e-10 1e-4
near inletSpeed 1 1e-9
near dt 4e-7 1e-9
near insertEvery 500 1e-9

# Exchanges are whole numbers of steps, at most a quarter of the Rayleigh time, of modulus to 100 times.
for modulus in 5e6 2.11e7 3.84e7 1e8 7.3e8 2e9; do
  derive source A youngsModulus=$modulus
  pipe_holds 'every == int(every) && dt <= 0.25*rayleighTime && dt >= 0.15*rayleighTime' ||
    fail "step of $modulus Pa: ${input[dt]} s, Rayleigh time ${input[rayleighTime]} s"
done

# The slider does at least one step in each of LIGGGHTS's; history reads none.
derive source A youngsModulus=2e9
near sliderStep "${input[dt]}" 1e-12
derive source A tangential=history
near sliderStep "${input[dt]}" 1e-12
derive source A sliderStep=1e-7
near sliderStep 1e-7 1e-12

# 61 points on the disk, the nearest ones a pitch apart, as many on each side of every axis of symmetry.
for variant in source assumed; do
  derive $variant A
  ./make_stl.sh "$out/stl" "${input[diskDiameter]}" "${input[pitch]}"
  awk -v disk="${input[diskDiameter]}" -v pitch="${input[pitch]}" '
    /outer loop/ { n++ }
    /vertex/ { x[n] += $2/3; y[n] += $3/3 }
    END {
      for (i = 1; i <= n; i++) {
        sx += x[i]; sy += y[i]
        far = sqrt(x[i]^2 + y[i]^2); if (far > most) most = far
        for (j = 1; j < i; j++) {
          d = sqrt((x[i] - x[j])^2 + (y[i] - y[j])^2)
          if (!least || d < least) least = d
        }
      }
      size = 2e-6  # of the triangles that mark the points
      exit !(n == 61 && most <= disk/2 + size && most > disk/2 - size && (least/pitch - 1)^2 < 1e-8 &&
        (sx/n)^2 + (sy/n)^2 < size^2)
    }' "$out/stl/sites.stl" || fail "points of $variant"
done

# Refused: what, figures that the message has, arguments.
refused() {  # figures..., --, arguments of run.sh
  local figures=() figure code=0
  while [[ $1 != -- ]]; do figures+=("$1"); shift; done
  shift
  ./run.sh --short --out "$out/run" "$@" >"$out/refused" 2>&1 || code=$?
  [[ $code == 1 ]] || fail "$*: status $code"
  for figure in "; given: " "; allowed: " "; to do: " "${figures[@]}"; do
    grep -qF -- "$figure" "$out/refused" || fail "$*: no '$figure' in: $(cat "$out/refused")"
  done
  [[ ! -e $out/run ]] || fail "$*: something has run"
}
refused "two inputs contradict each other" "alpha 0.12 and restitution 0.9" 0.8446 -- \
  --set alpha=0.12 --set restitution=0.9
refused "youngsModulus 2.11e7 and reducedModulus 2.11e7" 1.159e+07 -- \
  --set youngsModulus=2.11e7 --set reducedModulus=2.11e7
refused "meanMass 1e-9 and sizeScale 70e-6" -- --set meanMass=1e-9 --set sizeScale=70e-6
# The disk may be as wide as the pipe less the largest grain: 2 (0.625 - 0.05375) mm = 1.1425 mm.
refused "does not fit the pipe" 1.143e-3 53.75e-6 6.25e-4 0.0011425 -- --set diskDiameter=1.143e-3
refused "closer than the largest grain" 1.07e-4 0.0001075 -- --set pitch=1.07e-4
refused "layers of injected grains overlap" "0.0001 m between layers at 1 m/s" 0.0001075 -- \
  --set inletOverGas=0.1
refused "no powder has this mean mass" 1e-8 3.208e-10 2.628e-09 -- --set meanMass=1e-8
refused "coefficient of restitution" 0.01 "0.05 to 1" -- --set restitution=0.01
refused "no grain rebounds" 2.236 -- --set alpha=2.24
refused "too soft" "at least 5e6 Pa" -- --set youngsModulus=4e6
refused "bad step of the slider" 1e-6 5e-07 -- --set sliderStep=1e-6
refused "unknown tangential model" spring "history, spring_slider_dashpot" -- --set tangential=spring
refused "bad value of an input" friction=-0.3 -- --set friction=-0.3
refused "unknown input" grains=3 -- --set grains=3
refused "unknown inputs" other "source, assumed" -- --inputs other
refused "unknown case" C "A, B" -- --case C
