#!/usr/bin/env python3
"""report.py [FILE...] [--check [PAGE...] | --write [PAGE...] | --out DIR | --compare OLD NEW]

What is made of the JSON of rsh-bench, of any suites. Measures nothing.

  FILE...            results, several of one suite too, then of one device; by default those in docs/results
  (nothing else)     prints the table of each suite
  --check [PAGE...]  whether the sections of pages between "<!-- NAME: tests/bench/report.py writes from
                     here -->" and "<!-- NAME: to here -->", and the plots that they show, are those of the
                     results; ends with 1 where not. By default all pages that have sections. A FILE stands
                     in for the results of its suite in docs/results
  --write [PAGE...]  makes them so. A plot is drawn where it is missing or of other results
  --out DIR          tables, plots and a page per suite; with --pictures DIR, what rsh-bench accuracy
                     --pictures wrote there, its page shows these pictures
  --compare OLD NEW  how much worse each case is than before, by name and parameters; ends with 1 where a
                     metric is worse by more than --threshold, an answer is wrong that was not, or more are.
                     Where a metric has quartiles, a change counts only if those of OLD and NEW do not
                     overlap; one without counts by the threshold alone. Cases that are in one file only
                     are named. Other devices, suites, versions of the format, or a --quick run beside a
                     full one, are an error. Peers, as Embree, are left out
"""
import argparse
import os
import pathlib
import sys

from reporting import compare, output, pages
from reporting.results import by_suite, joined, read
from reporting.suites import SUITES

ROOT = pathlib.Path(__file__).resolve().parents[2]


def relative(path):
    return pathlib.Path(os.path.relpath(path))


def known(results):
    for found in results.values():
        if found.suite not in SUITES:
            raise SystemExit(f"{found.names()}: suite is {found.suite}, must be one of {', '.join(SUITES)}")
    return results


def with_stored(given):
    """Those of docs/results, where none of their suite are given."""
    return {**known(by_suite(sorted(relative(ROOT / "docs/results").glob("*.json")))), **given}


def all_pages():
    candidates = [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md"))]
    return [relative(page) for page in candidates if pages.has_sections(page)]


def check(chosen, results, files):
    complaints = [text for page in chosen for text in pages.complaints(page, results)]
    if not complaints:
        return 0
    print("\n".join(complaints), file=sys.stderr)
    words = [relative(__file__), *files, "--write", *chosen]
    print(f"write what the results say with: {' '.join(map(str, words))}", file=sys.stderr)
    return 1


def write(chosen, results):
    for page in chosen:
        print(f"{page}: {'written' if pages.write(page, results) else 'is so already'}")


def print_tables(results):
    for found in results.values():
        print(f"{SUITES[found.suite].table(found)}\n")


def compare_files(options):
    old, new = (joined([(path, read(path))]) for path in options.compare)
    text, is_good = compare.run(old, new, options.threshold, options.any_device)
    print(text)
    return 0 if is_good else 1


def percent(text):
    """"5%", "5 %" and "5" are 0.05."""
    value = float(text.rstrip("% ")) / 100
    if not value >= 0:
        raise ValueError(text)
    return value


def parse(arguments):
    usage, *rest = __doc__.splitlines()
    parser = argparse.ArgumentParser(usage=usage, description="\n".join(rest).strip(), add_help=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", type=pathlib.Path, help=argparse.SUPPRESS)
    ways = parser.add_mutually_exclusive_group()
    ways.add_argument("--check", nargs="*", type=pathlib.Path, help=argparse.SUPPRESS)
    ways.add_argument("--write", nargs="*", type=pathlib.Path, help=argparse.SUPPRESS)
    ways.add_argument("--out", type=pathlib.Path, help=argparse.SUPPRESS)
    ways.add_argument("--compare", nargs=2, type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--pictures", type=pathlib.Path, metavar="DIR", help="of --out")
    parser.add_argument("--threshold", type=percent, default=0.05, metavar="PERCENT", help="of --compare; 5%%")
    parser.add_argument("--any-device", action="store_true", help="of --compare: whatever the devices are")
    parser.add_argument("-h", "--help", action="help", help="this text")
    options = parser.parse_args(arguments)
    if options.compare and options.files:
        parser.error("--compare takes its two files, and no others")
    if options.pictures and not options.out:
        parser.error("--pictures needs --out, the folder of the page that shows them")
    return options


def main(arguments):
    options = parse(arguments)
    if options.compare:
        return compare_files(options)
    given = known(by_suite(options.files))
    if options.check is not None:
        return check(options.check or all_pages(), with_stored(given), options.files)
    if options.write is not None:
        return write(options.write or all_pages(), with_stored(given))
    results = given or with_stored(given)
    for found in results.values():
        found.require_right()
    return output.write(options.out, results, options.pictures) if options.out else print_tables(results)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
