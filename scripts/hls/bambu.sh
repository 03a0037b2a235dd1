#!/usr/bin/env bash
# PandA-Bambu: synthesizes one entry point to Verilog: scripts/hls/bambu.sh NAME [OPTION of bambu]...
#   NAME is one of hls/top/*.cpp without its suffix. CLOCK is the period in ns, 10 by default. Results in build/bambu/NAME.
# Never run here: the tool was not at hand. Options as measured on 2024.10: its clang 16 front end at -O2 once exchanged two elements of
# an unrolled stream read, hence clang 13; it defines __BAMBU__ and no __SYNTHESIS__; its exit code is 0 even on some mismatches, so
# the log of a co-simulation is read as well.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
if (($# < 1)) || [[ ! -f $root/hls/top/$1.cpp ]]; then
  echo "usage: bambu.sh NAME [OPTION]..., NAME one of: $(cd "$root/hls/top" && echo ./*.cpp | sed 's|\./||g; s|\.cpp||g')" >&2
  exit 2
fi
if ! command -v bambu >/dev/null; then
  echo "bambu.sh: bambu is not on PATH" >&2
  exit 77
fi
work=$root/build/bambu/$1
mkdir -p "$work"
cd "$work"
bambu "$root/hls/top/$1.cpp" --top-fname="relievo_$1" --compiler=I386_CLANG13 --std=c++14 -O2 -fno-unroll-loops -I"$root" \
  --generate-interface=INFER --clock-period="${CLOCK:-10}" "${@:2}"
log=HLS_output/simulation/testbench.log
if [[ -f $log ]] && grep -qiE 'mismatch|error|failed' "$log"; then
  echo "bambu.sh: the co-simulation's log says it failed: $work/$log" >&2
  exit 1
fi
