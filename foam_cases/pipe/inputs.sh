#!/usr/bin/env bash
# The inputs of the case; sourced by run.sh and sensitivity.sh.
#   pipe_inputs_read FILE          variables of a LIGGGHTS script (index) into the table `input`
#   pipe_inputs_set NAME=VALUE...  single ones instead of those of the file
#   pipe_inputs_derive CASE POWDER     refuses what contradicts itself or does not fit, adds what follows:
#                                  case A or B; writes the powder to the file POWDER
#   pipe_inputs_write FILE         all of them, to be included by in.pipe
# Two names may stand for one thing. A value that is set replaces the file's other one; two values that
# are set, or that stand in one file, must belong together.

declare -A input=()
pipe_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
pipe_couplings_s=1e-4   # from exchange to exchange: deltaT of caseSettings times couplingInterval
pipe_layer_grains=30
pipe_rayleigh_part=0.25
pipe_digits=0.01        # two values of one thing may differ by so much: they are printed with 2 digits

pipe_inputs_read() {  # file
  local name value
  input=()
  while IFS=$'\t' read -r name value; do input[$name]=$value; done < <(awk '
    $1 == "variable" && $3 == "index" {
      name = $2
      sub(/^[^"]*index[ \t]+/, "")
      sub(/[ \t]*#.*/, "")
      gsub(/"/, "")
      print name "\t" $0
    }' "$1")
}

# The other name of the same thing, or nothing.
pipe_inputs_twin() {
  local pair
  for pair in alpha/restitution youngsModulus/reducedModulus meanMass/sizeScale; do
    [[ $1 != "${pair%/*}" ]] || echo "${pair#*/}"
    [[ $1 != "${pair#*/}" ]] || echo "${pair%/*}"
  done
}

pipe_inputs_set() {  # NAME=VALUE...
  local setting name twin names='alpha restitution youngsModulus reducedModulus poissonsRatio friction
    tangential sliderStep density inletOverGas diskDiameter pitch sizeLaw sizeOrigin sizeExponent
    sizeScale meanMass forces model'
  local -A given=()
  for setting in "$@"; do
    name=${setting%%=*}
    [[ $setting == *=?* && " ${names//[$'\n']/ } " == *" $name "* ]] || foam_case_fail "unknown input" \
      "$setting" "NAME=VALUE with NAME of $(xargs <<<"$names")" "correct --set"
    case $name in
      sizeLaw) [[ ${setting#*=} =~ ^(number|mass)$ ]] ||
        foam_case_fail "unknown law of sizes" "$setting" "number, mass" "correct --set" ;;
      model) [[ ${setting#*=} =~ ^[AB]$ ]] ||
        foam_case_fail "unknown model" "$setting" "A, B" "correct --set" ;;
      tangential) [[ ${setting#*=} =~ ^(history|spring_slider_dashpot)$ ]] ||
        foam_case_fail "unknown tangential model" "$setting" "history, spring_slider_dashpot" \
          "correct --set" ;;
      forces) ;;
      *) [[ ${setting#*=} =~ ^([0-9]+\.?[0-9]*|\.[0-9]+)(e[-+]?[0-9]+)?$ ]] ||
        foam_case_fail "bad value of an input" "$setting" "a number, not negative, in SI units" \
          "correct --set" ;;
    esac
    given[$name]=${setting#*=}
  done
  for name in "${!given[@]}"; do
    twin=$(pipe_inputs_twin "$name")
    if [[ -n $twin && -z ${given[$twin]:-} ]]; then unset "input[$twin]"; fi
    if [[ $name == sizeScale ]]; then unset 'input[meanMassA]' 'input[meanMassB]'; fi
    input[$name]=${given[$name]}
  done
}

# What awk calculates of the numbers among the inputs.
pipe_calculate() {  # expression
  local name values=()
  for name in "${!input[@]}"; do values+=(-v "$name=${input[$name]}"); done
  awk "${values[@]}" '
    function value(x) { printf "%.10g", x }
    BEGIN { pi = atan2(0, -1); value('"$1"') }'
}

pipe_holds() { [[ $(pipe_calculate "($1) ? 1 : 0") == 1 ]]; }

# Both values of one thing.
pipe_inputs_agree() {  # name, name, what the second one must be after the first one, what they are
  local follows
  [[ -n ${input[$1]:-} && -n ${input[$2]:-} ]] || return 0
  follows=$(pipe_calculate "$3")
  pipe_holds "($2 - $follows)^2 <= ($pipe_digits*$follows)^2" ||
    foam_case_fail "two inputs contradict each other" "$1 ${input[$1]} and $2 ${input[$2]}" \
      "$2 $(printf %.4g "$follows") within 1 % ($4)" "leave one of them out"
}

# A dashpot of alpha sqrt(m* k): in a Hertz contact, where it follows the stiffness, it gives the
# restitution e by alpha = sqrt(5) |ln e|/sqrt(ln^2 e + pi^2) (Tsuji 1992, Antypov and Elliott 2011).
pipe_alpha_of='sqrt(5)*sqrt(log(restitution)^2/(log(restitution)^2 + pi^2))'
pipe_restitution_of='exp(-pi*(alpha/sqrt(5))/sqrt(1 - alpha^2/5))'

pipe_inputs_contacts() {
  local twins='2*(1 - poissonsRatio^2)'
  pipe_holds 'poissonsRatio < 0.5' || foam_case_fail "bad Poisson's ratio" "${input[poissonsRatio]}" \
    "below 0.5" "correct it"
  if [[ -n ${input[alpha]:-} ]]; then
    pipe_holds 'alpha < sqrt(5)' || foam_case_fail "no grain rebounds with such a dashpot" \
      "alpha ${input[alpha]}" "below sqrt(5) = 2.236" "correct it"
  fi
  if [[ -n ${input[restitution]:-} ]]; then
    pipe_holds 'restitution >= 0.05 && restitution <= 1' || foam_case_fail "bad coefficient of restitution" \
      "${input[restitution]}" "0.05 to 1 (LIGGGHTS)" "correct it"
  fi
  pipe_inputs_agree alpha restitution "$pipe_restitution_of" "alpha = sqrt(5) |ln e|/sqrt(ln^2 e + pi^2)"
  pipe_inputs_agree youngsModulus reducedModulus "youngsModulus/($twins)" "E* = E/(2 (1 - nu^2))"
  [[ -n ${input[restitution]:-} ]] || input[restitution]=$(pipe_calculate "$pipe_restitution_of")
  [[ -n ${input[alpha]:-} ]] || input[alpha]=$(pipe_calculate "$pipe_alpha_of")
  [[ -n ${input[youngsModulus]:-} ]] || input[youngsModulus]=$(pipe_calculate "reducedModulus*$twins")
  [[ -n ${input[reducedModulus]:-} ]] || input[reducedModulus]=$(pipe_calculate "youngsModulus/($twins)")
  pipe_holds 'youngsModulus >= 5e6' || foam_case_fail "the grains are too soft" \
    "Young's modulus ${input[youngsModulus]} Pa" "at least 5e6 Pa (LIGGGHTS)" "correct it"
  # README.md, "Adhesion".
  input[workOfAdhesion]=$(printf %.2g "$(pipe_calculate '0.1*(reducedModulus/1.06e11)^0.4')")
}

pipe_inputs_powder() {  # file
  local scale range
  if [[ -n ${input[meanMass]:-} && -n ${input[sizeScale]:-} ]]; then
    foam_case_fail "two inputs say the same thing" \
      "meanMass ${input[meanMass]} and sizeScale ${input[sizeScale]}" \
      "one of them: the scale follows from the mass" "leave one of them out"
  fi
  pipe_holds 'sizeOrigin <= 40e-6 && sizeExponent > 0 && density > 0' || foam_case_fail "bad law of sizes" \
    "origin ${input[sizeOrigin]} m, exponent ${input[sizeExponent]}, density ${input[density]} kg/m3" \
    "an origin of at most 40e-6 m, exponent and density above 0" "correct it"
  scale=${input[sizeScale]:-mean:${input[meanMass]:-}}
  if ! range=$("$pipe_folder/make_powder.sh" "${input[sizeLaw]}" "${input[sizeOrigin]}" \
    "${input[sizeExponent]}" "$scale" "${input[density]}" 2>&1 >"$1"); then
    foam_case_fail "no powder has this mean mass" "${input[meanMass]} kg" "$range kg, by this law of sizes" \
      "correct it, or give sizeScale"
  fi
  local -A own=()
  local name
  for name in "${!input[@]}"; do own[$name]=${input[$name]}; done
  pipe_inputs_read "$1"
  for name in "${!own[@]}"; do input[$name]=${own[$name]}; done
}

# Time step: the longest that is at most a quarter of the smallest grain's Rayleigh time and of which
# 2^a 5^b make an exchange, so that it has few digits.
pipe_inputs_step() {
  local shear='youngsModulus/(2*(1 + poissonsRatio))'
  input[rayleighTime]=$(pipe_calculate \
    "pi*smallestGrain*sqrt(density/($shear))/(0.8766 + 0.1631*poissonsRatio)")
  input[every]=$(awk -v least="$(pipe_calculate "$pipe_couplings_s/($pipe_rayleigh_part*rayleighTime)")" '
    function whole(n) { while (n % 2 == 0) n /= 2; while (n % 5 == 0) n /= 5; return n == 1 }
    BEGIN { n = int(least); if (n < least) n++; while (!whole(n)) n++; print n }')
  input[dt]=$(pipe_calculate "$pipe_couplings_s/every")
  # Four dumps per window of powderlink flow.
  input[dumpEvery]=$(pipe_calculate '5*every')
  input[countEvery]=${input[every]}
  input[insertEvery]=$(pipe_calculate "int($pipe_layer_grains/(rate*dt) + 0.5)")
}

# Step of the slider, which LIGGGHTS reads for either model: that of the source, or the DEM step where
# stiffer grains need a shorter one.
pipe_inputs_slider() {  # step that was set, or nothing
  [[ ${input[tangential]} != history && -n ${input[sliderStep]:-} ]] || input[sliderStep]=${input[dt]}
  if pipe_holds 'sliderStep > 0 && sliderStep <= dt'; then return; fi
  [[ -z $1 ]] || foam_case_fail "bad step of the slider" "$1 s" \
    "above 0, up to the DEM step of ${input[dt]} s" "correct sliderStep"
  input[sliderStep]=${input[dt]}
}

pipe_inputs_injection() {  # radius of the pipe
  local layer
  layer=$(pipe_calculate 'inletSpeed*insertEvery*dt')
  pipe_holds "diskDiameter/2 + largestGrain <= $1" ||
    foam_case_fail "the disk of injection does not fit the pipe" \
      "disk of ${input[diskDiameter]} m, largest grain of radius ${input[largestGrain]} m, pipe of radius $1 m" \
      "a disk of at most $(pipe_calculate "2*($1 - largestGrain)") m" "correct diskDiameter"
  pipe_holds 'pitch >= 2*largestGrain' ||
    foam_case_fail "points of injection are closer than the largest grain" "pitch ${input[pitch]} m" \
      "at least $(pipe_calculate '2*largestGrain') m" "correct pitch"
  pipe_holds "$layer >= 2*largestGrain" ||
    foam_case_fail "layers of injected grains overlap" \
      "$layer m between layers at ${input[inletSpeed]} m/s" \
      "at least $(pipe_calculate '2*largestGrain') m, the largest grain" "raise inletOverGas"
}

pipe_inputs_derive() {  # case, file of the powder
  local name slider_step=${input[sliderStep]:-}
  case $1 in
    A) input[gasSpeed]=10 input[rate]=300000 ;;
    B) input[gasSpeed]=5 input[rate]=150000 ;;
    *) foam_case_fail "unknown case" "$1" "A, B" "correct --case" ;;
  esac
  input[flow]=$1
  for name in meanMass sliderStep; do
    if [[ -z ${input[$name]:-} && -n ${input[$name$1]:-} ]]; then input[$name]=${input[$name$1]}; fi
    unset "input[${name}A]" "input[${name}B]"
  done
  pipe_inputs_contacts
  pipe_inputs_powder "$2"
  input[inletSpeed]=$(pipe_calculate 'inletOverGas*gasSpeed')
  pipe_inputs_step
  pipe_inputs_slider "$slider_step"
  pipe_inputs_injection "$(awk '$1 == "variable" && $2 == "r" { print $4 }' "$pipe_folder/in.pipe")"
}

pipe_inputs_write() {  # file
  local name
  {
    echo "# Made by run.sh: the inputs of this run and what follows from them. README.md says what they are."
    for name in $(printf '%s\n' "${!input[@]}" | LC_ALL=C sort); do
      printf 'variable        %-14s index "%s"\n' "$name" "${input[$name]}"
    done
  } >"$1"
}
