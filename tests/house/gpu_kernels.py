#!/usr/bin/env python3
"""gpu_kernels.py [--write | --self-test] - compiles every program of programs.txt for two GPUs
(gpu_compile.py) and compares what its kernels take with gpu_kernels.tsv and with the table of
docs/gpu.md. Ends with 1 on a difference, and when a program cannot be compiled.
--write writes both anew; --self-test tries that a difference is found, and compiles nothing."""
import difflib
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import gpu_compile
from programs import listed

STORED = Path(__file__).with_name("gpu_kernels.tsv")
PAGE = gpu_compile.ROOT / "docs" / "gpu.md"
MARKS = ("<!-- written by tests/house/gpu_kernels.py --write -->\n", "<!-- end of what it writes -->\n")
FIGURES = ("registers", "stack", "spilled", "shared", *gpu_compile.AMD_FIGURES)
HEAD = ("kernel", "program", *FIGURES)
SHORT = (("-D ", ""), ("RSH_", ""))


def rows_of(jobs, all_figures):
    """A row for each kernel of each program with each set of options, as text."""
    rows = []
    for (stem, options), figures in zip(jobs, all_figures):
        for kernel, figure in figures.items():
            rows.append([kernel, " ".join((stem, *options)), *(str(figure[name]) for name in FIGURES)])
    return sorted(rows)


def stored_text(versions, rows):
    lines = [f"# {versions}", *("\t".join(row) for row in [list(HEAD), *rows])]
    return "".join(line + "\n" for line in lines)


def worst_rows(rows):
    """Of each kernel, the row with the largest stack, then the most registers."""
    worst = {}
    for row in rows:
        def cost(of):
            figure = dict(zip(HEAD, of))
            return [int(figure[name]) for name in ("stack", "registers", "scratch", "vgpr")]
        if row[0] not in worst or cost(row) > cost(worst[row[0]]):
            worst[row[0]] = row
    return sorted(worst.values(), key=lambda row: (row[1], row[0]))


def page_table(versions, rows):
    lines = [f"{versions}, OpenCL C 1.2, `-O3`, `RSH_WIDTH=1`.", "",
             "| kernel | in the program | sm_90: registers | stack | gfx90a: VGPRs | SGPRs | scratch |",
             "|---|---|--:|--:|--:|--:|--:|"]
    for row in worst_rows(rows):
        figure = dict(zip(HEAD, row))
        program = figure["program"]
        for long, short in SHORT:
            program = program.replace(long, short)
        lines.append(f"| `{row[0]}` | {program} | " +
                     " | ".join(figure[name] for name in ("registers", "stack", "vgpr", "sgpr", "scratch")) +
                     " |")
    return "".join(line + "\n" for line in lines)


def with_table(page, table):
    begin, end = (re.escape(mark) for mark in MARKS)
    new, count = re.subn(f"(?<={begin}).*?(?={end})", lambda _: table, page, flags=re.DOTALL)
    if count != 1:
        sys.exit(f"{PAGE.name}: has {count} places for the table, must have 1, between {MARKS}")
    return new


def compile_all(jobs):
    """The figures of each program, and what could not be compiled."""
    failures = []

    def compiled(job):
        try:
            return gpu_compile.figures_of(*job)
        except gpu_compile.CannotCompile as failure:
            failures.append(f"{' '.join((job[0], *job[1]))}: {failure}")
            return {}

    gpu_compile.ptxas()  # before threads ask for it
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(compiled, jobs)), failures


def differences(name, stored, found):
    return list(difflib.unified_diff(stored.splitlines(), found.splitlines(), f"{name}, stored",
                                     "compiled now", lineterm="", n=0))


def self_test():
    """Each change of a stored file, and of the page, must be told; none, where there is none."""
    rows = [line.split("\t") for line in STORED.read_text().splitlines()[2:]]
    versions = STORED.read_text().splitlines()[0].removeprefix("# ")
    same = stored_text(versions, rows)
    more = [rows[0][:2] + [str(int(rows[0][2]) + 1)] + rows[0][3:], *rows[1:]]
    page = PAGE.read_text()
    wrong = [name for name, is_right in {
        "the stored file as it is": not differences("", STORED.read_text(), same),
        "a register more": len(differences("", same, stored_text(versions, more))) == 5,
        "a kernel less": bool(differences("", same, stored_text(versions, rows[1:]))),
        "another compiler": bool(differences("", same, stored_text(versions + "x", rows))),
        "the page as it is": with_table(page, page_table(versions, rows)) == page,
        "another page": with_table(page, page_table(versions, rows[1:])) != page,
        "figures of ptxas": gpu_compile.ptxas_figures(PTXAS_SAID)["rsh_a"] ==
            {"registers": 255, "stack": 40, "spilled": 4, "shared": 8},
        "an undefined function": gpu_compile.undefined_functions(" a@rel32@lo+4\nb:\n b@gotpcrel32@lo+4") == ["a"],
    }.items() if not is_right]
    for name in wrong:
        print(f"FAILED: {name}")
    return 1 if wrong else 0


PTXAS_SAID = """ptxas info : Compiling entry function 'rsh_a' for 'sm_90'
 32 bytes stack frame, 4 bytes spill stores, 8 bytes spill loads
 Used 255 registers, used 1 barriers, 40 bytes cumulative stack size, 8 bytes smem
 Compile time = 1 ms
 Function properties for b
 99 bytes stack frame
"""


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    jobs = listed()
    all_figures, failures = compile_all(jobs)
    print("\n".join(failures), end="\n" if failures else "")
    versions, rows = gpu_compile.versions(), rows_of(jobs, all_figures)
    found, page = stored_text(versions, rows), PAGE.read_text()
    new_page = with_table(page, page_table(versions, rows))
    if failures:
        return 1
    if sys.argv[1:] == ["--write"]:
        STORED.write_text(found)
        PAGE.write_text(new_page)
        return 0
    drift = differences(STORED.name, STORED.read_text(), found) + differences(PAGE.name, page, new_page)
    print("\n".join(drift), end="\n" if drift else "")
    if drift:
        print("what kernels take on a GPU has changed; written anew by: tests/house/gpu_kernels.py --write")
    print(f"{len(jobs)} programs with {len(rows)} kernels compiled for sm_90 and gfx90a")
    return 1 if drift else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except gpu_compile.CannotCompile as failure:
        sys.exit(str(failure))
