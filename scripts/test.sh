#!/usr/bin/env bash
# The whole regression: installs, builds and runs every test. Further arguments go to ctest, for example -L unit.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
started=$SECONDS

"$root/scripts/install.sh"
installed=$SECONDS
"$root/scripts/build.sh" release
built=$SECONDS

status=0
ctest --test-dir "$root/build" -j2 --output-on-failure "$@" || status=$?
printf 'install %d s, build %d s, tests %d s: %s\n' $((installed - started)) $((built - installed)) $((SECONDS - built)) \
  "$([[ $status == 0 ]] && echo passed || echo FAILED)"
exit "$status"
