#!/bin/sh
# Writes the meshes that samples/scenes/museum3.json, museum8.json and large.json need beside those of
# RSH_SCENES into a folder, by the scripts that come with these scenes. They need NumPy.
#
# usage: RSH_SCENES=... prepare.sh FOLDER; then add FOLDER to RSH_ASSETS
set -eu
if [ $# -ne 1 ] || [ ! -d "${RSH_SCENES:-}/tools" ]; then
    echo "usage: RSH_SCENES=folder-of-scenes $0 folder" >&2
    exit 2
fi
python=${PYTHON:-/usr/bin/python3}
aff=$RSH_SCENES/bart_museum/aff
mkdir -p "$1"
for n in 3 8; do
    "$python" "$RSH_SCENES/tools/museum_gen.py" "$aff" $n "$1"
done
for part in block camera paintings pillar room; do
    cp "$aff/$part.aff" "$1"
done
for scan in up side; do
    "$python" "$RSH_SCENES/tools/scan_tri.py" "$RSH_SCENES/dragon_scans/dragon_$scan.tar.xz" \
        "$1/dragon_$scan.ply" >/dev/null
done
