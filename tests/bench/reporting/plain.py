"""The table of a suite that has none of its own: a row per case, a column per metric that is compared."""
from reporting.metrics import COSTS, FAULTS
from reporting.results import measured_on, wrapped


def cell(value):
    if value is None or isinstance(value, (bool, int)):
        return "" if value is None else str(int(value))
    return f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"


def table(results):
    names = [name for name in (*COSTS.get(results.suite, {}), *FAULTS)
             if any(name in case["metrics"] for case in results.cases)]
    lines = [f"| case | {' | '.join(name.replace('_', ' ') for name in names)} |",
             "|---" * (len(names) + 1) + "|"]
    for case in results.cases:
        cells = [cell(case["metrics"].get(name)) for name in names]
        lines.append(f"| {case['name'].removeprefix(results.suite + '/')} | {' | '.join(cells)} |")
    return "\n".join([*lines, "", wrapped([measured_on(results)])])
