#!/usr/bin/env bash
# intel.sh - rsh_tests on Intel's OpenCL runtime for CPUs, with PyPI's wheel in a folder of its own.
#   tests/intel.sh BUILD FOLDER [ARGUMENT...]
# BUILD: with rsh_tests built. FOLDER: gets the runtime, about 830 MB, or has it from before, and keeps
# the programs that were compiled. ARGUMENTs go to rsh_tests; RSH_INTEL_VERSION is another version.
# Needs Python's venv and PyPI, but no processor by Intel.
set -euo pipefail
build=$(realpath "$1")
folder=$(realpath -m "$2")
shift 2
version=${RSH_INTEL_VERSION:-2026.2.0}

if [ ! -e "$folder/$version" ]; then
    python3 -m venv --clear "$folder"
    "$folder/bin/pip" install --quiet "intel-opencl-rt==$version" "intel-cmplr-lib-rt==$version"
    touch "$folder/$version"
fi
# The wheel's own .icd file names a folder of the machine that it was made on.
mkdir -p "$folder/vendors"
echo "$folder/lib/libintelocl.so" >"$folder/vendors/intel.icd"

export OCL_ICD_VENDORS=$folder/vendors LD_LIBRARY_PATH=$folder/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export RSH_CACHE_DIR=$folder/cache
exec "$build/tests/rsh_tests" "$@"
