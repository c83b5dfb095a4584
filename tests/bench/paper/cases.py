"""Cases of rsh-bench paper, found by what they are."""
ENGINES = ("paper_faithful", "paper", "tiles")
TITLES = {"patio": "one reflector", "less_coherent": "several reflectors", "statue": "mirror statue"}


def by_row(results):
    """Row -> its cases, in the order in which they were measured."""
    found = {}
    for case in results.cases:
        found.setdefault(case["params"]["row"], []).append(case)
    return found


def of_engine(cases, engine):
    return [case for case in cases if case["params"].get("engine") == engine]


def series(results, row, parameter, engine, metric="ms"):
    """(parameter, metric) of the cases of a row, ascending."""
    return sorted((case["params"][parameter], case["metrics"][metric])
                  for case in of_engine(by_row(results).get(row, []), engine) if metric in case["metrics"])


def summary(results, engine):
    """What summary.hpp says of an engine; empty if it measured nothing."""
    found = of_engine(by_row(results).get("summary", []), engine)
    return found[0]["metrics"] if found else {}


def told(results, engine):
    """Cases of rows that the paper gives a time for, but for the build."""
    return [case for case in results.cases
            if case["params"].get("engine") == engine and "paper_ms" in case["metrics"]
            and case["params"]["row"] != "build"]
