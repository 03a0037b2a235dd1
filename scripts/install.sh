#!/usr/bin/env bash
# Installs the Debian packages that scripts/packages.txt names and this machine lacks.
#   scripts/install.sh [run]     run: only what the command line needs, not what the regression needs
# Nothing missing: no output, no network. RELIEVO_SKIP_INSTALL=1 skips the whole step, for machines that bring their own libraries.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
[[ ${RELIEVO_SKIP_INSTALL:-0} == 1 ]] && exit 0

wanted=()
section=
while read -r line; do
  line=${line%%#*}
  line=${line%"${line##*[![:space:]]}"}
  case $line in
    '') ;;
    \[*\]) section=$line ;;
    *) [[ ${1:-all} == run && $section != '[run]' ]] || wanted+=("$line") ;;
  esac
done <"$here/packages.txt"

if ! command -v dpkg-query >/dev/null; then
  echo "install.sh: this is not a Debian system; install these by your own means and set RELIEVO_SKIP_INSTALL=1: ${wanted[*]}" >&2
  exit 1
fi
installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null | sed -n 's/ installed$//p' || true)
mapfile -t missing < <(comm -13 <(sort -u <<<"$installed") <(printf '%s\n' "${wanted[@]}" | sort -u))
((${#missing[@]})) || exit 0

if [[ $(id -u) == 0 ]]; then
  as_root=()
elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
  as_root=(sudo -n)
else
  echo "install.sh: missing packages, and no right to install them. Run this, then start again:" >&2
  echo "  sudo apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 1
fi

echo "installing ${#missing[@]} packages: ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@" \
    </dev/null >"$log" 2>&1
}
# The lists of a fresh container are empty; those of an old one may name versions that are gone.
if ! apt update || ! apt install --no-install-recommends "${missing[@]}"; then
  tail -n 20 "$log" >&2
  echo "install.sh: apt-get failed; the packages missing are: ${missing[*]}" >&2
  exit 1
fi
