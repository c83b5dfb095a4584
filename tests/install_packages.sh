#!/usr/bin/env bash
# install_packages.sh - installs what is missing on Debian 12 to build and run rsh:
#   install_packages.sh library|samples|tests|bench
# Each set contains `library`; tests and bench also `samples`. Does nothing, and needs no root, when
# nothing is missing.
set -euo pipefail

library=(build-essential cmake ninja-build pkg-config ca-certificates
    ocl-icd-opencl-dev opencl-c-headers pocl-opencl-icd)
samples=("${library[@]}" opencl-clhpp-headers libopenmesh-dev libopenimageio-dev libglm-dev libcli11-dev
    libfmt-dev libarchive-dev libtinygltf-dev libtinyobjloader-dev
    nlohmann-json3-dev)
tests=("${samples[@]}" libgtest-dev libpng-dev oclgrind git python3 python3-venv
    python3-numpy python3-pyopencl
    clang clang-format clang-tidy libclc-14)
bench=("${samples[@]}" libboost-dev libembree-dev libtbb-dev
    python3-pyopencl python3-numpy python3-matplotlib)

case "${1:-}" in
    library) packages=("${library[@]}") ;;
    samples) packages=("${samples[@]}") ;;
    tests) packages=("${tests[@]}") ;;
    bench) packages=("${bench[@]}") ;;
    *)
        echo "usage: $0 library|samples|tests|bench, found \"${1:-}\"" >&2
        exit 2
        ;;
esac

missing=()
for package in "${packages[@]}"; do
    status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
    [ "$status" = "install ok installed" ] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

echo "installing ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
