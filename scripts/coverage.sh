#!/usr/bin/env bash
# How much of each circuit its tests reach, in lines and toggled bits: scripts/coverage.sh [--misses] [UNIT]...
#   Builds the tests of the circuits with counters (build-coverage/), runs them, merges what they left and prints a row a module; also in
#   out/coverage.json. --misses: what was not reached too. UNIT: the tests of these alone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
options=()
[[ ${1:-} == --misses ]] && { options+=(--misses); shift; }
units=("$@")
(($#)) || mapfile -t units < <(find tests -name '*_rtl.cpp' -not -path 'tests/mutants/*' -printf '%f\n' | sed 's/_rtl\.cpp$//' | sort)

scripts/install.sh
scripts/build.sh coverage "${units[@]/#/rtl_}"
kept=$PWD/build-coverage/coverage
mkdir -p "$kept"
files=()
for unit in "${units[@]}"; do
  # A model leaves a file each time it is made, hundreds of them in some tests.
  rm -rf "${kept:?}/$unit"
  mkdir "$kept/$unit"
  RELIEVO_COVERAGE=$kept/$unit "build-coverage/tests/rtl/rtl_$unit" --gtest_brief=1
  find "$kept/$unit" -name '*.dat' -print0 | xargs -0 verilator_coverage --write "$kept/$unit.dat"
  rm -rf "${kept:?}/$unit"
  files+=("$kept/$unit.dat")
done
mkdir -p out
python3 scripts/rtl_coverage.py "${options[@]}" "${files[@]}"
