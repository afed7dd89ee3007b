#!/usr/bin/env bash
# LIGGGHTS 3.8.0 (Debian 12): a script that ends with `quit` leaves with status 1, as an error does; the
# same script without that line leaves with 0. `quit STATUS`, as LAMMPS has it, is refused.
set -euo pipefail
version=$(dpkg-query -W -f '${Version}' liggghts)
[[ $version == 3.8.0+repack1-9* ]] || { echo "liggghts $version: this is about 3.8.0+repack1-9" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
printf 'units si\nprint "done"\n' >in.plain
printf 'units si\nprint "done"\nquit\n' >in.quit
status=0 plain=0
liggghts -in in.plain >log.plain 2>&1 || plain=$?
liggghts -in in.quit >log.quit 2>&1 || status=$?
echo "liggghts $version: without quit status $plain, with quit status $status; its output:"
cat log.quit
[[ $plain == 0 && $status == 1 ]] && ! grep -q ERROR log.quit
