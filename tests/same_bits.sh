#!/usr/bin/env bash
# same_bits.sh - whether two commits give the same bits: every picture of samples/scenes, pixel by
# pixel, and all hits of `rsh-bench frame --quick`, by the checksum of each case.
#   same_bits.sh [--images|--hits] OLD [NEW]     OLD, NEW: commits; NEW: default the working tree
# Prints a line per picture and per case. Ends with 1 when something differs and with 2 when it
# cannot be compared. Scenes whose files RSH_SCENES and RSH_ASSETS do not have are left out by name.
#
# RSH_OLD_BUILD and RSH_NEW_BUILD name build folders (with rsh-render and rsh-bench) to use instead
# of building; else a commit is built in a temporary worktree below build/same_bits.
#
# Each side renders its own tree's scenes. A commit whose rsh-bench prints no checksums lends its
# librsh.so to the other side's rsh-bench, if both have the same binary interface.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
work=$root/build/same_bits
results=$work/results

usage() {
    sed -n '4p' "${BASH_SOURCE[0]}" >&2
    exit 2
}
fail() {
    echo "same_bits: $*" >&2
    exit 2
}

compares=(images hits)
case "${1:-}" in
    --images | --hits) compares=("${1#--}") && shift ;;
esac
[ $# -ge 1 ] && [ $# -le 2 ] || usage
old_commit=$1
new_commit=${2:-}

worktrees=()
remove_worktrees() {
    local tree
    for tree in "${worktrees[@]}"; do git worktree remove --force "$tree"; done
}
trap remove_worktrees EXIT

# Configures and builds the tree $1 in $2.
build_tree() {
    echo "building $1"
    cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRSH_BUILD_TESTS=OFF \
        >"$2.log" 2>&1 &&
        cmake --build "$2" -j "$(nproc)" --target rsh rsh-render rsh-bench >>"$2.log" 2>&1 ||
        fail "$1 does not build, see $2.log"
}

# Sets build and source of a side: prepare old|new COMMIT GIVEN_BUILD
prepare() {
    local side=$1 commit=$2 build=$3 source=$root
    if [ -n "$build" ]; then
        source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")
    elif [ -n "$commit" ]; then
        source=$work/$side-source build=$work/$side
        [ ! -e "$source" ] || git worktree remove --force "$source"
        git worktree add --quiet --detach "$source" "$commit" || fail "no commit $commit"
        worktrees+=("$source")
        build_tree "$source" "$build"
    else
        build=$work/tree
        build_tree "$source" "$build"
    fi
    printf -v "${side}_build" %s "$(realpath "$build")"
    printf -v "${side}_source" %s "$source"
}

# A scene with a still is rendered at that moment; of all others three frames, so that the second
# and third refit what the first one made.
render() {
    local side=$1 build=$2 source=$3 scene name frames
    mkdir -p "$results/$side"
    for scene in "$source"/samples/scenes/*.json; do
        name=$(basename "$scene" .json)
        frames=(--frames 3)
        ! grep -q '"still"' "$scene" || frames=()
        "$build/samples/rsh-render" "$scene" "${frames[@]}" --out "$results/$side/$name.exr" \
            >"$results/$side/$name.log" 2>&1 ||
            echo "$side: $name left out: $(tail -n 1 "$results/$side/$name.log" | cut -c 1-160)"
    done
}

prints_checksums() { grep -rqs hits_checksum "$1/tests/bench"; }

# bench SIDE BENCH_BUILD [LIBRARY]: the checksums of rsh-bench, with another library if one is given.
bench() {
    local side=$1 build=$2 library=${3:-} bench=$2/tests/bench/rsh-bench
    if [ -n "$library" ]; then
        local used
        used=$(LD_PRELOAD=$library LD_TRACE_LOADED_OBJECTS=1 "$bench" | grep 'librsh\.so')
        [[ $used == *"$library"* && $used != *"$build"* ]] ||
            fail "rsh-bench of $build does not take $library"
    fi
    LD_BIND_NOW=1 LD_PRELOAD=$library "$bench" frame --quick --json "$results/$side.json" \
        >"$results/$side-bench.log" 2>&1 ||
        fail "the hits of $side cannot be compared: $(tail -n 1 "$results/$side-bench.log")"
}

compare_hits() {
    local lends
    if prints_checksums "$old_source"; then
        bench old "$old_build"
    else
        lends=$(echo "$old_build"/lib/librsh.so.*.*.*)
        tests/same_interface.py "$old_source/include" "$new_source/include" ||
            fail "the hits cannot be compared: $old_commit prints no checksums, and its library" \
                "has another binary interface"
        bench old "$new_build" "$lends"
    fi
    bench new "$new_build"
}

unset RSH_KERNEL_DIR
rm -rf "$results"
mkdir -p "$results"
prepare old "$old_commit" "${RSH_OLD_BUILD:-}"
prepare new "$new_commit" "${RSH_NEW_BUILD:-}"
for what in "${compares[@]}"; do
    if [ "$what" = images ]; then
        render old "$old_build" "$old_source"
        render new "$new_build" "$new_source"
    else
        compare_hits
    fi
done
tests/same_bits.py "$results"
