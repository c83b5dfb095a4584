#!/usr/bin/env bash
# scenes.sh - the gate of real scenes: renders every scene of samples/scenes whose files are in the
# folder that RSH_SCENES names, traces every ray again by brute force (rsh-render --check), and
# lets the double-precision oracle judge primary and reflected rays (rsh_scene_oracle).
#   scenes.sh [BUILD] [SCENE...]     default: build/release, all scenes
# Without RSH_SCENES it says so and checks nothing, so it is not part of run.sh.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/release}
shift || true
if [ -z "${RSH_SCENES:-}" ]; then
    echo "skipped: RSH_SCENES is unset, it must name the folder of the scenes"
    exit 0
fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
scenes=("$@")
if [ ${#scenes[@]} -eq 0 ]; then scenes=(samples/scenes/*.json); fi

failed=0
for scene in "${scenes[@]}"; do
    start=$SECONDS
    if "$build/samples/rsh-render" "$scene" --out "$out/picture.png" --size 256x256 --bounces 2 \
        --check 1 >"$out/log" 2>&1 &&
        "$build/tests/rsh_scene_oracle" "$scene" >>"$out/log" 2>&1; then
        grep ' ambiguous, ' "$out/log"
        echo "passed $scene ($((SECONDS - start)) s)"
    else
        echo "FAILED $scene ($((SECONDS - start)) s)"
        tail -n 15 "$out/log"
        failed=$((failed + 1))
    fi
done
echo "$((${#scenes[@]} - failed)) of ${#scenes[@]} scenes passed"
[ "$failed" -eq 0 ]
