#!/usr/bin/env bash
# Takes circuits alone through Yosys and nextpnr for the ECP5-85: scripts/fpga.sh MODULE...|all|mutants
#   Prints what each takes and its highest clock, and leaves out/fpga.json. What has not changed since is not measured again.
#   mutants: only that the broken circuits of tests/mutants/fpga are refused.
#   Exit code 1 when one has a latch, a combinational loop or an undriven net, does not fit, or stays below 100 MHz; 77 without PyPI.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
(($#)) || { sed -n '2,5s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
scripts/venv.sh fpga
scripts/registers.sh
export YOWASP_CACHE_DIR=$PWD/.venv/yowasp
exec nice .venv/bin/python scripts/fpga/measure.py "$@"
