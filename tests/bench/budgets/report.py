"""Of rsh-bench budgets: the table of docs/numerics.md. Its rows begin with a bound in backticks; what, unit and
remark are the page's own:

    | bound | what | unit | correct | rough | granted | evaluations | remark |
    | `hit_depth` | ... | ... | 8.08 of 12 | 14.8 of 20 | 20 | 1.0e+08 | ... |
"""
import re

from reporting.results import measured_on, wrapped

CORRECT, EVALUATIONS = 4, 7  # first and last cell of a row that is filled


def by_bound(results):
    found = {}
    for case in results.cases:
        found.setdefault(case["params"]["bound"], {})[case["params"]["division"]] = case
    return found


def figure(case):
    return f"{case['metrics']['measured_u']:.3g} of {case['metrics']['derived_u']:.4g}" if case else "-"


def cells(divisions):
    """Correct, rough, granted, evaluations."""
    correct = divisions["correct"]
    least = min(case["metrics"]["evaluations"] for case in divisions.values())
    return [figure(correct), figure(divisions.get("rough")), f"{correct['metrics']['granted_u']:.4g}",
            f"{least:.1e}"]


def table(results):
    lines = ["| bound | unit | correct | rough | granted | evaluations |", "|---" * 6 + "|"]
    for bound, divisions in by_bound(results).items():
        unit = divisions["correct"]["params"]["unit"]
        lines.append(f"| `{bound}` | {unit} | {' | '.join(cells(divisions))} |")
    return "\n".join([*lines, "", wrapped([measured_on(results)])])


def filled_row(line, bounds, names):
    row = line.split("|")
    name = re.match(r"\| `(\w+)` \|", line)
    if not name:
        return line
    if name[1] not in bounds:
        raise SystemExit(f"{names}: has no case for `{name[1]}`, which the table has a row for")
    row[CORRECT:EVALUATIONS + 1] = [f" {cell} " for cell in cells(bounds[name[1]])]
    return "|".join(row)


def filled(results, present):
    """The rows that there are, with the figures of the results."""
    bounds = by_bound(results)
    rows = [line for line in present.split("\n") if line.startswith("|")]
    without = [bound for bound in bounds if not any(row.startswith(f"| `{bound}` |") for row in rows)]
    if without:
        raise SystemExit(f"{results.names()}: has cases for {', '.join(without)}, "
                         "which the table has no row for")
    filled_rows = [filled_row(row, bounds, results.names()) for row in rows]
    return "\n".join([*filled_rows, "", wrapped([measured_on(results)])])
