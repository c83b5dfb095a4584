"""Of rsh-bench approximate: how many times as quick as an exact frame of the same size each scene is, and how
far its picture is off."""
from reporting.results import measured_on, wrapped

# What an approximate frame is for: so much quicker, and nobody sees the difference.
LEAST_RATIO, MOST_FLIP, MOST_ABOVE = 1.5, 0.02, 0.001


def shortfalls(metrics):
    found = [f"{metrics['ratio']:.2f} times"] if metrics["ratio"] < LEAST_RATIO else []
    is_seen = metrics["flip"] >= MOST_FLIP or metrics["flip_above"] > MOST_ABOVE
    return found + ["seen"] if is_seen else found


def is_worth_it(metrics):
    return not shortfalls(metrics)


def by_scene(results):
    """Scene -> (width, tolerance) -> case."""
    found = {}
    for case in results.cases:
        params = case["params"]
        found.setdefault(params["scene"], {})[params["width"], params["tolerance"]] = case
    return found


def cell(case):
    if not case:
        return "–"
    metrics = case["metrics"]
    text = (f"{metrics['ratio']:.2f} ({metrics['ratio_cpu']:.2f}) · {metrics['flip']:.4f} · "
            f"{100 * metrics['flip_above']:.3f}")
    return f"**{text}**" if is_worth_it(metrics) else text


def columns(results):
    return sorted({(case["params"]["width"], case["params"]["tolerance"]) for case in results.cases})


def traced(scenes, width):
    """Shares of pixels, by scene, from the smallest tolerance to the largest."""
    found = {scene: [f"{100 * case['metrics']['traced']:.0f}" for (its, _), case in sorted(cases.items())
                     if its == width]
             for scene, cases in scenes.items()}
    return ", ".join(f"{scene} {'/'.join(shares)}" for scene, shares in found.items() if shares)


def verdict(scenes, width, tolerance):
    """Which scenes are worth it and which are not, with one size and one tolerance."""
    cases = {scene: found[width, tolerance]["metrics"]
             for scene, found in scenes.items() if (width, tolerance) in found}
    good = [scene for scene, metrics in cases.items() if is_worth_it(metrics)]
    poor = [f"{scene} ({', '.join(shortfalls(metrics))})"
            for scene, metrics in cases.items() if scene not in good]
    return (f"- {LEAST_RATIO:g} times as quick and hardly seen, {width} pixels wide with {tolerance:g}: "
            f"{', '.join(good) or 'none'}. Not so: {', '.join(poor) or 'none'}.")


def table(results):
    scenes = by_scene(results)
    points = columns(results)
    lines = []
    for tolerance in sorted({tolerance for _, tolerance in points}):
        widths = [width for width, its in points if its == tolerance]
        lines += [f"| tolerance {tolerance:g} | {' | '.join(f'{width} wide' for width in widths)} |",
                  "|---" + "|--:" * len(widths) + "|"]
        lines += [f"| {scene} | {' | '.join(cell(cases.get((width, tolerance))) for width in widths)} |"
                  for scene, cases in scenes.items()]
        lines.append("")
    widest = max(width for width, _ in points)
    about = [verdict(scenes, width, tolerance) for width, tolerance in points if width == widest]
    about += [f"- Percent of the pixels that are traced, of those that see something, {widest} wide, by "
              f"tolerance: {traced(scenes, widest)}.",
              measured_on(results)]
    return "\n".join([*lines, wrapped(about)])
