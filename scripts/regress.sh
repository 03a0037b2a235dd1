#!/usr/bin/env bash
# A longer campaign with the same test programs: scripts/regress.sh [--seeds N] [--vectors N]
#   first the circuit with more build parameters: every scene in the smallest queue, the throughput with each, the top with AXI4 memories
#   and that with three lanes, and mutants of the engine with three lanes;
#   then what of the circuits the regression reaches (scripts/coverage.sh);
#   then the mutants of units that the regression leaves out, clang-tidy over all of tb/, and the circuits that scripts/fpga.sh must refuse;
#   then all scenes, and the units, under AddressSanitizer and UndefinedBehaviorSanitizer, with few vectors; then
#   units and their circuits again with seeds 2..N+1 and so many random vectors each (default 10 seeds, 1,000,000 vectors).
#   Stops at the first failure, whose seed is printed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
seeds=10
vectors=1000000
while (($#)); do
  case $1 in
    --seeds) seeds=${2:?--seeds needs a number} ;;
    --vectors) vectors=${2:?--vectors needs a number} ;;
    *) echo "usage: regress.sh [--seeds N] [--vectors N]" >&2; exit 2 ;;
  esac
  shift 2
done

"$root/scripts/install.sh"
"$root/scripts/build.sh" campaign cosim_tests mutated_cosim_tests rtl_edge_engine_axi rtl_edge_engine_lanes
ctest --test-dir "$root/build-campaign" -L 'cosim|campaign' -j2 --output-on-failure
"$root/scripts/coverage.sh"
"$root/scripts/build.sh" release
ctest --test-dir "$root/build" -C Campaign -L campaign -j2 --output-on-failure
"$root/scripts/fpga.sh" mutants || { status=$?; ((status == 77)) || exit "$status"; }
"$root/scripts/build.sh" sanitize unit_tests system_tests
"$root/build-sanitize/tests/system_tests" --gtest_brief=1
RELIEVO_VECTORS=5000 "$root/build-sanitize/tests/unit_tests" --gtest_brief=1
for ((seed = 2; seed < seeds + 2; seed++)); do
  echo "seed $seed, $vectors vectors"
  for program in "$root"/build/tests/unit_tests "$root"/build/tests/rtl/rtl_*; do
    RELIEVO_SEED=$seed RELIEVO_VECTORS=$vectors "$program" --gtest_brief=1
  done
done
