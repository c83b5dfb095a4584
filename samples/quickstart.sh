#!/usr/bin/env bash
# quickstart.sh - from a fresh Debian 12 to a picture: installs what is missing, builds rsh-render,
# fetches a mesh (CC0, from the data of Debian's libcgal-demo; nothing of that package is
# installed), renders samples/scenes/quickstart.json and prints the time of each stage and where
# the picture is. May be run again: what is there is not fetched or built a second time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
picture=$root/build/quickstart.png
mesh=meshes/ChineseDragon-10kv.off
assets=$root/build/assets

tests/install_packages.sh samples

echo "building rsh-render"
cmake --preset release -G Ninja -DRSH_BUILD_TESTS=OFF >/dev/null
cmake --build build/release -j "$(nproc)" --target rsh-render

# The package is unpacked, not installed: it would bring a compiler's worth of dependencies.
fetch_mesh() {
    local download
    download=$(mktemp -d)
    trap 'rm -rf "$download"' RETURN
    # apt's download user may not write to a folder of root's; that is only a warning.
    (cd "$download" && apt-get download -q libcgal-demo)
    dpkg -x "$download"/libcgal-demo_*.deb "$download/package"
    mkdir -p "$assets"
    tar -xzf "$download/package/usr/share/doc/libcgal-dev/data.tar.gz" -C "$download"
    cp -r "$download"/data/meshes "$assets/"
}
if [ ! -f "$assets/$mesh" ]; then
    echo "fetching $mesh"
    fetch_mesh
fi

RSH_ASSETS=$assets build/release/samples/rsh-render samples/scenes/quickstart.json \
    --out "$picture" --stats
echo "picture: $picture"
