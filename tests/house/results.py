#!/usr/bin/env python3
"""results.py FOLDER [--ctest FILE] [--each-of FILTER] - counts the single tests
of all GoogleTest results FOLDER/*.json and prints the names of those that failed or were skipped,
with the command that reruns a failure.
  --ctest FILE      JUnit file of ctest: its entries that have no file in FOLDER count as one each,
                    and one that failed without naming a test counts as a failed test
  --each-of FILTER  a GoogleTest filter without a negative part; each of its patterns must have
                    matched a test that ran, so that renaming a suite cannot drop it
The last line is `N passed, N failed`. Ends with 1 when a test failed, a pattern matched nothing or
no test ran."""
import argparse
import json
import sys
import xml.etree.ElementTree
from fnmatch import fnmatchcase
from pathlib import Path


def read_results(path):
    """(name, "passed" | "failed" | "skipped") of each test of one GoogleTest result."""
    for suite in json.loads(path.read_text())["testsuites"]:
        for test in suite["testsuite"]:
            state = "failed" if test.get("failures") else "passed"
            if test["result"] == "SKIPPED":
                state = "skipped"
            elif test["result"] != "COMPLETED":
                continue
            yield f"{suite['name']}.{test['name']}", state


def read_ctest(path):
    """(entry, is failed) of each entry of ctest."""
    for case in xml.etree.ElementTree.parse(path).getroot().iter("testcase"):
        yield case.get("name"), case.get("status") != "run"


def rerun(entry, name):
    program = entry.split(".")[0]
    return f"FAILED {name}: rerun {program} --gtest_filter='{name}'"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--ctest", type=Path)
    parser.add_argument("--each-of", default="")
    options = parser.parse_args()

    counts = {"passed": 0, "failed": 0, "skipped": 0}
    ran, failing_entries, entries = [], set(), set()
    for path in sorted(options.folder.glob("*.json")):
        entries.add(path.stem)
        for name, state in read_results(path):
            counts[state] += 1
            if state == "failed":
                failing_entries.add(path.stem)
                print(rerun(path.stem, name))
            elif state == "skipped":
                print(f"skipped {name}")
            if state != "skipped":
                ran.append(name)
    for entry, is_failed in read_ctest(options.ctest) if options.ctest else ():
        if is_failed and entry not in failing_entries:
            counts["failed"] += 1
            print(f"FAILED {entry}: see ctest -R {entry}")
        elif entry not in entries:
            counts["passed"] += 1
    missed = [pattern for pattern in options.each_of.split(":")
              if pattern and not any(fnmatchcase(name, pattern) for name in ran)]
    for pattern in missed:
        print(f"no test ran that matches {pattern}")
    if counts["skipped"]:
        print(f"{counts['skipped']} skipped")
    print(f"{counts['passed']} passed, {counts['failed']} failed")
    return 1 if missed or counts["failed"] or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
