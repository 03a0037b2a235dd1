#!/usr/bin/env bash
# The gates on the source: scripts/lint.sh [gate [argument]...], all of them when none is named. Each prints what it refuses.
#   format          clang-format, as .clang-format says           [FILE]...
#   headers         what a circuit says of itself                 [--root FOLDER]
#   includes        who may include what; words of the kernels    [--root FOLDER]
#   mirror          the same unit under the same path             [--root FOLDER]
#   packages        rtl's packages are the C++ headers'          [--root FOLDER]
#   synthesizable   every entry point is a circuit                [FILE]...
#   verible         style of the circuits                         [FILE]...
#   verilator       every circuit alone, all warnings             [FILE]...
#   tidy            clang-tidy, as .clang-tidy says               [FILE]...; else ${RELIEVO_TIDY:-hls tb} as ${RELIEVO_BUILD:-build} compiles them
# shellcheck disable=SC2317  # the gates are called by name
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

gate_format() {
  local files=("$@")
  if ((!$#)); then
    mapfile -t files < <(find hls golden tb tests \( -name '*.hpp' -o -name '*.cpp' \) -not -path 'tests/mutants/format/*' | sort)
  fi
  clang-format --dry-run -Werror "${files[@]}" 2>&1
}
gate_headers() { python3 scripts/lint/headers.py "$@"; }
gate_includes() { python3 scripts/lint/includes.py "$@"; }
gate_mirror() { python3 scripts/lint/mirror.py "$@"; }
gate_packages() {
  local root=.
  [[ ${1:-} == --root ]] && root=$2
  local program=${RELIEVO_PRINT_PACKAGES:-}
  if [[ -z $program ]]; then
    scripts/build.sh release print_packages >&2 || return
    program=build/print_packages
  fi
  local printed path status=0
  printed=$(mktemp -d)
  mkdir "$printed"/{core,surface,edge,sweep}
  "$program" "$printed" || return
  while read -r path; do
    cmp -s "$printed/$path" "$root/rtl/$path" && continue
    echo "rtl/$path: packages: is not what its C++ headers say (print it again: build/print_packages rtl)"
    diff "$root/rtl/$path" "$printed/$path" | head -n 10 || true
    status=1
  done < <(cd "$printed" && find . -name '*.sv' -printf '%P\n' | sort)
  rm -rf "$printed"
  return "$status"
}
gate_synthesizable() { python3 scripts/lint/synthesizable.py --list "$@"; }
gate_tidy() {
  if (($#)); then
    clang-tidy --quiet "$@" -- -std=c++17 -I. 2>/dev/null
  else
    local folders
    read -ra folders <<<"${RELIEVO_TIDY:-hls tb}"
    python3 scripts/lint/tidy.py "${RELIEVO_BUILD:-build}" "${folders[@]}"
  fi
}

gate_verible() {
  scripts/venv.sh lint || return
  python3 scripts/lint/verible.py .venv/bin/verible-verilog-lint "$@"
}
gate_verilator() { python3 scripts/lint/verilator.py "$@"; }

if (($#)); then
  "gate_$1" "${@:2}"
  exit
fi
status=0
for gate in format headers includes mirror packages synthesizable verible verilator tidy; do
  result=0
  "gate_$gate" || result=$?
  case $result in
    0) echo "lint: $gate clean" ;;
    77) echo "lint: $gate skipped" ;;
    *)
      echo "lint: $gate FAILED"
      status=1
      ;;
  esac
done
exit "$status"
