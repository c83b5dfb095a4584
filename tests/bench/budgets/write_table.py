#!/usr/bin/env python3
"""write_table.py JSON... MARKDOWN - puts the figures of rsh-bench budgets into the table of
docs/numerics.md. Its rows begin with a bound in backticks; what, unit and remark are the text's own:

    | bound | what | unit | correct | rough | granted | evaluations | remark |
    | `hit_depth` | ... | ... | 8.08 of 12 | 14.8 of 20 | 20 | 1.0e+08 | ... |

Ends with 1, and leaves the file alone, where a row has no case, or a case no row, or was wrong."""
import json
import re
import sys

CORRECT, ROUGH, GRANTED, EVALUATIONS = 4, 5, 6, 7  # cells of a row


def read_cases(paths):
    cases = {}
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for case in json.load(file)["cases"]:
                cases[case["params"]["bound"], case["params"]["division"]] = case
    return cases


def figure(case):
    metrics = case["metrics"]
    return f"{metrics['measured_u']:.3g} of {metrics['derived_u']:.4g}"


def filled(line, cases, seen):
    name = re.match(r"\| `(\w+)` \|", line)
    if not name:
        return line
    cells = line.split("|")
    correct = cases[name[1], "correct"]
    rough = cases.get((name[1], "rough"))
    seen.add(name[1])
    cells[CORRECT] = f" {figure(correct)} "
    cells[ROUGH] = f" {figure(rough)} " if rough else " - "
    cells[GRANTED] = f" {correct['metrics']['granted_u']:.4g} "
    least = min(case["metrics"]["evaluations"] for case in (correct, rough) if case)
    cells[EVALUATIONS] = f" {least:.1e} "
    return "|".join(cells)


def main(paths, markdown):
    cases = read_cases(paths)
    wrong = [case["name"] for case in cases.values() if not case["ok"]]
    if wrong:
        sys.exit(f"wrong: {', '.join(wrong)}")
    with open(markdown, encoding="utf-8") as file:
        text = file.read()
    begin = text.index("\n## Budgets\n")
    end = text.index("\n## ", begin + 1)
    seen = set()
    try:
        lines = [filled(line, cases, seen) for line in text[begin:end].split("\n")]
    except KeyError as missing:
        sys.exit(f"{markdown}: no case for {missing}")
    without = {bound for bound, _ in cases} - seen
    if without:
        sys.exit(f"{markdown}: no row for {', '.join(sorted(without))}")
    with open(markdown, "w", encoding="utf-8") as file:
        file.write(text[:begin] + "\n".join(lines) + text[end:])


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1:-1], sys.argv[-1])
