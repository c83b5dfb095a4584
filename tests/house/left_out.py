#!/usr/bin/env python3
"""left_out.py KERNELS - whether a program that is compiled without a feature is the program of sources that do
not have it.

Features that the preprocessor leaves out (#if): the text after preprocessing is that of sources from which the
blocks were deleted, by another hand than the preprocessor's. Features that are left out by a test of a constant
(if, ?:): the functions of the feature lose their bodies, so that a call that is left has nothing to call; what
clang's OpenCL front end makes of both is the same LLVM IR, instruction by instruction, once the tests are inlined
and what they guard is dropped, before any other optimization. There the text is not the same: the tests are in
it, and what they guard.

Each comparison is also made with the feature compiled in, where it must fail: else it would show nothing.
Ends with 1 when one fails."""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

CLANG = ("clang", "-x", "cl", "-cl-std=CL1.2", "-target", "spir64", "-D__OPENCL_VERSION__=120", "-w",
         "-Xclang", "-finclude-default-header", "-Xclang", "-fdeclare-opencl-builtins")
# Tests are inlined, constants propagated, dead branches and functions dropped; else nothing is changed.
FOLD = ("opt", "-S", "-passes=always-inline,function(sroa,sccp,simplifycfg),globaldce")
WIDTHS = (1, 8)
# Of programs/surface: what no program without the feature calls. Not everything is left out: rsh_find_surfaces
# gives texture coordinates whether or not there are textures; and refraction is in every program.
FUNCTIONS = {
    ("RSH_SMOOTH_NORMAL",): ("load_vertex_normals", "smooth_normals", "smooth_normals_at"),
    ("RSH_TEXTURE",): ("texture_colour",),
    ("RSH_ENVIRONMENT_IMAGE",): ("direction_to_uv",),
    ("RSH_TEXTURE", "RSH_ENVIRONMENT_IMAGE"): ("sample_image", "texel", "neighbours", "wrapped"),
}
SURFACE_OPTIONS = ("RSH_SMOOTH_NORMAL", "RSH_TEXTURE", "RSH_ENVIRONMENT_IMAGE")
# What the preprocessor leaves out, and where.
BLOCKS = {
    "RSH_FILTER": ("programs/tiles", "traverse/brute_force", "traverse/audit"),
    "RSH_ALL_HITS": ("programs/tiles", "traverse/brute_force", "traverse/audit"),
}


def compiled(folder, stem, defines, width, *how):
    command = [*CLANG, *how, "-I", str(folder), "-I", str(folder / "include"), "-D", f"RSH_WIDTH={width}"]
    for name, value in defines.items():
        command += ["-D", f"{name}={value}"]
    done = subprocess.run([*command, str(folder / f"{stem}.cl"), "-o", "-"], capture_output=True,
                          text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{stem}: {done.stderr[:2000]}")
    return done.stdout


def instructions(folder, stem, defines, width):
    """LLVM IR without the name of the file, its functions and declarations in a fixed order."""
    text = compiled(folder, stem, defines, width, "-O1", "-Xclang", "-disable-llvm-passes", "-S", "-emit-llvm")
    folded = subprocess.run(FOLD, input=text, capture_output=True, text=True, check=True).stdout
    lines = [line for line in folded.splitlines() if not line.startswith(("source_filename", "; ModuleID"))]
    return sorted("\n".join(lines).split("\n\n"))


def preprocessed(folder, stem, defines, width):
    return compiled(folder, stem, defines, width, "-E", "-P")


def without_bodies(text, names):
    """Definitions of these functions become declarations; and how many there were."""
    pattern = rf"(^(?:RSH_CALLED )?static [^;{{}}#]*?\b(?:{'|'.join(names)})\([^;{{}}]*?\))\n\{{.*?^\}}"
    return re.subn(pattern, r"\1;", text, flags=re.MULTILINE | re.DOTALL)


def without_blocks(text, macro):
    """Lines in `#if MACRO`, and these directives, are deleted; of `#else` the lines stay."""
    kept, found, stack = [], 0, []  # per open #if: None: of something else; else whether lines stay
    for line in text.splitlines(keepends=True):
        word = line.split()[0] if line.startswith("#") and line.split() else ""
        if word in ("#if", "#ifdef", "#ifndef"):
            is_own = line.split()[:2] == ["#if", macro] and len(line.split()) == 2
            found += is_own
            stack.append(False if is_own else None)
            if is_own:
                continue
        elif word == "#else" and stack[-1] is not None:
            stack[-1] = True
            continue
        elif word == "#endif" and stack.pop() is not None:
            continue
        if False not in stack:
            kept.append(line)
    return "".join(kept), found


def copied(kernels, folder):
    """A copy, in which the tests of features are always inlined."""
    shutil.copytree(kernels, folder)
    shutil.copytree(kernels.parent / "include", folder / "include")
    tests = folder / "surface" / "features.h"
    tests.write_text(tests.read_text().replace("static bool has_",
                                               "__attribute__((always_inline)) static bool has_"))
    return folder


def cut_copy(kernels, folder, cut):
    """A copy of the kernels, every file of it cut; ends the program where none changes."""
    copied(kernels, folder)
    total = 0
    for path in [*folder.rglob("*.cl"), *folder.rglob("*.h")]:
        text, count = cut(path.read_text())
        path.write_text(text)
        total += count
    if total == 0:
        raise SystemExit(f"{folder.name}: nothing is cut: have names changed?")
    return folder


def compare(make, whole, cut, stem, options, macros):
    """With the features left out both are the same, compiled in they are not. How many were not so."""
    wrong = 0
    for width in WIDTHS:
        for value in (0, 1):
            told = {**options, **dict.fromkeys(macros, value)}
            is_same = make(whole, stem, told, width) == make(cut, stem, told, width)
            if is_same != (value == 0):
                wrong += 1
                named = " ".join(f"-D {name}={told[name]}" for name in told)
                print(f"{stem} {named} -D RSH_WIDTH={width}: "
                      f"{'the same' if is_same else 'not the same'} without the code of {', '.join(macros)}")
    return wrong


def main():
    kernels = Path(sys.argv[1]).resolve()
    wrong = 0
    with tempfile.TemporaryDirectory() as made:
        whole = copied(kernels, Path(made) / "whole")
        for macros, names in FUNCTIONS.items():
            cut = cut_copy(kernels, Path(made) / "_".join(macros), lambda text: without_bodies(text, names))
            for others in (0, 1):  # what else the program has
                options = dict.fromkeys(SURFACE_OPTIONS, others)
                wrong += compare(instructions, whole, cut, "programs/surface", options, macros)
        for macro, stems in BLOCKS.items():
            cut = cut_copy(kernels, Path(made) / macro, lambda text: without_blocks(text, macro))
            for stem in stems:
                wrong += compare(preprocessed, whole, cut, stem, {}, (macro,))
    print(f"{len(FUNCTIONS) + len(BLOCKS)} sets of features left out, {wrong} comparisons wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
