#!/usr/bin/env python3
"""check_programs.py [--write] RECORDED KERNELS - compiles every program that record_programs.c left
in the folder RECORDED with clang's OpenCL front end, warnings as errors, for every vector width and
for a GPU and a CPU. Programs and options are those that the library asked for while the tests ran;
those that a test made of altered kernels are left out.
Ends with 1 on a warning, when a file of the folder KERNELS is in no program, when a function of a
header is used by none of the programs that include it, and when programs.txt lists other programs.
With --write it only writes that list."""
import os
import re
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from programs import LIST, differences, lines_of, recorded, stem_of

WIDTHS = ("1", "4", "8", "16")
# The second one has the vector instructions that some headers name.
TARGETS = (("-target", "spir64"), ("-target", "x86_64", "-march=skylake-avx512"))
WARNINGS = ("-Wall", "-Wextra", "-Werror")
# A header serves programs that need only a part of it, so what no program needs is found below.
WARNINGS += ("-Wno-error=unused-function",)
# A driver defines the version; clang alone does not.
OPTIONS = ("-x", "cl", "-cl-std=CL1.2", "-fsyntax-only", "-D__OPENCL_VERSION__=120",
           "-Xclang", "-finclude-default-header", "-Xclang", "-fdeclare-opencl-builtins")


def files_of(source):
    return set(re.findall(r'^#line \d+ "([^"]+)"', source, re.MULTILINE))


def compile_program(job):
    options, source, width, target = job
    command = ["clang", *OPTIONS, *WARNINGS, *target, *options, "-D", f"RSH_WIDTH={width}", "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    return job, done.returncode, done.stderr


def unused_functions(said):
    return set(re.findall(r"^([^:\n]+):\d+:\d+: warning: unused function '(\w+)'", said, re.MULTILINE))


def without_unused(said):
    """The diagnostics but those of unused functions: each is a line that names a place, and what
    follows it."""
    kept, keeps = [], True
    for line in said.splitlines():
        if re.match(r"^\S+:\d+:\d+: ", line):
            keeps = "[-Wunused-function]" not in line
        if keeps and not re.match(r"^\d+ (warning|error)", line):
            kept.append(line)
    return "\n".join(kept)


def never_used(idle, including):
    """What is unused in each of the compilations that its header is in."""
    return [place for place, count in sorted(idle.items()) if count == including[place[0]]]


def main():
    folder, kernels = Path(sys.argv[-2]), Path(sys.argv[-1])
    found = recorded(folder, kernels)
    if sys.argv[1] == "--write":
        LIST.write_text("".join(line + "\n" for line in lines_of(found)))
        return 0
    jobs = [(options, source, width, target)
            for options, source in found for width in WIDTHS for target in TARGETS]
    failed, idle, including = 0, Counter(), Counter()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for (options, source, width, target), code, said in pool.map(compile_program, jobs):
            including.update(files_of(source))
            idle.update(unused_functions(said))
            if code:
                failed += 1
                print(f"{stem_of(source)} {' '.join(options)} -D RSH_WIDTH={width} {' '.join(target)}")
                print(without_unused(said))
    never = never_used(idle, including)
    for name, function in never:
        print(f"{name}: no program uses {function}")
    files = {str(path.relative_to(kernels)) for path in kernels.rglob("*") if path.suffix in (".cl", ".h")}
    absent = sorted(files - including.keys())
    for name in absent:
        print(f"{name}: in no program that a test builds")
    drift = differences(found)
    print("\n".join(drift), end="\n" if drift else "")
    if drift:
        print(f"the list is written anew by: tests/house/check_programs.py --write {folder} {kernels}")
    print(f"{len({stem_of(source) for _, source in found})} programs with {len(found)} sets of options "
          f"compiled {len(jobs)} times, {failed} with warnings or errors")
    return 1 if failed or never or absent or drift or not found else 0


if __name__ == "__main__":
    sys.exit(main())
