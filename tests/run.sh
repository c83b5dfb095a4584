#!/usr/bin/env bash
# run.sh - all tests with one command, on a bare Debian 12: installs what is missing, then runs
#   1. ctest of the release build,
#   2. the tests again with the host code under the address and undefined-behaviour sanitizers,
#   3. the kernel tests on Oclgrind, which finds data races and accesses outside of buffers.
# Without an OpenCL device it fails. Builds in build/release and build/asan of the tree.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export RSH_REQUIRE_DEVICE=1
jobs=$(nproc)
logs=build/logs
mkdir -p "$logs"

step() { printf '\n== %s (%s s) ==\n' "$1" "$SECONDS"; }

# Each run of a sanitizer or an emulator starts without programs that another one has cached.
fresh_cache() { mktemp -d "${TMPDIR:-/tmp}/rsh-cache.XXXXXX"; }

run_release() {
    step "release: build"
    # Said again, because quickstart.sh configures the same folder without tests.
    cmake --preset release -G Ninja -DRSH_BUILD_TESTS=ON -DRSH_BUILD_SAMPLES=ON \
        >"$logs/configure-release.log"
    cmake --build build/release -j "$jobs"
    step "release: ctest"
    ctest --test-dir build/release -j "$jobs" --output-on-failure --no-tests=error |
        tee "$logs/ctest.log"
}

# Leaks are not looked for: PoCL and the LLVM inside of it keep what they allocate until the
# process ends, and a suppression by library would hide ours as well, since they are allocated
# below the same OpenCL calls. Use after free, overflows and undefined behaviour of the host code
# end the run.
run_sanitizers() {
    step "sanitizers: build"
    cmake --preset asan -G Ninja -DRSH_BUILD_SAMPLES=OFF >"$logs/configure-asan.log"
    cmake --build build/asan -j "$jobs" --target rsh_tests
    step "sanitizers: tests"
    ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 RSH_CACHE_DIR=$(fresh_cache) \
        build/asan/tests/rsh_tests --gtest_brief=1 2>&1 | tee "$logs/asan.log" | tail -n 40
}

# Oclgrind goes on after an error and exits with 0, so its report is searched. Kernels are compiled
# without optimization: Oclgrind 21.10 gets operators on optimized vector comparisons wrong (in
# (m == 0) & (v > 1) with int4 m, a lane that is true comes out as 1 instead of -1).
run_oclgrind() {
    step "Oclgrind: kernel tests"
    local filter='All/Reduce.EqualsCopyIf*:All/Reduce.Takes*_8:All/ReduceWidth.*_4'
    filter+=':All/Build.Contains*:All/Bound.Contains*'
    filter+=':All/Traverse.FindsTheHitsOfBruteForce/Reflected*:All/Traverse.*/Degenerate*'
    filter+=':All/Engine.FindsTheHits*/Reflected:All/Engine.FindsTheHits*/Strewn'
    filter+=':All/Box.*/Reflected:All/Traverse.*/InvalidRays*'
    filter+=':Rasterize.EqualsTracingInImagesOfAnyShape:Shade.MatchesWhittedInTheGallery'
    filter+=':Spawn.Casts*:BoxOrder*:BoxCuts*:BoxTrees*:RayOrder*:Recount.OfNoise*'
    RSH_TEST_SMALL=1 RSH_CACHE_DIR=$(fresh_cache) \
        timeout 1500 oclgrind --data-races --build-options -cl-opt-disable \
        build/release/tests/rsh_tests --gtest_brief=1 --gtest_filter="$filter" \
        >"$logs/oclgrind.log" 2>&1 || {
        tail -n 60 "$logs/oclgrind.log"
        return 1
    }
    tail -n 3 "$logs/oclgrind.log"
    if grep -n -A 12 -i -E 'data race|invalid (read|write)|uninitialized' "$logs/oclgrind.log" |
        head -n 60 | grep .; then
        echo "Oclgrind found errors, see $logs/oclgrind.log"
        return 1
    fi
}

tests/install_packages.sh tests
run_release
run_sanitizers
run_oclgrind
step "done"
grep 'tests passed' "$logs/ctest.log"
