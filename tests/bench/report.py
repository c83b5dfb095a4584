#!/usr/bin/env python3
"""report.py --out DIR FILE... - turns the JSON of rsh-bench reduce into

  table.md    the table of docs/reduction.md, printed as well
  *.png       throughput against the kept share and against the length, ratio per pattern
  index.html  one page with all of it

Of a case that several files measured, the last one counts. Measures nothing.
"""
import argparse
import html
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

TABLE_KEEPS = (10, 50, 90)
TABLE_BYTES = (4, 8)
TABLE_COUNT = 1 << 22
# Too slow to tell lines apart from the axis.
OFF_THE_PLOTS = {"horn", "blelloch", "peer:empty_launch"}


def load(paths):
    """Cases by what was measured, and the heads of the files."""
    cases, heads = {}, []
    for path in paths:
        with open(path) as file:
            document = json.load(file)
        if document["suite"] != "reduce":
            raise SystemExit(f"{path}: suite is {document['suite']}, must be reduce")
        heads.append({"device": document["device"], "rsh": document["rsh"]})
        for case in document["cases"]:
            if not case["ok"]:
                raise SystemExit(f"{path}: {case['name']} gave a wrong answer")
            p = case["params"]
            key = (p["strategy"], p["n"], p["bytes"], p["keep"], p["pattern"], p["keep_by"])
            cases[key] = case["metrics"]
    devices = {json.dumps(head["device"], sort_keys=True) for head in heads}
    if len(devices) != 1:
        raise SystemExit("the files are of several devices: one report tells of one device")
    return cases, heads


def strategies(cases):
    """The library's own first, peers behind, each in order of appearance."""
    names = list(dict.fromkeys(key[0] for key in cases))
    return sorted(names, key=lambda name: name.startswith("peer:"))


def heading(heads):
    device = heads[0]["device"]
    commits = ", ".join(sorted({head["rsh"]["commit"] for head in heads}))
    return (f"{device['name']}, {device['compute_units']} compute units, {device['platform']} "
            f"{device['driver']}; rsh {heads[0]['rsh']['version']} ({commits})")


def table(cases):
    columns = [(b, k) for b in TABLE_BYTES for k in TABLE_KEEPS]
    lines = ["| | " + " | ".join(f"{b} B, {k} %" for b, k in columns) + " |",
             "|---|" + "---|" * len(columns)]
    for name in strategies(cases):
        found = [cases.get((name, TABLE_COUNT, b, k, "random", "not_null")) for b, k in columns]
        if not any(found) or name == "peer:empty_launch":
            continue
        cells = [f"{m['elements_per_s'] / 1e9:.2f} ({m['ratio_to_copy']:.2f})" if m else ""
                 for m in found]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def auto_against_best(cases):
    """Of each stream, auto's ratio over that of the best strategy: the sorted list."""
    streams = {}
    for (name, *stream), metrics in cases.items():
        if not name.startswith("peer:"):
            streams.setdefault(tuple(stream), {})[name] = metrics["ratio_to_copy"]
    return sorted(found["auto"] / max(found.values())
                  for found in streams.values() if "auto" in found and len(found) > 1)


def curves(cases, choose):
    """name -> sorted [(x, metrics)] of the cases that choose() gives an x for."""
    found = {}
    for key, metrics in cases.items():
        x = choose(*key[1:])
        if x is not None and key[0] not in OFF_THE_PLOTS:
            found.setdefault(key[0], []).append((x, metrics))
    return {name: sorted(points, key=lambda p: p[0]) for name, points in found.items()}


def plot_lines(path, title, label, found, is_log=False):
    figure, axes = plt.subplots(figsize=(9, 5.5))
    for name, points in found.items():
        style = "--" if name.startswith("peer:") else "-"
        axes.plot([x for x, _ in points], [m["elements_per_s"] / 1e9 for _, m in points],
                  style, marker=".", label=name)
    axes.set(title=title, xlabel=label, ylabel="G elements/s, higher is better")
    if is_log:
        axes.set(xscale="log", yscale="log")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, ncol=2)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def plot_patterns(path, cases, count):
    """Bars: for each pattern, the ratio to copy of each strategy."""
    found = {}
    for (name, n, size, keep, pattern, by), metrics in cases.items():
        is_wanted = pattern.startswith("pairs:") or (n == count and size == 4)
        if name in OFF_THE_PLOTS or by != "not_null" or not is_wanted:
            continue
        found.setdefault(f"{pattern} {keep:g} %", {})[name] = metrics["ratio_to_copy"]
    if not found:
        return False
    names = [n for n in strategies(cases) if any(n in f for f in found.values())]
    figure, axes = plt.subplots(figsize=(11, 0.8 + 0.55 * len(found) + 1))
    height = 0.8 / max(len(names), 1)
    for i, name in enumerate(names):
        axes.barh([row + i * height for row in range(len(found))],
                  [f.get(name, 0) for f in found.values()], height, label=name)
    axes.set_yticks([row + 0.4 for row in range(len(found))], list(found), fontsize=7)
    axes.set(title="Patterns", xlabel="copy's time over this time, higher is better")
    axes.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)
    return True


def plot_all(cases, folder):
    pictures = []
    for size in (4, 8, 12, 16):
        found = curves(cases, lambda n, b, keep, pattern, by: keep if (
            n, b, pattern, by) == (TABLE_COUNT, size, "random", "not_null") else None)
        if any(len(points) > 1 for points in found.values()):
            pictures.append(f"keep_{size}.png")
            plot_lines(folder / pictures[-1], f"{TABLE_COUNT} elements of {size} bytes, random",
                       "kept, %", found)
    found = curves(cases, lambda n, b, keep, pattern, by: n if (b, keep, pattern, by) == (
        4, 50, "random", "not_null") else None)
    if any(len(points) > 1 for points in found.values()):
        pictures.append("length.png")
        plot_lines(folder / pictures[-1], "Elements of 4 bytes, half of them kept, random",
                   "elements", found, is_log=True)
    if plot_patterns(folder / "patterns.png", cases, 1 << 20):
        pictures.append("patterns.png")
    return pictures


EXPLANATION = (
    "G elements per second of input, higher is better; in parentheses the time of a copy of the "
    "same bytes over this time, above 1: quicker than the copy. The copy is clEnqueueCopyBuffer "
    "or a copy kernel, whichever is quicker for the stream, into a buffer of its own, in turn "
    "with what is measured. Every answer was checked before it was timed; medians, by the "
    "host's clock, from the call to the end of the work.")


def write_page(path, heads, text, pictures):
    images = "\n".join(f'<p><img src="{name}" alt="{name}"></p>' for name in pictures)
    path.write_text(
        "<!doctype html><meta charset=utf-8><title>rsh: stream reduction</title>\n"
        "<h1>Stream reduction</h1>\n"
        f"<p>{html.escape(heading(heads))}</p>\n<p>{html.escape(EXPLANATION)}</p>\n"
        f"<pre>{html.escape(text)}</pre>\n{images}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("files", nargs="+")
    options = parser.parse_args()
    cases, heads = load(options.files)
    options.out.mkdir(parents=True, exist_ok=True)
    shares = auto_against_best(cases)
    text = f"{heading(heads)}\n\n{EXPLANATION}\n\n{table(cases)}\n"
    if shares:
        near = sum(share >= 0.9 for share in shares) / len(shares)
        text += (f"\nauto reaches 0.9 of the best strategy in {near:.0%} of {len(shares)} streams, "
                 f"at least {shares[0]:.2f} of it.\n")
    (options.out / "table.md").write_text(text)
    write_page(options.out / "index.html", heads, text, plot_all(cases, options.out))
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
