#!/usr/bin/env bash
# Compiles with another compiler than the build's: compile_with.sh COMPILER [LAUNCHER]... -- THE_BUILDS_COMPILER ARGUMENT...
# For CMake's CXX_COMPILER_LAUNCHER, which is how one target of a build can have a compiler of its own.
set -euo pipefail
compiler=$1
shift
launcher=()
while [[ $1 != -- ]]; do
  launcher+=("$1")
  shift
done
exec "${launcher[@]}" "$compiler" "${@:3}"
