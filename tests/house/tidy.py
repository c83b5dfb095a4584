#!/usr/bin/env python3
"""tidy.py BUILD [BASE] - clang-tidy with warnings as errors on every C++ source that differs from
BASE, and on one source that includes each header that does. BASE: where origin/main was left, or
the commit before this one when there is no origin/main or nothing differs from it. BUILD: a build
folder with compile_commands.json. Moving a file or changing its #include lines is no change here.
Ends with 1 when clang-tidy complains or is missing."""
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from compile_commands import sources


def git(*words):
    done = subprocess.run(["git", *words], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else ""


def default_base():
    base = git("merge-base", "origin/main", "HEAD").strip()
    if base and git("diff", "--name-only", base):
        return base
    return git("rev-parse", "HEAD~1").strip()


def changed_files(base):
    """Files in which a line other than a blank one or an #include differs."""
    changed, name = set(), ""
    for line in git("diff", "-M", "-U0", "--diff-filter=ACMR", base).splitlines():
        if line.startswith("+++ "):
            name = line[6:]
        elif line[:1] in "+-" and not line.startswith("--- "):
            text = line[1:].strip()
            if text and not text.startswith(("#include", "//")):
                changed.add(Path(name))
    for name in git("ls-files", "--others", "--exclude-standard").splitlines():
        changed.add(Path(name))
    return changed


def includes(source, header):
    return f'/{header.name}"' in source or f'"{header.name}"' in source


def to_check(build, base):
    known = {path: path.read_text() for path in sources(build) if path.suffix == ".cpp"}
    chosen = set()
    for name in sorted(changed_files(base)):
        path = name.resolve()
        if path in known:
            chosen.add(path)
        elif path.suffix in (".hpp", ".h"):
            users = [source for source, text in known.items() if includes(text, path)]
            if users and not chosen.intersection(users):
                # The source of the same name, if there is one, is where a header is implemented.
                chosen.add(min(users, key=lambda user: (user.stem != path.stem, user)))
    return sorted(chosen)


def tidy(build, source):
    command = ["clang-tidy", "-p", build, "--quiet", "--warnings-as-errors=*", str(source)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def main():
    if not shutil.which("clang-tidy"):
        sys.exit("tidy: clang-tidy is missing; tests/install_packages.sh tests installs it")
    build = sys.argv[1]
    base = sys.argv[2] if len(sys.argv) > 2 else default_base()
    if not base:
        sys.exit("tidy: no commit to compare with; fetch at least two commits")
    chosen = to_check(build, base)
    failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for code, text in pool.map(lambda source: tidy(build, source), chosen):
            failed += code != 0
            print(text, end="")
    print(f"clang-tidy on {len(chosen)} sources that differ from {base[:12]}, {failed} with findings")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
