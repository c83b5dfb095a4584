#!/usr/bin/env bash
# make_device_kit.sh [TESTS] - makes build/device-kit: what tests/device.sh needs on a machine without a network.
#   packages/          Debian's packages of loader, headers, clinfo and the libraries that rsh-bench is
#                      compiled with; only used where the system has none
#   programs.tar.gz    rsh_tests and rsh-bench, for x86-64 and the libc named below or a newer one
#   contents.txt       commit, libc, and digests of the files
# The programs are built for this in build/device-kit-build; TESTS is a program rsh_tests that is taken
# instead. Carry it and the tree (an unpacked copy will do) to that machine. Needs Debian 12 and a network.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
kit=build/device-kit
build=build/device-kit-build
tests=${1:-$build/tests/rsh_tests}
kNewestLibc=2.34 # Debian 12, Ubuntu 22.04, RHEL 9
kMostMiB=60

packages=(ocl-icd-libopencl1 ocl-icd-opencl-dev opencl-c-headers opencl-clhpp-headers clinfo libglm-dev
    libcli11-dev libfmt-dev libfmt9 nlohmann-json3-dev googletest
    libpng-dev libpng16-16 zlib1g-dev)

build_programs() {
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
        -DRSH_BUILD_BOTH=OFF -DRSH_BUILD_SAMPLES=OFF -DRSH_BENCH_PEERS=OFF
    cmake --build "$build" -j "$(nproc)" --target rsh-bench
    [ "$tests" != "$build/tests/rsh_tests" ] || cmake --build "$build" -j "$(nproc)" --target rsh_tests
}

# Libraries that a program needs beside those of the C library and the loader of OpenCL.
libraries_of() {
    ldd "$1" | awk '$2 == "=>" { print $3 }' |
        grep -v -E '/(libc|libm|libdl|libpthread|librt|libOpenCL)\.so\.'
}

# The standard library of C++ apart: it is a last resort.
collect_programs() {
    local to=$1 program library
    mkdir -p "$to/lib/cxx"
    for program in "$tests" "$build/tests/bench/rsh-bench"; do
        strip -o "$to/${program##*/}" "$program"
        for library in $(libraries_of "$program"); do
            case $library in
                */libstdc++.so.* | */libgcc_s.so.*) cp -L "$library" "$to/lib/cxx/" ;;
                *) cp -L "$library" "$to/lib/" ;;
            esac
        done
    done
}

# The newest version of a symbol of the C library that one of the files asks for.
needed_libc() {
    objdump -T "$@" 2>/dev/null | grep -o 'GLIBC_[0-9.]*' | sort -V -u | tail -n 1 | sed 's/GLIBC_//'
}

# The lists may be missing, or older than what is there.
download() {
    (cd "$kit/packages" && { apt-get download -q -q "$@" || { apt-get update -q && apt-get download -q -q "$@"; }; })
}

tests/install_packages.sh tests
build_programs
rm -rf "$kit"
mkdir -p "$kit/packages"
programs=$(mktemp -d)
trap 'rm -rf "$programs"' EXIT
collect_programs "$programs"
libc=$(needed_libc "$programs"/rsh* "$programs"/lib/*.so*)
if [ "$(printf '%s\n' "$libc" "$kNewestLibc" | sort -V | tail -n 1)" != "$kNewestLibc" ]; then
    echo "make_device_kit.sh: the programs need libc $libc, must do with $kNewestLibc" >&2
    exit 1
fi
tar -c -z -f "$kit/programs.tar.gz" -C "$programs" .
download "${packages[@]}"
{
    echo "rsh $(git describe --always --dirty 2>/dev/null || echo "of an unpacked copy"), x86-64, libc $libc or newer"
    (cd "$kit" && find packages programs.tar.gz -type f | sort | xargs sha256sum)
} >"$kit/contents.txt"
used=$(du -s -m "$kit" | cut -f 1)
if [ "$used" -gt $kMostMiB ]; then
    echo "make_device_kit.sh: the kit has $used MiB, must have at most $kMostMiB" >&2
    exit 1
fi
echo "$kit: $used MiB, libc $libc or newer"
