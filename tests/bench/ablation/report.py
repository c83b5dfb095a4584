#!/usr/bin/env python3
"""report.py FILE [--readme PAGE] [--check PAGE] - from the JSON of rsh-bench ablation makes

  --readme  the table between the two lines "<!-- ablation: ... -->" of a page, in place
  --check   whether that page has the table that --readme would write; ends with 1 if not

Without any of these the table is printed. Measures nothing.
"""
import argparse
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import page_section

STATES = ("left_out", "compiled_in", "general", "used")
# A program of its own that saves less than both is not worth it.
LEAST_TIME, LEAST_COMPILATION = 0.01, 0.05


def load(path):
    document = json.loads(path.read_text())
    if document["suite"] != "ablation":
        raise SystemExit(f"{path}: suite is {document['suite']}, must be ablation")
    for case in document["cases"]:
        if not case["ok"]:
            raise SystemExit(f"{path}: {case['name']} is wrong")
    return document


def by_feature(document):
    """Of each feature, the metrics of its states."""
    found = {}
    for case in document["cases"]:
        params = case["params"]
        found.setdefault(params["feature"], {})[params["state"]] = case["metrics"]
    return found


def compilation(metrics):
    return metrics["compile_ms"] + metrics.get("finish_ms", 0)


def cell(metrics, is_first):
    if not metrics:
        return "–"
    ratio = "" if is_first else f" ({metrics['ratio']:.2f})"
    return (f"{metrics['ms']:.2f}{ratio} · {metrics['bytes'] / 2**20:.1f} · {metrics['launches']} · "
            f"{compilation(metrics) / 1000:.1f}")


def row(feature, states):
    first = next(state for state in STATES if state in states)
    cells = [cell(states.get(state), state == first) for state in STATES]
    return f"| {feature.replace('_', ' ')} | {' | '.join(cells)} |"


def saved(states):
    """Shares of time and compilation that leaving the feature out saves a scene that does not have it."""
    out, within = states["left_out"], states["compiled_in"]
    return 1 - 1 / within["ratio"], 1 - compilation(out) / compilation(within)


def verdicts(features):
    """Of features that can be both left out and compiled in."""
    both = {name: saved(states) for name, states in features.items()
            if "left_out" in states and "compiled_in" in states}
    described = "; ".join(f"{name.replace('_', ' ')} {time:.1%} and {compiled:.1%}"
                          for name, (time, compiled) in both.items())
    poor = [name.replace("_", " ") for name, (time, compiled) in both.items()
            if time < LEAST_TIME and compiled < LEAST_COMPILATION]
    return [f"- Leaving it out saves a scene without it, of time and of compilation: {described}.",
            f"- Less than {LEAST_TIME:.0%} and less than {LEAST_COMPILATION:.0%}: "
            f"{', '.join(poor) if poor else 'none'}."]


def table(document):
    features = by_feature(document)
    lines = ["| | left out | compiled in | general | used |", "|---|---|---|---|---|"]
    lines += [row(name, states) for name, states in features.items()]
    rounds = document["cases"][0]["metrics"]["rounds"]
    about = [f"- ms, median of {rounds} rounds in turn (in parentheses over the first column that there is, "
             "round by round) · MiB of all buffers · launches · seconds of processor time to compile.",
             *verdicts(features), page_section.measured_on(document)]
    return "\n".join([*lines, "", page_section.wrapped(about)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--readme", type=pathlib.Path)
    parser.add_argument("--check", type=pathlib.Path)
    options = parser.parse_args()
    text = table(load(options.file))
    if options.readme:
        options.readme.write_text(page_section.written(options.readme, "ablation", text))
    if options.check:
        page_section.check(options.check, "ablation", text, options.file)
    if not (options.readme or options.check):
        sys.stdout.write(text + "\n")


if __name__ == "__main__":
    main()
