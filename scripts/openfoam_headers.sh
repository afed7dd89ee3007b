#!/usr/bin/env bash
# Makes an OpenFOAM include tree: scripts/openfoam_headers.sh OUTDIR
# Debian packages OpenFOAM's libraries without headers, so these come from the source package of the
# same version. OUTDIR looks like OpenFOAM's own folder (src/<library>/lnInclude), so that
# cmake/FindOpenFOAM.cmake treats both alike. Does nothing when OUTDIR is already of that version.
set -euo pipefail

# The libraries whose headers a solver of ours includes; raise `layout` when this list changes.
layout=1
libraries=(OpenFOAM OSspecific/POSIX Pstream/mpi finiteVolume meshTools surfMesh fileFormats sampling
           dynamicMesh dynamicFvMesh fvOptions
           transportModels/incompressible transportModels/compressible
           TurbulenceModels/turbulenceModels TurbulenceModels/incompressible)
time_limit_s=900

fail() {  # what failed; what was given; what is allowed; what to do
  printf 'openfoam_headers.sh: %s; given: %s; allowed: %s; to do: %s\n' "$@" >&2
  exit 1
}

[[ $# -eq 1 ]] || fail "wrong arguments" "$*" "one output directory" "scripts/openfoam_headers.sh build/openfoam"
out=$1

read -r package version < <(
  dpkg-query -W -f '${source:Package} ${source:Version}\n' libopenfoam 2>/dev/null || true) || true
[[ -n ${version:-} ]] || fail "the package libopenfoam is not installed" "this machine" \
  "a Debian system with the package openfoam" "run scripts/setup.sh"

stamp="$version layout $layout"
if [[ -f $out/.stamp && $(<"$out/.stamp") == "$stamp" ]]; then
  exit 0
fi

mkdir -p "$(dirname "$out")"
work=$(mktemp -d "$out.XXXXXX")
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"/{sources,lists/partial,cache/archives/partial,download,tree/META-INFO}

# The machine's own apt sources as deb-src, in a private list: the system's configuration stays as
# it is, and mirrors, proxies and keys are those that the machine already uses.
source_list='' source_parts=''
eval "$(apt-config shell source_list Dir::Etc::sourcelist/f source_parts Dir::Etc::sourceparts/d)"
shopt -s nullglob
count=0
for file in "$source_list" "$source_parts"/*.list "$source_parts"/*.sources; do
  [[ -f $file ]] || continue
  count=$((count + 1))
  case $file in
    *.sources) sed -E 's/^[Tt]ypes:.*/Types: deb-src/' "$file" >"$work/sources/$count.sources" ;;
    *) sed -nE 's/^[[:space:]]*deb([[:space:]])/deb-src\1/p' "$file" >"$work/sources/$count.list" ;;
  esac
done

apt() {
  timeout --kill-after=10 "$time_limit_s" apt-get -q -y \
    -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/sources" \
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache" \
    -o Acquire::Retries=3 -o Acquire::Languages=none "$@"
}

# apt drops to its own user for downloads, which must then be able to write here.
if [[ $(id -u) -eq 0 ]] && id _apt >/dev/null 2>&1; then
  chmod 755 "$work"
  chown _apt "$work/lists/partial" "$work/cache/archives/partial" "$work/download"
fi

echo "OpenFOAM headers: fetching the source of $package $version (about 45 MB)" >&2
# Some other repository of this machine may offer no sources: only the next step decides.
apt update >"$work/log" 2>&1 || true
if ! (cd "$work/download" && apt source --download-only --tar-only "$package=$version") >>"$work/log" 2>&1; then
  tail -n 20 "$work/log" >&2
  fail "cannot fetch the OpenFOAM source" "$package=$version from this machine's apt sources" \
    "a mirror that is reachable and has this version's source" \
    "check the network and apt's sources, then run scripts/setup.sh again; or set WM_PROJECT_DIR to an OpenFOAM with src/*/lnInclude"
fi

archives=("$work"/download/*.orig.tar.*)
[[ ${#archives[@]} -eq 1 ]] || fail "unexpected source package" "${archives[*]:-no archive}" \
  "one .orig.tar archive" "remove $out and run scripts/setup.sh again"

patterns=('*/META-INFO/api-info')
for library in "${libraries[@]}"; do
  for suffix in C H c h; do
    patterns+=("*/src/$library/*.$suffix")
  done
done
tar --extract --file "${archives[0]}" --directory "$work/tree" --strip-components=1 --no-same-owner \
  --wildcards "${patterns[@]}" 2>"$work/log" || {
  # A library may have no file of one of the suffixes; anything else is an error.
  if grep -v -e 'Not found in archive' -e 'Exiting with failure status' "$work/log" >&2; then
    fail "cannot unpack the OpenFOAM source" "${archives[0]##*/}" "a complete archive" \
      "check the free disk space, then run scripts/setup.sh again"
  fi
}

for library in "${libraries[@]}"; do
  source_dir=$work/tree/src/$library
  [[ -d $source_dir ]] || fail "a library is missing in the OpenFOAM source" "src/$library" \
    "${libraries[*]}" "adapt the list at the top of scripts/openfoam_headers.sh"
  mkdir -p "$source_dir/lnInclude"
  # The same rules as OpenFOAM's wmakeLnInclude; relative links survive the rename below.
  (cd "$source_dir/lnInclude" &&
    find .. \( -name lnInclude -o -name Make -o -name config -o -name noLink \) -prune \
      -o -type f -name '*.[CHch]' -print0 | xargs -0 ln -sf -t .)
done
printf '%s\n' "$stamp" >"$work/tree/.stamp"

if [[ -e $out ]]; then
  mv -T "$out" "$work/old"
fi
mv -T "$work/tree" "$out"
echo "OpenFOAM headers: $version, ready in $out" >&2
