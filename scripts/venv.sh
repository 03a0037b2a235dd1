#!/usr/bin/env bash
# Puts a group of scripts/pinned_tools.txt into .venv, once for each state of its lines: scripts/venv.sh GROUP
#   Already there: no output, no network. Exit code 77, and why, when PyPI can't be reached or has nothing for this machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
group=${1:?usage: venv.sh GROUP}
wanted=$(sed -n "/^# \[$group\]/,/^$/{/^[^#]/p}" scripts/pinned_tools.txt)
[[ -n $wanted ]] || { echo "venv.sh: scripts/pinned_tools.txt has no group [$group]" >&2; exit 2; }

mkdir -p .venv
exec 9>.venv/lock
flock 9
mark=.venv/$group.installed
[[ -f $mark && $(<"$mark") == "$wanted" ]] && exit 0
[[ -x .venv/bin/pip ]] || python3 -m venv .venv
# --no-deps: all that is needed is listed, and hls4ml is wanted for its files alone.
if ! .venv/bin/pip install -q --disable-pip-version-check --no-deps --require-hashes --only-binary :all: -r /dev/stdin \
    <<<"$wanted" >.venv/pip.log 2>&1; then
  tail -n 3 .venv/pip.log
  echo "venv.sh: SKIPPED, the group [$group] of scripts/pinned_tools.txt can't be fetched from PyPI"
  exit 77
fi
echo "$wanted" >"$mark"
