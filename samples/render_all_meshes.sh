#!/bin/sh
# Renders every mesh below a folder and prints how each run ended. A picture or an error message is
# an answer; a crash or a hang is not, and makes the exit code 1. Keeps no picture.
#
# usage: render_all_meshes.sh RSH_RENDER FOLDER
set -u
if [ $# -ne 2 ]; then
    echo "usage: $0 path/to/rsh-render folder" >&2
    exit 2
fi
render=$1
folder=$2
picture=$(mktemp -d) || exit 2
trap 'rm -rf "$picture"' EXIT
find "$folder" -type f \( -name '*.obj' -o -name '*.off' -o -name '*.ply' -o -name '*.stl' -o -name '*.om' \
    -o -name '*.gltf' -o -name '*.glb' \) |
    sort >"$picture/list"
failures=0
while IFS= read -r mesh; do
    message=$(timeout 120 "$render" "$mesh" --out "$picture/frame.png" --size 64x48 --bounces 1 2>&1)
    code=$?
    case $code in
        0) verdict=picture ;;
        1) verdict=message ;;
        *) verdict="CRASH ($code)"; failures=$((failures + 1)) ;;
    esac
    echo "$verdict: $mesh: $(printf '%s' "$message" | tail -n 1)"
done <"$picture/list"
echo "$failures of $(wc -l <"$picture/list") runs crashed"
[ "$failures" -eq 0 ]
