"""Of rsh-bench hits: the table of wrong rays, and the plot of them against milliseconds, a panel per group
of scenes, a point per scene and contender."""
import math

from reporting import drawing
from reporting.results import measured_on, wrapped

WRONG = ("missed", "spurious", "wrong_triangle")
BASE = "tiles/box"
COLOURS = {"tiles/box": "tab:green", "paper/box": "tab:olive", "paper_faithful/cone": "tab:cyan",
           "brute_force": "tab:gray", "embree/default": "tab:red", "embree/robust": "tab:purple"}
NOT_IN_THE_TABLE = {"brute_force"}


def grouped(cases, key):
    """Cases by a parameter, in order of appearance."""
    found = {}
    for case in cases:
        found.setdefault(case["params"][key], []).append(case)
    return found


def in_order(cases):
    """Names of contenders: those with a colour first, in the order of the colours."""
    places = {name: i for i, name in enumerate(COLOURS)}
    names = [name for name in grouped(cases, "contender") if name not in NOT_IN_THE_TABLE]
    return sorted(names, key=lambda name: places.get(name, len(places)))


def total(cases, keys):
    return sum(case["metrics"][key] for case in cases for key in keys)


def per_million(cases):
    return 1e6 * total(cases, WRONG) / total(cases, ["judged"])


def relative_time(cases, base):
    """Geometric mean over the scenes that `base` has as well; None without any."""
    base_ms = {case["params"]["scene"]: case["metrics"]["ms_total"] for case in base}
    logs = [math.log(case["metrics"]["ms_total"] / base_ms[case["params"]["scene"]])
            for case in cases if case["params"]["scene"] in base_ms]
    return math.exp(sum(logs) / len(logs)) if logs else None


def short(value):
    """Three digits, without an exponent."""
    return f"{value:.0f}" if value >= 100 or value == 0 else f"{value:.{1 if value >= 10 else 2}f}"


def cell(cases, base):
    if not cases:
        return ""
    time = relative_time(cases, base)
    return short(per_million(cases)) + (f" ({short(time)})" if time else "")


def table(results):
    cases = results.cases
    contenders = in_order(cases)
    names = [name.replace("/", " ") for name in contenders]
    lines = [f"| scenes | rays judged | {' | '.join(names)} |", "|---" * (len(names) + 2) + "|"]
    for group, found in grouped(cases, "group").items():
        by = grouped(found, "contender")
        base = by.get(BASE, [])
        judged = total(base or found, ["judged"]) / 1e6
        scenes = len(grouped(found, "scene"))
        cells = [cell(by.get(name, []), base) for name in contenders]
        lines.append(f"| {group} ({scenes}) | {judged:.2f} M | {' | '.join(cells)} |")
    return "\n".join(lines + ["", about(results)])


def about(results):
    """What the figures were measured on, and what is no column of the table."""
    by = grouped(results.cases, "contender")

    def counts(key):
        return ", ".join(f"{total(by[name], [key])} with {name.replace('/', ' ')}"
                         for name in in_order(results.cases))

    lines = [f"- Rays that left a closed scene: {counts('leaks')}.",
             f"- Right triangles with a `t`, `u` or `v` beyond the bound: {counts('inexact')}.",
             measured_on(results)]
    return wrapped(lines)


def height(case, place):
    """On the axis; what is never wrong lies in the band of 0, a line per contender."""
    wrong = per_million([case])
    return wrong if wrong > 0 else 0.36 - 0.12 * place


def fill_panel(panel, cases):
    places = {name: i for i, name in enumerate(COLOURS)}
    panel.axhspan(-0.5, 0.5, color="tab:green", alpha=0.12, linewidth=0)
    for name, found in grouped(cases, "contender").items():
        panel.scatter([case["metrics"]["ms_total"] for case in found],
                      [height(case, places.get(name, len(places))) for case in found], s=22,
                      alpha=0.8, color=COLOURS.get(name), linewidths=0,
                      label=name.replace("/", " "))
    panel.set(xscale="log")
    panel.set_xticks([1, 10, 100, 1e3, 1e4], ["1", "10", "100", "1 K", "10 K"])
    panel.minorticks_off()
    panel.set_yscale("symlog", linthresh=1, linscale=0.9)
    panel.set_ylim(-0.5, 2e6)
    panel.set_yticks([0, 1, 1e2, 1e4, 1e6], ["0", "1", "100", "10 K", "1 M"])
    panel.grid(alpha=0.3)


def plot(results):
    groups = grouped(results.cases, "group")
    columns = -(-(len(groups) + 1) // 2)  # one panel for the legend
    figure, axes = drawing.pyplot().subplots(2, columns, figsize=(12, 5.6), sharex=True, sharey=True)
    for panel, (group, cases) in zip(axes.flat, groups.items()):
        panel.set_title(group)
        fill_panel(panel, cases)
    for panel in axes.flat[len(groups):]:
        panel.axis("off")
    for panel in axes[:, 0]:
        panel.set_ylabel("wrong rays of a million")
    for panel in axes[1, :]:
        panel.set_xlabel("ms to rebuild and trace")
    axes[0, -1].tick_params(labelbottom=True)  # nothing is below it
    entries = {label: handle for panel in axes.flat
               for handle, label in zip(*panel.get_legend_handles_labels())}
    names = [name.replace("/", " ") for name in COLOURS if name.replace("/", " ") in entries]
    axes.flat[-1].legend([entries[name] for name in names], names, loc="center", frameon=False)
    figure.tight_layout()
    return figure
