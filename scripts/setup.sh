#!/usr/bin/env bash
# Installs what scripts/packages.txt lists and makes OpenFOAM's include tree in build/openfoam.
# Does nothing, and needs no network, when all is there.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
list=$root/scripts/packages.txt
log=$root/build/setup.log
apt_limit_s=3600

fail() {  # what failed; what was given; what is allowed; what to do
  printf 'setup: %s\n  given:   %s\n  allowed: %s\n  to do:   %s\n' "$@" >&2
  exit 1
}

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  fail "this system has no apt" "$(uname -sr)" "Debian 12 or a system derived from it" \
    "install by hand what scripts/packages.txt lists"
fi
if ! mkdir -p "$root/build" 2>/dev/null || [[ ! -w $root/build ]]; then
  fail "cannot write the build folder" "build/ as user $(id -un)" "a folder that this user may write" \
    "change its owner, or use a copy of the repository of your own"
fi

# Prints the packages of one kind, required or optional.
packages() {
  awk -v wanted="$1" '
    BEGIN { kind = "required" }
    /^#[ \t]*optional[ \t]*$/ { kind = "optional" }
    { sub(/#.*/, ""); if (kind == wanted && NF) print $1 }' "$list"
}

# Prints those of the given packages that are not installed.
missing() {
  local installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
  for package in "$@"; do
    grep -qxF "installed $package" <<<"$installed" || echo "$package"
  done
}

# Empty for root; sudo may ask for a password only where somebody can type it.
as_root=()
may_install=yes
if [[ $(id -u) -ne 0 ]]; then
  as_root=(sudo -n)
  if [[ -t 0 && -t 2 ]]; then as_root=(sudo); fi
  if ! command -v sudo >/dev/null || ! timeout --foreground 120 "${as_root[@]}" true 2>/dev/null; then
    may_install=no
  fi
fi

apt() {
  timeout --foreground --kill-after=10 "$apt_limit_s" \
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" </dev/null >>"$log" 2>&1
}

# Package lists are renewed only when they do not know a package, or are too old to fetch it.
lists_are_new=no
install() {
  if [[ $lists_are_new == no ]] && ! apt-get -q --simulate --no-install-recommends install "$@" >/dev/null 2>&1; then
    apt update || true
    lists_are_new=yes
  fi
  apt install --no-install-recommends "$@" && return
  [[ $lists_are_new == no ]] || return 1
  apt update || true
  lists_are_new=yes
  apt install --no-install-recommends "$@"
}

mapfile -t required < <(packages required)
mapfile -t optional < <(packages optional)
mapfile -t required_missing < <(missing "${required[@]}")
mapfile -t optional_missing < <([[ ${#optional[@]} -eq 0 ]] || missing "${optional[@]}")

if [[ ${#required_missing[@]} -gt 0 ]]; then
  by_hand="apt-get install --no-install-recommends ${required_missing[*]}   (as root), then run this again"
  if [[ $may_install == no ]]; then
    fail "${#required_missing[@]} package(s) missing, which cannot be installed" \
      "user $(id -un), not root, no usable sudo; missing: ${required_missing[*]}" \
      "root, or a user with sudo, for the first set-up only" "$by_hand"
  fi
  echo "setup: installing ${#required_missing[@]} package(s) (this may take some minutes; log in build/setup.log)" >&2
  : >"$log"
  if ! install "${required_missing[@]}"; then
    tail -n 15 "$log" >&2
    mapfile -t required_missing < <(missing "${required_missing[@]}")
    fail "apt-get could not install ${#required_missing[@]} package(s)" \
      "missing: ${required_missing[*]}" "Debian 12 packages from a reachable mirror" \
      "see build/setup.log, check the network and apt's sources; by hand: $by_hand"
  fi
fi

for package in "${optional_missing[@]}"; do
  if [[ $may_install == no ]] || ! install "$package"; then
    echo "setup: without the optional package $package (what needs it says so)" >&2
  fi
done

# A user's own OpenFOAM brings its headers. Without any, everything but the flow side works.
if [[ ! -d ${WM_PROJECT_DIR:-}/src/OpenFOAM/lnInclude ]] &&
    ! "$root/scripts/openfoam_headers.sh" "$root/build/openfoam"; then
  echo "setup: going on without OpenFOAM's headers; the coupled parts are left out until scripts/setup.sh gets them" >&2
fi
