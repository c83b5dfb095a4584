#!/usr/bin/env python3
"""launches.py FILE - sums up what record_launches.c wrote into FILE, as a table of Markdown: for
each kernel, in the order of their first launches, how often it was launched, with how many
work-items, in how many groups."""
import sys
from pathlib import Path


def span(numbers):
    low, high = min(numbers), max(numbers)
    return f"{low:,}" if low == high else f"{low:,} to {high:,}"


def table(text):
    launches = {}
    for line in text.splitlines():
        kernel, items, group = line.split()
        launches.setdefault(kernel, []).append((int(items), int(group)))
    lines = ["| kernel | launches | work-items | in groups of | groups |", "|---|--:|--:|--:|--:|"]
    for kernel, shapes in launches.items():
        lines.append(f"| `{kernel}` | {len(shapes):,} | {span([items for items, _ in shapes])} | "
                     f"{span([group for _, group in shapes])} | "
                     f"{span([items // group for items, group in shapes])} |")
    return "\n".join(lines)


if __name__ == "__main__":
    print(table(Path(sys.argv[1]).read_text()))
