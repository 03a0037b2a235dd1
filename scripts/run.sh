#!/usr/bin/env bash
# The main job: the Jacksboro terrain over 128 base triangles, golden, hls and the circuit compared word for word; leaves
# out/jacksboro.{obj,ply,png,json}. Installs and builds what is missing first. Further arguments go to relievo.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/install.sh" run
# The command line alone needs none of the tests' libraries; a build folder that has the tests keeps them.
tests=OFF
grep -qs '^RELIEVO_TESTS:BOOL=ON' "$root/build/CMakeCache.txt" && tests=ON
RELIEVO_TESTS=$tests "$root/scripts/build.sh" release relievo

mkdir -p "$root/out"
echo "Jacksboro fault, 403 x 344 samples, 236 to 1076 m, over 128 base triangles:"
"$root/build/relievo" compare --models golden,hls,rtl --mesh plane:8 --displacement "$root/tests/data/jacksboro_403x344.png" \
  --sample-range 236,1076 --scale 0.25 --tests pt,ct --profile-threshold 20 --viewport 1280x800 --measure-error --rate \
  -o "$root/out/jacksboro.obj" -o "$root/out/jacksboro.ply" --image "$root/out/jacksboro.png" --report "$root/out/jacksboro.json" "$@"
echo "left out/jacksboro.obj, .ply, .png, .json"
