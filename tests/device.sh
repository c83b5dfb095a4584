#!/usr/bin/env bash
# device.sh - tells how rsh does on the OpenCL device of this machine: within five minutes, without a
# network, and with nothing but Linux, a C++ compiler, CMake and a driver.
#
#   tests/device.sh [STEP...]     device prepare programs tests reduce frames stability table; none named:
#                                 all
#
# build/device-kit, which tests/make_device_kit.sh makes elsewhere, must be beside it. Each step writes
# what it found under the folder that OUT names (build/device-results) while it runs, and is killed
# when it outlasts its limit or the five minutes; the others go on. RSH_DEVICE chooses a device by a
# part of its name; otherwise a GPU is preferred. RSH_DEVICE_SECONDS shortens the five minutes, and
# each limit alike. Ends with 1 when a step failed.
set -uo pipefail
tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
kit=$tree/build/device-kit
work=$tree/build/device # what this machine makes of the kit
out=${OUT:-$tree/build/device-results}
mkdir -p "$work" "$out" && out=$(cd "$out" && pwd) || exit 2
cd "$tree" || exit 2

kSteps="device prepare programs tests reduce frames stability table"
kSeconds=${RSH_DEVICE_SECONDS:-300}
kTableSeconds=10

source tests/kit/driver.sh
source tests/kit/steps.sh

limit_of() {
    case $1 in
        device) echo 15 ;;
        prepare) echo 150 ;;
        programs) echo 50 ;;
        tests) echo 70 ;;
        reduce) echo 60 ;;
        frames) echo 60 ;;
        stability) echo 40 ;;
        table) echo $kTableSeconds ;;
        *) return 1 ;;
    esac
}

say() { printf '%s\n' "$*" | tee -a "$out/log.txt"; }

# Seconds that a step may take: its own, or what is left before the table.
seconds_for() {
    local own left=$((kSeconds - SECONDS))
    if [ "$1" = table ]; then
        own=$kTableSeconds
    else
        own=$(($(limit_of "$1") * kSeconds / 300))
        left=$((left - kTableSeconds))
    fi
    echo $((own < left ? own : left))
}

# A process of its own, so that a step that hangs or dies takes nothing with it.
run_step() {
    local step=$1 seconds begun=$SECONDS status
    seconds=$(seconds_for "$step")
    if [ "$seconds" -lt 1 ]; then
        say "== $step: left out: the $kSeconds s are over =="
        return 1
    fi
    STEP_SECONDS=$seconds OUT=$out timeout -k 2 "$seconds" tests/device.sh --inside "$step" </dev/null 2>&1 |
        tee -a "$out/log.txt"
    status=${PIPESTATUS[0]}
    [ "$step" != tests ] || collect_tests
    case $status in
        0) say "== $step: done in $((SECONDS - begun)) s ==" ;;
        124 | 137) say "== $step: FAILED: stopped at its limit of $seconds s ==" ;;
        *) say "== $step: FAILED after $((SECONDS - begun)) s, status $status ==" ;;
    esac
    return "$status"
}

if [ "${1:-}" = --inside ]; then
    step_"$2"
    exit
fi

steps=${*:-$kSteps}
for step in $steps; do
    limit_of "$step" >/dev/null || {
        echo "device.sh: \"$step\" is no step, must be one of: $kSteps" >&2
        exit 2
    }
done
if [ ! -f "$kit/contents.txt" ]; then
    echo "device.sh: no kit in $kit: make it with tests/make_device_kit.sh, where there is a network" >&2
    exit 2
fi
[ $# -gt 0 ] || (cd "$out" && rm -f {device,programs,tests,reduce,cub,frames,stability}.json {log,table}.txt)
failed=()
for step in $steps; do
    run_step "$step" || failed+=("$step")
done
say "results are in $out"
if [ ${#failed[@]} -gt 0 ]; then
    say "FAILED: ${failed[*]}"
    exit 1
fi
