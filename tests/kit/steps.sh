# steps.sh - sourced by device.sh: what each step does. Needs $tree, $kit, $work, $out and, inside of a
# step, STEP_SECONDS.

# ---- device: what there is ----

step_device() {
    find_device || return 1
    echo "kit:     $(head -n 1 "$kit/contents.txt")"
    echo "system:  $(uname -srm), $(nproc) cores, $(ldd --version 2>/dev/null | head -n 1)"
    echo "loader:  $loader"
    sed 's/^/driver:  /' "$OCL_ICD_VENDORS"/*.icd 2>/dev/null
    echo "device:  RSH_DEVICE is ${RSH_DEVICE:-not set: the first one}"
    command -v nvcc nvidia-smi rocminfo 2>/dev/null | sed 's/^/tool:    /'
    nvidia-smi -L 2>/dev/null
    "$(clinfo_program)" --json >"$out/device.json"
    "$(clinfo_program)" || return 1
    "$(clinfo_program)" --raw | grep CL_DEVICE_NAME >/dev/null || {
        echo "no OpenCL device: none of the drivers above has one, and no other was found in" $kFolders
        return 1
    }
}

# ---- prepare: programs that run here ----

# The carried standard library only where the system's is older: a driver may need the newer one.
find_programs() {
    find_device || return 1
    [ ! -x "$work/compiled/rsh-bench" ] || programs=$work/compiled
    bench=$programs/rsh-bench
    tests=$programs/rsh_tests
    export LD_LIBRARY_PATH=${LD_LIBRARY_PATH:+$LD_LIBRARY_PATH:}$programs/lib
    "$bench" --help >/dev/null 2>&1 || LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$programs/lib/cxx
    "$bench" --help >/dev/null || return 1
    export RSH_CACHE_DIR=$work/cache RSH_SOURCE_TREE=$tree
}

# From source, against the packages of the kit: for another libc, or another processor.
compile_programs() {
    local usr=$packages/usr libraries
    libraries=$(echo "$usr"/lib/*-linux-gnu)
    [ -e "$libraries/libOpenCL.so" ] || ln -s "$loader" "$libraries/libOpenCL.so"
    cmake -S "$usr/src/googletest" -B "$work/googletest" -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_INSTALL_PREFIX="$work/gtest" -DBUILD_GMOCK=OFF &&
        cmake --build "$work/googletest" -j "$(nproc)" --target install || return 1
    cmake -S "$tree" -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
        -DRSH_BUILD_BOTH=OFF -DRSH_BUILD_SAMPLES=OFF -DRSH_BENCH_PEERS=OFF \
        -DCMAKE_PREFIX_PATH="$work/gtest;$usr" -DOpenCL_INCLUDE_DIR="$usr/include" \
        -DOpenCL_LIBRARY="$libraries/libOpenCL.so" || return 1
    mkdir -p "$work/compiled"
    local target
    for target in rsh-bench rsh_tests; do
        cmake --build "$work/build" -j "$(nproc)" --target "$target" &&
            find "$work/build" -name "$target" -type f -exec cp {} "$work/compiled/" \; || return 1
    done
}

make_cub_peer() {
    local nvcc
    nvcc=$(command -v nvcc || ls /usr/local/cuda/bin/nvcc 2>/dev/null) || {
        echo "no nvcc: CUB is not in the table"
        return 0
    }
    "$nvcc" -O3 -std=c++17 -arch=native -o "$work/cub_peer" \
        "$tree/tests/bench/reduce/cub/cub_peer.cu" ||
        echo "CUB's peer does not compile: it is not in the table"
}

step_prepare() {
    if ! find_programs; then
        echo "what the kit carries does not run here: compiling"
        compile_programs && find_programs || return 1
    fi
    echo "programs: $programs"
    make_cub_peer
}

# ---- programs, reduce, frames, stability: suites of rsh-bench ----

# A suite ends on its own before the step's limit, and names what it left out: no case begins within
# the last tenth and 5 s.
run_suite() {
    local suite=$1 json=$2 limit=$((STEP_SECONDS * 9 / 10 - 5))
    shift 2
    "$bench" "$suite" --json "$out/$json.json" --limit $((limit > 1 ? limit : 1)) "$@"
}

# Compiled, not taken from a driver's cache.
step_programs() {
    find_programs || return 1
    POCL_KERNEL_CACHE=0 CUDA_CACHE_DISABLE=1 run_suite programs programs --list "$tree/tests/house/programs.txt"
}

# 2^20, 2^24 and 2^28 elements.
step_reduce() {
    find_programs || return 1
    local streams=(--n 1048576,16777216,268435456 --bytes 4,8 --keep 10,50,90) status=0
    if [ -x "$work/cub_peer" ]; then
        timeout 20 "$work/cub_peer" "${streams[@]}" --limit 15 --json "$out/cub.json" || status=1
        STEP_SECONDS=$((STEP_SECONDS - 20))
    fi
    run_suite reduce reduce "${streams[@]}" --strategy own,peer:copy --budget 60 || status=1
    return $status
}

step_frames() {
    find_programs || return 1
    run_suite frame frames --rows device
}

step_stability() {
    find_programs || return 1
    run_suite stability stability --quick
}

# ---- tests: those that need the device, the telling ones first ----

# A line of tests/kit/batches.txt is a name, in how many parts it runs, and a filter. What is in none
# of them comes last, in many parts.
step_tests() {
    find_programs || return 1
    rm -rf "$work/tests"
    mkdir -p "$work/tests"
    local jobs=$(($(nproc) < 8 ? ($(nproc) + 1) / 2 : 4)) name parts filter all="" part
    while read -r name parts filter; do
        case $name in '' | '#'*) continue ;; esac
        [ "$filter" != "-" ] || filter="-${all#:}"
        all+=":$filter"
        for ((part = 0; part < parts; ++part)); do echo "$name $parts $part $filter"; done
    done <tests/kit/batches.txt |
        tests="$tests" deadline=$(($(date +%s) + STEP_SECONDS - 3)) \
            xargs -P "$jobs" -L 1 tests/kit/run_batch.sh "$work/tests"
}

# What the parts left, as a document of rsh-bench.
collect_tests() {
    local part
    for part in "$work"/tests/*.log; do
        [ -f "${part%.log}.case" ] || [ ! -f "$part" ] ||
            printf '{"name": "tests/%s", "why": "the step was killed"}' "$(basename "$part" .log)" >"${part%.log}.left"
    done
    printf '{"suite": "tests",\n"cases": [%s],\n"left_out": [%s]}\n' \
        "$(joined "$work"/tests/*.case)" "$(joined "$work"/tests/*.left)" >"$out/tests.json"
}

# The files that there are, with commas between.
joined() {
    local file
    for file; do [ ! -f "$file" ] || echo "$(cat "$file")"; done | paste -s -d ,
}

# ---- table ----

step_table() {
    find_programs || return 1
    local files=() name status=0
    for name in programs tests reduce cub frames stability; do
        [ ! -f "$out/$name.json" ] || files+=("$out/$name.json")
    done
    {
        "$bench" table "${files[@]}" || status=1
        echo "STEPS"
        awk '/^== / && $2 != "table:" { last[$2] = $0 } END { for (step in last) print last[step] }' "$out/log.txt" | sort
        exit $status
    } | tee "$out/table.txt"
    return "${PIPESTATUS[0]}"
}
