#!/usr/bin/env bash
# run_batch.sh FOLDER NAME PARTS PART FILTER - one part of a batch of tests. device.sh calls it with the
# program's path in the variable `tests` and the second when the step ends in `deadline`. Leaves in
# FOLDER/NAME.PART: .log, what the program said; .case, its JSON as a case of rsh-bench has it; .left,
# likewise, when the time did not suffice for all of it. Ends with 1 when a test failed, or the program died.
set -u
part=$1/$2.$4
title="tests/$2/$(($4 + 1))_of_$3"
left=$((deadline - $(date +%s)))
leave_out() { printf '{"name": "%s", "why": "%s"}' "$title" "$1" >"$part.left"; }
if [ $left -lt 2 ]; then
    leave_out "not begun within the step's time"
    exit 0
fi
begun=$SECONDS
GTEST_TOTAL_SHARDS=$3 GTEST_SHARD_INDEX=$4 timeout -k 1 $left "$tests" --gtest_filter="$5" >"$part.log" 2>&1
status=$?
passed=$(grep -c '^\[       OK \]' "$part.log")
failed=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\).* ms)$/\1/p' "$part.log")
running=$(sed -n 's/^\[ RUN      \] //p' "$part.log" | tail -n 1)
ok=true why=""
case $status in
    0) ;;
    124 | 137) leave_out "stopped at the step's limit, after $passed tests, in $running" ;;
    1) ok=false ;;
    *) ok=false why="status $status in $running" ;;
esac
[ -z "$failed" ] || ok=false
printf '{"name": "%s", "params": {}, "metrics": {"passed": %s, "failed": [%s], "seconds": %s, "why": "%s"}, "ok": %s}' \
    "$title" "$passed" "$(printf '%s' "$failed" | sed 's/.*/"&"/' | paste -s -d ,)" $((SECONDS - begun)) "$why" \
    $ok >"$part.case"
echo "$title: $passed passed in $((SECONDS - begun)) s"
if [ $ok = false ]; then
    printf 'FAILED %s\n' $failed $why
    grep -A 12 -E ': Failure$' "$part.log" | head -n 40
    tail -n 5 "$part.log"
    exit 1
fi
