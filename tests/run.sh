#!/usr/bin/env bash
# run.sh - all tests and checks with one command, on a bare Debian 12: installs what is missing, then
#   1. builds the release with gcc, warnings as errors, and runs ctest,
#   2. checks the house: clang's warnings, clang-format, clang-tidy on what changed, every OpenCL
#      program that the tests built through clang's front end, and what their kernels take on GPUs,
#   3. runs the tests again with the host code under the address and undefined-behaviour sanitizers,
#   4. runs the kernel tests on Oclgrind, which finds data races and accesses outside of buffers,
#   5. makes a kit for other devices and tries it on this one, with a quarter of its time,
#   6. runs the suites of rsh-bench that judge hits and errors, shortened,
#   7. makes, installs and tests the Python package.
# Without an OpenCL device it fails. Builds in build/release, build/clang and build/asan of the tree;
# logs are in build/logs. The last line counts the single tests of step 1.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export RSH_REQUIRE_DEVICE=1 PYTHONDONTWRITEBYTECODE=1
jobs=$(nproc)
logs=build/logs
results=build/test-results
rm -rf "$results" build/cache.*
mkdir -p "$logs" "$results"

step() { printf '\n== %s (%s s) ==\n' "$1" "$SECONDS"; }

# Each run of a sanitizer or an emulator starts without programs that another one has cached.
fresh_cache() { mktemp -d "$PWD/build/cache.XXXXXX"; }

# run_shards NAME PROGRAM COMMAND...: one process of a GoogleTest program for each core. The log of
# shard i is $logs/NAME.PROGRAM.i.log. Fails when a shard fails or leaves no results.
run_shards() {
    local name=$1 program=$2 i failed=0 shards=()
    shift 2
    for ((i = 0; i < jobs; ++i)); do
        GTEST_TOTAL_SHARDS=$jobs GTEST_SHARD_INDEX=$i "$@" --gtest_brief=1 \
            --gtest_output="json:$results/$name/$program.$i.json" >"$logs/$name.$program.$i.log" 2>&1 &
        shards+=($!)
    done
    for ((i = 0; i < jobs; ++i)); do
        if ! wait "${shards[i]}" || [ ! -f "$results/$name/$program.$i.json" ]; then
            tail -n 60 "$logs/$name.$program.$i.log"
            failed=1
        fi
    done
    return $failed
}

run_release() {
    step "release: build"
    # Said again, because quickstart.sh configures the same folder without tests.
    cmake --preset release -G Ninja -DRSH_WERROR=ON -DRSH_BUILD_TESTS=ON -DRSH_BUILD_SAMPLES=ON \
        -DRSH_BUILD_BENCH=OFF >"$logs/configure-release.log"
    cmake --build build/release -j "$jobs"
    step "release: ctest"
    local programs=$PWD/$results/programs status=0
    rm -rf build/release/test-results
    mkdir -p "$programs"
    # Programs are recorded when they are built from source, so none may be cached.
    LD_PRELOAD=$PWD/build/release/tests/librsh_record_programs.so RSH_RECORD_PROGRAMS=$programs \
        RSH_CACHE_DIR=$(fresh_cache) ctest --test-dir build/release -j "$jobs" \
        --output-on-failure --no-tests=error --output-junit "$PWD/$results/ctest.xml" |
        tee "$logs/ctest.log" || status=1
    tests/house/results.py build/release/test-results --ctest "$results/ctest.xml" |
        tee "$logs/results.log" || status=1
    return $status
}

check_house() {
    step "house: clang's warnings"
    CC=clang CXX=clang++ cmake -S . -B build/clang -G Ninja -DCMAKE_BUILD_TYPE=Debug \
        -DRSH_WERROR=ON -DRSH_BENCH_PEERS=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
        >"$logs/configure-clang.log"
    ! grep -q 'rsh_bench_commit:' <(ninja -C build/clang -t targets) ||
        ninja -C build/clang rsh_bench_commit >>"$logs/configure-clang.log"
    tests/house/compile_commands.py build/clang
    step "house: format"
    tests/house/format.sh
    step "house: clang-tidy"
    tests/house/tidy.py build/clang
    step "house: OpenCL programs"
    tests/house/check_programs.py "$results/programs" kernels
    step "house: kernels on GPUs"
    tests/house/gpu_kernels.py
}

# Leaks are not looked for: PoCL and the LLVM inside of it keep what they allocate until the
# process ends, and a suppression by library would hide ours as well, since they are allocated
# below the same OpenCL calls. Use after free, overflows and undefined behaviour of the host code
# end the run.
run_sanitizers() {
    step "sanitizers: build"
    cmake --preset asan -G Ninja -DRSH_BUILD_SAMPLES=OFF >"$logs/configure-asan.log"
    cmake --build build/asan -j "$jobs" --target rsh_tests rsh_fault_tests
    step "sanitizers: tests"
    ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 RSH_CACHE_DIR=$(fresh_cache) \
        run_shards asan rsh_tests build/asan/tests/rsh_tests
    ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 RSH_CACHE_DIR=$(fresh_cache) \
        RSH_FAULT_SAMPLES=5 run_shards asan rsh_fault_tests build/asan/tests/rsh_fault_tests
    tests/house/results.py "$results/asan" | tail -n 20 | sed '$s/^/under the sanitizers: /'
}

# Oclgrind goes on after an error and exits with 0, so its report is searched. Kernels are compiled
# without optimization: Oclgrind 21.10 gets operators on optimized vector comparisons wrong (in
# (m == 0) & (v > 1) with int4 m, a lane that is true comes out as 1 instead of -1). Every pattern
# of the filter must match a test that ran.
run_oclgrind() {
    step "Oclgrind: kernel tests"
    local filter='All/Reduce.EqualsCopyIfForEvery*:All/Reduce.Takes*_8:All/ReduceWidth.*_4'
    filter+=':All/Build.Contains*:All/Bound.Contains*'
    filter+=':All/Traverse.FindsTheHitsOfBruteForce/Reflected*:All/Traverse.*/Degenerate*'
    filter+=':All/Engine.FindsTheHits*/Reflected:All/Engine.FindsTheHits*/Strewn'
    filter+=':All/Engine.FindsTheHits*/LeavingGrid:All/Box.*/Reflected:All/Traverse.*/InvalidRays*'
    filter+=':Rasterize.EqualsTracingInImagesOfAnyShape:Shade.MatchesWhittedInTheGallery'
    filter+=':Spawn.Casts*:BoxOrder*:BoxCuts*:BoxTrees*:RayOrder*'
    RSH_TEST_SMALL=1 RSH_CACHE_DIR=$(fresh_cache) run_shards oclgrind rsh_tests \
        timeout 1200 oclgrind --data-races --build-options -cl-opt-disable \
        build/release/tests/rsh_tests --gtest_filter="$filter"
    tests/house/results.py "$results/oclgrind" --each-of "$filter" | tail -n 20 |
        sed '$s/^/on Oclgrind: /'
    if grep -n -A 12 -i -E 'data race|invalid (read|write)|uninitialized' "$logs"/oclgrind.*.log |
        head -n 60 | grep .; then
        echo "Oclgrind found errors, see $logs/oclgrind.*.log"
        return 1
    fi
}

run_device_kit() {
    step "kit for other devices"
    tests/make_device_kit.sh build/release/tests/rsh_tests >"$logs/kit.log"
    tail -n 1 "$logs/kit.log"
    OUT=$results/device RSH_DEVICE_SECONDS=75 tests/device.sh >"$logs/device.log" 2>&1 ||
        { tail -n 60 "$logs/device.log"; return 1; }
    grep '^== ' "$logs/device.log"
}

# With the rsh-bench of the kit.
run_suites() {
    step "suites that judge hits"
    RSH_CACHE_DIR=$(fresh_cache) ctest --test-dir build/device-kit-build -L suites \
        --output-on-failure --no-tests=error --output-junit "$PWD/$results/suites.xml" |
        tee "$logs/suites.log"
}

run_python() {
    step "Python"
    tests/python.sh >"$logs/python.log" 2>&1 || { tail -n 60 "$logs/python.log"; return 1; }
    grep -E '^== | passed' "$logs/python.log"
}

tests/install_packages.sh tests
run_release
check_house
run_sanitizers
run_oclgrind
run_device_kit
run_suites
run_python
step "done"
grep 'tests passed' "$logs/ctest.log"
tail -n 1 "$logs/results.log"
