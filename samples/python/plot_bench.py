#!/usr/bin/env python3
"""plot_bench.py FILE... [--out bench.png] - what rsh-bench measured, of `rsh-bench frame --json FILE` or
`rsh-bench hits --json FILE`: a row for each scene and kind of rays, a mark for each contender at its
milliseconds, so that what is farther to the left is quicker. Wrong answers are left out. Needs Matplotlib."""

import argparse
import json

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def times(path):
    """Yield row, contender and milliseconds."""
    with open(path) as file:
        document = json.load(file)
    for case in document["cases"]:
        metrics = case["metrics"]
        if not case["ok"] or "ms_total" not in metrics:
            continue
        scene, _, contender = case["name"].removeprefix(document["suite"] + "/").partition("/engine:")
        row = scene.replace("scene:", "").replace("size:", "").replace("rays:", "").replace("/", ", ")
        for word in "bound:", "mode:":
            contender = contender.replace(word, "")
        yield row, contender.replace("/", ", "), metrics["ms_total"]
        if "embree_trace_ms" in metrics:
            yield row, "Embree", metrics["embree_build_ms"] + metrics["embree_trace_ms"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="+")
    parser.add_argument("--out", default="bench.png")
    given = parser.parse_args()

    measured = [found for path in given.files for found in times(path)]
    if not measured:
        parser.error(f"{', '.join(given.files)}: no case is right and has ms_total, as of frame and hits")
    rows, contenders = (list(dict.fromkeys(column)) for column in list(zip(*measured, strict=True))[:2])

    figure, axes = plt.subplots(figsize=(9, 1.5 + 0.28 * len(rows)), layout="constrained")
    for place, contender in enumerate(contenders):
        found = [(ms, rows.index(row)) for row, name, ms in measured if name == contender]
        axes.plot(*zip(*found, strict=True), "os^vDP*"[place % 7], label=contender, alpha=0.75)
    axes.set_yticks(range(len(rows)), rows)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_xscale("log")
    axes.set_xlabel("milliseconds per frame: less is quicker")
    axes.grid(axis="both", alpha=0.3)
    axes.legend(loc="lower center", bbox_to_anchor=(0.4, 1), ncol=4, frameon=False)
    figure.savefig(given.out, dpi=100)
    print(f"{given.out}: {len(rows)} rows, {len(contenders)} contenders")


if __name__ == "__main__":
    main()
