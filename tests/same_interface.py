#!/usr/bin/env python3
"""same_interface.py OLD_INCLUDE NEW_INCLUDE - whether programs compiled with the one rsh/rsh.h may
be run with a library of the other: size and offsets of every struct and the type of every function
that both have. Names of fields do not matter. Needs clang. Ends with 1 when something differs."""
import re
import subprocess
import sys

HEADER = "#define CL_TARGET_OPENCL_VERSION 120\n#include <rsh/rsh.h>\n"


def clang(include, *options):
    command = ["clang", "-x", "c", "-std=c99", "-fsyntax-only", "-I", include, *options, "-"]
    done = subprocess.run(command, input=HEADER, capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"same_interface: {include}: {done.stderr}")
    return done.stdout


def structs(include):
    dump = clang(include, "-Xclang", "-fdump-record-layouts-complete",
                 "-Xclang", "-fdump-record-layouts-simple")
    return dict(re.findall(r"Type: struct (rsh_\w+)\n\nLayout: <([^>]*)>", dump))


def functions(include):
    dump = clang(include, "-Xclang", "-ast-dump", "-Xclang", "-ast-dump-filter=rsh_")
    return dict(re.findall(r"^FunctionDecl .* (rsh_\w+) '(.*)'", dump, re.MULTILINE))


def main():
    old_include, new_include = sys.argv[1:]
    same = True
    for read in (structs, functions):
        old, new = read(old_include), read(new_include)
        if not old or not new:
            sys.exit("same_interface: clang's dump was not understood")
        for name in sorted(old.keys() & new.keys()):
            if old[name] != new[name]:
                print(f"{name}: {old[name]} became {new[name]}")
                same = False
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
