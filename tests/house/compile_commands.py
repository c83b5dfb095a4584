#!/usr/bin/env python3
"""compile_commands.py BUILD [FILE...] - runs the compiler of the build folder BUILD over every
source that its compile_commands.json has (or over the FILEs), for warnings only: nothing is
generated. Prints what it says and ends with 1 when one fails. Sources that the build generates are
left out."""
import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def sources(build):
    """Compile commands by source, one for each: a source that several programs share counts once."""
    build = Path(build).resolve()
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = Path(entry["file"])
        if build not in source.parents:
            commands[source] = entry
    return commands


def warnings(entry):
    words = shlex.split(entry["command"])
    at = words.index("-o")
    words = words[:at] + words[at + 2 :] + ["-fsyntax-only"]
    words.remove("-c")
    done = subprocess.run(words, cwd=entry["directory"], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def main():
    commands = sources(sys.argv[1])
    wanted = [Path(name).resolve() for name in sys.argv[2:]] or sorted(commands)
    failed = 0
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for code, text in pool.map(warnings, [commands[source] for source in wanted]):
            failed += code != 0
            print(text, end="")
    print(f"{len(wanted)} sources compiled, {failed} with warnings or errors")
    return 1 if failed or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
