#!/usr/bin/env bash
# The entry points over the types of the HLS tools: compiled against the open ap_types and ac_types headers, run beside the
# simulation's own type, and compared word by word: scripts/portability.sh [VECTORS [ap_fixed|ac_fixed]...]
#   Exit code 77 when the headers are not here and PyPI can't be reached. Builds in ${RELIEVO_BUILD:-build}/portability; headers
#   under $RELIEVO_OVERLAY, if set, are taken instead of ours (a broken copy, to see that this gate refuses it).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=${RELIEVO_BUILD:-build}/portability
mkdir -p "$work"
scripts/venv.sh headers
templates=$(echo .venv/lib/python3*/site-packages/hls4ml/templates)

# Compiles words.cpp and every entry point with one type, and lets it speak. Their headers warn; ours have been warned about already.
speak() {
  local name=$1
  shift
  for top in hls/top/*.cpp; do echo "#include \"$top\""; done >"$work/tops_$name.cpp"
  local compiler=(g++ -std=c++14 -O1 -w ${RELIEVO_OVERLAY:+"-I$RELIEVO_OVERLAY"} -I. "$@")
  command -v ccache >/dev/null && compiler=(ccache "${compiler[@]}")
  "${compiler[@]}" -c "$work/tops_$name.cpp" -o "$work/tops_$name.o" &
  local tops=$!
  "${compiler[@]}" -c tests/portability/words.cpp -o "$work/words_$name.o"
  wait "$tops"
  g++ "$work/words_$name.o" "$work/tops_$name.o" -o "$work/words_$name"
  "$work/words_$name" "${vectors:-1000}" >"$work/$name.txt"
}
vectors=${1:-1000}
types=("${@:2}")
(($# > 1)) || types=(ap_fixed ac_fixed)
declare -A options=(
  [ap_fixed]="-DRELIEVO_AP_FIXED -isystem $templates/vivado/ap_types"
  [ac_fixed]="-DRELIEVO_AC_FIXED -isystem $templates/catapult/ac_types/include"
)

speak fixed
status=0
for name in "${types[@]}"; do
  # shellcheck disable=SC2086  # several options
  speak "$name" ${options[$name]}
  if cmp -s "$work/fixed.txt" "$work/$name.txt"; then
    echo "portability: $name: $(wc -l <"$work/fixed.txt") records, 0 differ"
  else
    echo "tests/portability/words.cpp: words differ: $name against fixed, first"
    diff "$work/fixed.txt" "$work/$name.txt" | head -n 20 || true
    status=1
  fi
done
exit "$status"
