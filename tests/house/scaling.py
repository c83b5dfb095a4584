#!/usr/bin/env python3
"""scaling.py TRACE LAUNCHES CORES BETWEEN - computes from frames on few cores what they would take on
CORES: a table of Markdown, for each kernel of a frame of engine tiles the launches, the fewest and most
work-groups of one, and milliseconds here and there.
  TRACE     what PoCL writes with POCL_TRACING=text
  LAUNCHES  what record_launches.c wrote in the same run, told by RSH_COMPUTE_UNITS of CORES
  BETWEEN   milliseconds of a frame in which the device does nothing; more cores change nothing of them
Of each command, the least of its times in all frames but the first two counts. All cores of this
machine are taken to share it, and there each a whole number of equal work-groups."""
import os
import re
import sys
from collections import Counter
from pathlib import Path


def commands(text):
    """(begin, end, name) [ns] of what ran on the device, in order."""
    begin, done = {}, []
    for line in text.splitlines():
        words = [word.strip() for word in line.split("|")]
        if len(words) < 6 or not words[0].isdigit():
            continue
        if words[5] == "running":
            begin[words[1]] = int(words[0])
        if words[5] == "complete" and words[1] in begin:
            kernel = re.search(r"name=(\w+)", line)
            done.append((begin[words[1]], int(words[0]), kernel[1] if kernel else words[4]))
    return sorted(done)


def with_groups(done, launches):
    """(name, ms, groups) of each command; a fill or a copy is one."""
    shapes = iter(launches.splitlines())
    named = []
    for begin, end, name in done:
        groups = 1
        if name.startswith("rsh_"):
            recorded, items, group = next(shapes, "nothing 0 1").split()
            if recorded != name:
                raise SystemExit(f"scaling: {name} ran where {recorded} was launched; must be one run")
            groups = int(items) // int(group)
        named.append((name, (end - begin) / 1e6, groups))
    return named


def frames(named):
    """Those that are like most. A frame begins with the scene's order; what callers write and read is
    not of it."""
    found = [[]]
    for command in named:
        if command[0] in ("read_buffer", "write_buffer"):
            continue
        is_begun = any(name.startswith("rsh_rasterize") for name, _, _ in found[-1])
        if command[0].startswith("rsh_order_") and is_begun:
            found.append([])
        found[-1].append(command)
    shapes = [tuple((name, groups) for name, _, groups in frame) for frame in found[2:]]
    if not shapes:
        raise SystemExit(f"scaling: the run has {len(found)} frames, must have 3 or more")
    usual = Counter(shapes).most_common(1)[0][0]
    return [frame for frame, shape in zip(found[2:], shapes) if shape == usual]


def rows(alike, here, there):
    """By kernel: launches, groups of each, ms here, ms there."""
    found = {}
    for same in zip(*alike):
        name, groups = same[0][0], same[0][2]
        least = min(ms for _, ms, _ in same)
        of_a_group = least * min(here, groups) / groups
        row = found.setdefault(name, ([], [], []))
        row[0].append(groups)
        row[1].append(least)
        row[2].append(of_a_group * -(-groups // there))
    return {name: (groups, sum(few), sum(many)) for name, (groups, few, many) in found.items()}


def table(found, there, between):
    all_few, all_many = (between + sum(row[i] for row in found.values()) for i in (1, 2))
    lines = [f"| command | launches | groups | ms here | ms on {there} cores | share there |",
             "|---|--:|--:|--:|--:|--:|"]
    for name, (groups, few, many) in sorted(found.items(), key=lambda row: -row[1][2]):
        low, high = min(groups), max(groups)
        span = f"{low:,}" if low == high else f"{low:,} to {high:,}"
        lines.append(f"| `{name}` | {len(groups)} | {span} | {few:.3f} | {many:.4f} | "
                     f"{100 * many / all_many:.1f} % |")
    lines.append(f"| between | | | {between:.3f} | {between:.4f} | {100 * between / all_many:.1f} % |")
    lines.append(f"| **all** | | | {all_few:.2f} | {all_many:.3f} | |")
    return "\n".join(lines)


if __name__ == "__main__":
    run = with_groups(commands(Path(sys.argv[1]).read_text()), Path(sys.argv[2]).read_text())
    cores, idle = int(sys.argv[3]), float(sys.argv[4])
    print(table(rows(frames(run), os.cpu_count(), cores), cores, idle))
