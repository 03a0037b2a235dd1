#!/usr/bin/env bash
# The whole regression: installs, builds and runs every test, then the scenes under sanitizers and the readers under libFuzzer.
# With arguments only ctest runs, and gets them: scripts/test.sh -L unit
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
started=$SECONDS

"$root/scripts/install.sh"
installed=$SECONDS
"$root/scripts/build.sh" release
built=$SECONDS

status=0
ctest --test-dir "$root/build" -j2 --output-on-failure "$@" || status=$?
tested=$SECONDS

# A part of the regression was asked for: the rest is left out.
(($# == 0)) || exit "$status"

# Half of the scenes again under AddressSanitizer and UndefinedBehaviorSanitizer, and the readers under libFuzzer with both (all
# of them and the units: regress.sh).
"$root/scripts/build.sh" fuzz fuzz_targets system_tests
shards=()
for shard in 0 1; do
  GTEST_TOTAL_SHARDS=4 GTEST_SHARD_INDEX=$shard "$root/build-fuzz/tests/system_tests" --gtest_brief=1 \
    --gtest_filter='-*jacksboro*:*map_5x8192*:*map_8192x5_clamp*:*ideal_decides*' &
  shards+=($!)
done
for shard in "${shards[@]}"; do wait "$shard" || status=$?; done
ctest --test-dir "$root/build-fuzz" -L fuzz -j2 --output-on-failure || status=$?

printf 'install %d s, build %d s, tests %d s, sanitizers and fuzzing %d s: %s\n' $((installed - started)) $((built - installed)) \
  $((tested - built)) $((SECONDS - tested)) "$([[ $status == 0 ]] && echo passed || echo FAILED)"
exit "$status"
