#!/usr/bin/env bash
# Configures and builds: scripts/build.sh [preset [target]...]
#   presets: release (default, build/), debug, sanitize, fuzz, coverage, campaign, trace (build-<preset>/); no target: everything
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset=${1:-release}
shift $(($# > 0))

options=(-DRELIEVO_TESTS="${RELIEVO_TESTS:-ON}")
command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
targets=()
(($#)) && targets=(--target "$@")

log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake --preset "$preset" "${options[@]}" >"$log" 2>&1 || { cat "$log" >&2; exit 1; }
cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}"
