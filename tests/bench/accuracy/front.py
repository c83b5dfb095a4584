"""The cases of rsh-bench accuracy, by scene and axis, and those that no other case beats: the front."""
DEFAULT = "default"


def by_scene(cases):
    found = {}
    for case in cases:
        found.setdefault(case["params"]["scene"], []).append(case)
    return found


def by_axis(cases):
    """In order of appearance."""
    found = {}
    for case in cases:
        found.setdefault(case["params"]["axis"], []).append(case)
    return found


def label(case):
    params = case["params"]
    if params["axis"] == DEFAULT:
        return DEFAULT
    name = params["axis"].replace("_", " ")
    return f"{name} {params['value'].replace('_', ' ')}"


def front(cases):
    """Those for which no case has less time and less error, the quickest first."""
    best, found = float("inf"), []
    for case in sorted(cases, key=lambda case: (case["metrics"]["ms"], case["metrics"]["rmse"])):
        if case["metrics"]["rmse"] < best:
            best = case["metrics"]["rmse"]
            found.append(case)
    return found


def about(cases):
    """How many points of how many axes, and how far apart their times are."""
    points = front(cases)
    axes = {case["params"]["axis"] for case in points} - {DEFAULT}
    times = points[-1]["metrics"]["ms"] / points[0]["metrics"]["ms"]
    return f"{len(points)} points of {len(axes)} axes, {times:.0f} times apart"
