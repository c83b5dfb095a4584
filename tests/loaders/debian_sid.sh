#!/usr/bin/env bash
# debian_sid.sh - the tests of two loaders with the PoCL and the loader of Debian sid, in a folder
# of its own: the linked loader is sid's, the second one first this system's, then a copy of sid's.
# This system's must be from before cl_khr_icd 2.0.0, as ocl-icd 2.3.2 is.
#   sudo tests/loaders/debian_sid.sh BUILD FOLDER
# BUILD: with rsh_two_loaders_tests built. FOLDER: gets sid, about 900 MB, or has it from before.
# Needs root, debootstrap, and a mirror of Debian: RSH_DEBIAN_MIRROR, or deb.debian.org.
set -euo pipefail
build=$(realpath "$1")
sid=$(realpath -m "$2")
loader=$(ldd "$build/tests/rsh_two_loaders_tests" | awk '/libOpenCL\.so/ { print $3 }')

if [ ! -e "$sid/etc/OpenCL/vendors/pocl.icd" ]; then
    debootstrap --variant=minbase --include=pocl-opencl-icd,ocl-icd-libopencl1 sid "$sid" \
        "${RSH_DEBIAN_MIRROR:-http://deb.debian.org/debian}"
fi
mkdir -p "$sid/opt/rsh"
cp "$build/tests/rsh_two_loaders_tests" "$build"/lib/librsh.so.?.? "$sid/opt/rsh"
cp "$loader" "$sid/opt/rsh/second_older.so"
cp "$sid"/usr/lib/*/libOpenCL.so.1 "$sid/opt/rsh/second_same.so"

# Its own mounts, which end with it.
in_sid() {
    # shellcheck disable=SC2016
    unshare --mount bash -c 'mount -t proc proc "$0/proc" && mount --rbind /sys "$0/sys" &&
        mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"' "$sid" "$@"
}

in_sid dpkg-query --show libpocl2t64 ocl-icd-libopencl1
for second in older:driver same:loader; do
    echo "== the second loader is ${second%:*}"
    in_sid env LD_LIBRARY_PATH=/opt/rsh RSH_SECOND_LOADER="/opt/rsh/second_${second%:*}.so" \
        RSH_CACHE_DIR= /opt/rsh/rsh_two_loaders_tests --gtest_brief=1 | tee "$sid/opt/rsh/log"
    grep "^rsh calls .* ${second#*:}$" "$sid/opt/rsh/log" >/dev/null || {
        echo "rsh must call the ${second#*:} here, or this tested something else" >&2
        exit 1
    }
done
