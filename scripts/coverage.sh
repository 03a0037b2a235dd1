#!/usr/bin/env bash
# How much of each circuit the regression reaches, in lines, toggled bits and the points of tests/cover: scripts/coverage.sh [--misses] [UNIT]...
#   Builds the tests of the circuits with counters (build-coverage/), runs those of the units and the whole scenes, merges what they left
#   and prints a row a module, and what was not reached; also in out/coverage.json. --misses: bits too.
#   Exit code 1: a test failed, or a line, bit or point is a hole that tests/cover/explained.toml does not explain.
#   UNIT: the tests of these alone, without a word about holes; scenes: those of the whole engine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
options=()
check=
[[ ${1:-} == --misses ]] && { options+=(--misses); shift; }
units=("$@")
if ((!$#)); then
  # What a campaign alone runs is left out.
  mapfile -t units < <(find tests -name '*_rtl.cpp' -not -path 'tests/mutants/*' -exec grep -L '^// campaign: ' {} + |
    sed 's|.*/||; s/_rtl\.cpp$//' | sort)
  units+=(scenes)
  check=--check
fi

scripts/install.sh
# Without PeakRDL the tests of what has a register block can't be built.
code=0
scripts/registers.sh build-coverage/registers || code=$?
if ((code == 77)); then
  mapfile -t hosted < <(grep -lE '^#include "(tests/support/edge_engine_(session|stories)\.hpp|edge_engine_registers\.h)"' \
    tests/*/*_rtl.cpp | sed 's|.*/||; s/_rtl\.cpp$//')
  left=()
  out=()
  for unit in "${units[@]}"; do
    if [[ " ${hosted[*]} " == *" $unit "* ]]; then out+=("$unit"); else left+=("$unit"); fi
  done
  if ((${#out[@]})); then
    echo "coverage.sh: SKIPPED ${out[*]}, which need a register block; so holes are not judged"
    units=("${left[@]}")
    check=
  fi
elif ((code)); then
  exit "$code"
fi
((${#units[@]})) || exit 77
[[ -z $check ]] || options+=("$check")
targets=()
for unit in "${units[@]}"; do
  if [[ $unit == scenes ]]; then targets+=(cosim_tests); else targets+=("rtl_$unit"); fi
done
scripts/build.sh coverage "${targets[@]}"

kept=$PWD/build-coverage/coverage
mkdir -p "$kept" out
# Fewer vectors than the regression's: counting takes its time, and corners and traffic are all there. A model leaves two files each time
# it is made, hundreds of them in some tests.
export RELIEVO_VECTORS=${RELIEVO_VECTORS:-100000}
run_unit() {
  local unit=$1
  rm -rf "${kept:?}/$unit"
  mkdir "$kept/$unit"
  export RELIEVO_COVERAGE=$kept/$unit
  if [[ $unit == scenes ]]; then
    ctest --test-dir build-coverage -L cosim --output-on-failure -Q -j"$(nproc)" || return
  else
    "build-coverage/tests/rtl/rtl_$unit" --gtest_brief=1 >"$kept/$unit.log" 2>&1 || { cat "$kept/$unit.log"; return 1; }
  fi
  # In parts, as a command has room for so many names.
  find "$kept/$unit" -name '*.begin.dat' -print0 | xargs -0 -n 400 bash -c 'verilator_coverage --write "$0/$$.begin" "$@"' "$kept/$unit"
  find "$kept/$unit" -name '*.dat' -not -name '*.begin.dat' -print0 |
    xargs -0 -n 400 bash -c 'verilator_coverage --write "$0/$$.part" "$@"' "$kept/$unit"
  verilator_coverage --write "$kept/$unit.begin.dat" "$kept/$unit"/*.begin
  verilator_coverage --write "$kept/$unit.dat" "$kept/$unit"/*.part
  rm -rf "${kept:?}/$unit"
}
export -f run_unit
export kept
printf '%s\n' "${units[@]}" | sed '/^scenes$/d' | xargs -r -P "$(nproc)" -I{} bash -euo pipefail -c 'run_unit {}'
[[ " ${units[*]} " != *" scenes "* ]] || run_unit scenes
files=("${units[@]/#/$kept/}")
python3 scripts/rtl_coverage.py "${options[@]}" "${files[@]/%/.dat}" "${files[@]/%/.begin.dat}"
