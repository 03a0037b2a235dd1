#!/usr/bin/env bash
# Makes of each rtl/top/*.rdl its register block in SystemVerilog, a C header of its addresses and enumerations, and the register map as HTML:
#   scripts/registers.sh [FOLDER]      FOLDER: ${RELIEVO_BUILD:-build}/registers; FOLDER/html/<name>/index.html is the register map
#   Exit code 77 when PeakRDL is not here and PyPI can't be reached. What is newer than its .rdl stays.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${1:-${RELIEVO_BUILD:-build}/registers}
scripts/venv.sh registers
mkdir -p "$folder"
exec 8>"$folder/lock"
flock 8
for rdl in rtl/top/*.rdl; do
  name=$(basename "$rdl" .rdl)
  header=$folder/${name}_registers.h
  # The header comes last.
  [[ $header -nt $rdl && $header -nt scripts/pinned_tools.txt && $header -nt scripts/registers.sh ]] && continue
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  .venv/bin/peakrdl regblock "$rdl" -o "$work" --module-name "${name}_regblock" --cpuif passthrough --addr-width 12 \
    --default-reset rst_n --type-style hier --rt-read-fanin --err-if-bad-addr --err-if-bad-rw
  # Verilator 5.006 takes wide registers, and fields with the names of C++ types, in packed structures alone.
  sed -i 's/\bstruct {/struct packed {/' "$work"/*.sv
  .venv/bin/peakrdl html "$rdl" -o "$work/html/$name"
  .venv/bin/peakrdl c-header "$rdl" -o "$work/$(basename "$header")" --type-style hier
  # The C header has no enumerations; the package has, and its names and numbers are C's but for the 'h.
  sed -n '/typedef enum/,/^ *}/p' "$work/${name}_regblock_pkg.sv" |
    sed -E "s/typedef enum[^{]*/typedef enum /; s/= 'h/= 0x/; s/^    //" >"$work/enumerations"
  grep -q '^typedef enum' "$work/enumerations"
  sed -i "/^#include <assert.h>/r $work/enumerations" "$work/$(basename "$header")"
  mkdir -p "$folder/html"
  rm -rf "$folder/html/$name"
  mv "$work/html/$name" "$folder/html/$name"
  mv "$work"/*.sv "$folder"
  mv "$work/$(basename "$header")" "$header"
  touch "$header"
  rm -rf "$work"
done
