#!/usr/bin/env bash
# scenes.sh - the gate of real scenes: renders every scene of samples/scenes whose files are in the
# folder that RSH_SCENES names, traces every ray again by brute force (rsh-render --check), and
# lets the double-precision oracle judge primary and reflected rays (rsh_scene_oracle). Without SCENE, it
# also compares the moving glTF models and BART's scenes there with evaluations in Python
# (tests/scenes/*_check.py), for which it installs NumPy and pygltflib from PyPI into BUILD/gltf.
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
failed=0
checks=0

# The checks of motion need the programs of BUILD alone, no device.
python=$build/gltf/bin/python
install_python() {
    [ -x "$python" ] || python3 -m venv "$build/gltf"
    "$python" -m pip install -q --disable-pip-version-check numpy pygltflib
}
check_gltf() {
    "$python" -B tests/scenes/gltf_check.py "$build/tests/rsh_gltf_vertices" \
        "$RSH_SCENES/fox/Fox.glb" "$RSH_SCENES/robot_expressive/RobotExpressive.glb"
}
check_aff() {
    "$python" -B tests/scenes/aff_check.py "$build/tests/rsh_moments" \
        "$RSH_SCENES/bart_museum/aff/museum5.aff" "$RSH_SCENES/bart_kitchen/aff/kitchen.aff"
}
if [ ${#scenes[@]} -eq 0 ]; then
    checks=2
    install_python || true  # without it, both fail
    check_gltf || failed=$((failed + 1))
    check_aff || failed=$((failed + 1))
fi
if [ ${#scenes[@]} -eq 0 ]; then scenes=(samples/scenes/*.json); fi

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
echo "$((${#scenes[@]} + checks - failed)) of $((${#scenes[@]} + checks)) checks passed"
[ "$failed" -eq 0 ]
