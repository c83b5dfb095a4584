#!/usr/bin/env python3
"""snippet.py README COMPILER OPTION... - whether the example of README compiles in strict C99: the
first block marked c after the heading "Calling it", or else the first one. An example without main
is taken for the body of a function that has what its caller brings. Ends with 1 on a warning."""
import re
import subprocess
import sys
from pathlib import Path

STRICT = ("-x", "c", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-fsyntax-only")

# What a caller of rsh has already, and where the answers go.
AROUND = """#include <rsh/rsh.h>
#include <stdio.h>
void example(cl_context context, cl_device_id device, cl_command_queue queue, cl_mem rays,
             cl_mem vertices, cl_mem indices, cl_mem hits, cl_uint vertex_count,
             cl_uint triangle_count, rsh_context rsh, cl_event done, cl_int error);
void example(cl_context context, cl_device_id device, cl_command_queue queue, cl_mem rays,
             cl_mem vertices, cl_mem indices, cl_mem hits, cl_uint vertex_count,
             cl_uint triangle_count, rsh_context rsh, cl_event done, cl_int error)
{
    (void)context, (void)device, (void)queue, (void)rays, (void)vertices, (void)indices;
    (void)hits, (void)vertex_count, (void)triangle_count, (void)rsh, (void)done, (void)error;
    {
#line %d "%s"
%s    }
}
"""


def block_of(text):
    """The number of the first line of the block, and the block."""
    heading = re.search(r"^#+ .*Calling it.*$", text, re.MULTILINE)
    block = re.compile(r"^```c\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    found = block.search(text, heading.end() if heading else 0) or block.search(text)
    if not found:
        sys.exit("snippet: README has no block that is marked c")
    return text.count("\n", 0, found.start(1)) + 1, found.group(1)


def main():
    readme, compiler, options = sys.argv[1], sys.argv[2], sys.argv[3:]
    line, code = block_of(Path(readme).read_text())
    source = f'#line {line} "{readme}"\n{code}' if re.search(r"\bmain\(", code) else \
        AROUND % (line, readme, code)
    done = subprocess.run([compiler, *STRICT, *options, "-"], input=source, text=True, check=False)
    if done.returncode == 0:
        print(f"{readme}: {code.count(chr(10))} lines from line {line} on compile")
    return 1 if done.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
