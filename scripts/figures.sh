#!/usr/bin/env bash
# Makes docs/figures anew: the pictures, figures.json (the table) and README.md, from runs of relievo; prints the table.
# Figures of the data in ../shared/data, where it exists, go to docs/figures/local, which stays out of the repository.
#   scripts/figures.sh [figure...]     only these, for instance: scripts/figures.sh "Figure 5"; README.md and figures.json keep the rest
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if [[ -z ${RELIEVO:-} ]]; then
  "$root/scripts/install.sh" run
  # As scripts/run.sh: a build folder that has the tests keeps them.
  tests=OFF
  grep -qs '^RELIEVO_TESTS:BOOL=ON' "$root/build/CMakeCache.txt" && tests=ON
  RELIEVO_TESTS=$tests "$root/scripts/build.sh" release relievo
fi
exec python3 "$root/scripts/figures/main.py" --relievo "${RELIEVO:-$root/build/relievo}" "$@"
