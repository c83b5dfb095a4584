"""Of rsh-bench reduce: the table of docs/reduction.md, and plots: throughput against the kept share and
against the length, ratios per pattern."""
from functools import partial

from reporting import drawing
from reporting.results import measured_on, wrapped

TABLE_KEEPS = (10, 50, 90)
TABLE_BYTES = (4, 8)
TABLE_COUNT = 1 << 22
PATTERN_COUNT = 1 << 20
# Too slow to tell lines apart from the axis.
OFF_THE_PLOTS = {"horn", "blelloch", "peer:empty_launch"}

EXPLANATION = (
    "G elements per second of input, higher is better; in parentheses the time of a copy of the "
    "same bytes over this time, above 1: quicker than the copy. The copy is clEnqueueCopyBuffer "
    "or a copy kernel, whichever is quicker for the stream, into a buffer of its own, in turn "
    "with what is measured. Every answer was checked before it was timed; medians, by the "
    "host's clock, from the call to the end of the work.")


def by_stream(results):
    """Metrics by what was measured."""
    fields = ("strategy", "n", "bytes", "keep", "pattern", "keep_by")
    return {tuple(case["params"][field] for field in fields): case["metrics"] for case in results.cases}


def strategies(cases):
    """The library's own first, peers behind, each in order of appearance."""
    names = list(dict.fromkeys(key[0] for key in cases))
    return sorted(names, key=lambda name: name.startswith("peer:"))


def table(results):
    cases = by_stream(results)
    columns = [(b, k) for b in TABLE_BYTES for k in TABLE_KEEPS]
    lines = ["| | " + " | ".join(f"{b} B, {k} %" for b, k in columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for name in strategies(cases):
        found = [cases.get((name, TABLE_COUNT, b, k, "random", "not_null")) for b, k in columns]
        if not any(found) or name == "peer:empty_launch":
            continue
        cells = [f"{m['elements_per_s'] / 1e9:.2f} ({m['ratio_to_copy']:.2f})" if m else "" for m in found]
        lines.append(f"| {name} | {' | '.join(cells)} |")
    about = [f"- {EXPLANATION}", *auto_text(cases), measured_on(results)]
    return "\n".join([*lines, "", wrapped(about)])


def auto_text(cases):
    shares = auto_against_best(cases)
    if not shares:
        return []
    near = sum(share >= 0.9 for share in shares) / len(shares)
    return [f"- auto reaches 0.9 of the best strategy in {near:.0%} of {len(shares)} streams, at least "
            f"{shares[0]:.2f} of it."]


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


def draw_lines(title, label, found, is_log=False):
    """None where no line has two points."""
    if not any(len(points) > 1 for points in found.values()):
        return None
    figure, axes = drawing.pyplot().subplots(figsize=(9, 5.5))
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
    return figure


def plot_keep(results, size):
    stream = (TABLE_COUNT, size, "random", "not_null")
    found = curves(by_stream(results),
                   lambda n, b, keep, pattern, by: keep if (n, b, pattern, by) == stream else None)
    return draw_lines(f"{TABLE_COUNT} elements of {size} bytes, random", "kept, %", found)


def plot_length(results):
    stream = (4, 50, "random", "not_null")
    found = curves(by_stream(results),
                   lambda n, b, keep, pattern, by: n if (b, keep, pattern, by) == stream else None)
    return draw_lines("Elements of 4 bytes, half of them kept, random", "elements", found, is_log=True)


def ratios_by_pattern(cases):
    found = {}
    for (name, n, size, keep, pattern, by), metrics in cases.items():
        is_wanted = pattern.startswith("pairs:") or (n == PATTERN_COUNT and size == 4)
        if name not in OFF_THE_PLOTS and by == "not_null" and is_wanted:
            found.setdefault(f"{pattern} {keep:g} %", {})[name] = metrics["ratio_to_copy"]
    return found


def plot_patterns(results):
    """Bars: for each pattern, the ratio to copy of each strategy."""
    cases = by_stream(results)
    found = ratios_by_pattern(cases)
    if not found:
        return None
    names = [n for n in strategies(cases) if any(n in f for f in found.values())]
    figure, axes = drawing.pyplot().subplots(figsize=(11, 0.8 + 0.55 * len(found) + 1))
    height = 0.8 / len(names)
    for i, name in enumerate(names):
        axes.barh([row + i * height for row in range(len(found))],
                  [f.get(name, 0) for f in found.values()], height, label=name)
    axes.set_yticks([row + 0.4 for row in range(len(found))], list(found), fontsize=7)
    axes.set(title="Patterns", xlabel="copy's time over this time, higher is better")
    axes.legend(fontsize=7)
    figure.tight_layout()
    return figure


PLOTS = {**{f"reduce_keep_{size}.png": partial(plot_keep, size=size) for size in (4, 8, 12, 16)},
         "reduce_length.png": plot_length, "reduce_patterns.png": plot_patterns}
