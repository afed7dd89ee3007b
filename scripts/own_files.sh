#!/usr/bin/env bash
# Lists the repository's files, new ones included, without what git ignores.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# Without git (an unpacked archive, another owner's folder) the ignored folders are left out by name.
{ git ls-files --cached --others --exclude-standard 2>/dev/null ||
  find . \( -name .git -o -path ./build -o -name results \) -prune -o -type f -printf '%P\n'; } |
  sort -u | while IFS= read -r file; do
    if [[ -f $file ]]; then printf '%s\n' "$file"; fi
  done
