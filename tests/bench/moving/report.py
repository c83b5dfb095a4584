"""Of rsh-bench moving: the costs of an object that moves in a scene that stands still, beside those of the object
alone and of one tree, and the frames of a scene that moves as a whole."""
from reporting.results import measured_on, wrapped


def pair(metrics, name, other, ratio):
    return (f"{metrics[name]:.2f} | {metrics[other]:.2f} | {metrics[f'{ratio}_ratio']:.2f} "
            f"({metrics[f'{ratio}_cpu_ratio']:.2f})")


def object_lines(cases):
    lines = ["| still + moving triangles | bounds, ms | of the object alone | ratio | traversal, ms | of one tree | "
             "ratio |", "|---|--:|--:|--:|--:|--:|--:|"]
    for case in cases:
        params, metrics = case["params"], case["metrics"]
        lines.append(f"| {params['still']:,} + {params['moving']:,} | "
                     f"{pair(metrics, 'bound_ms', 'alone_ms', 'bound')} | "
                     f"{pair(metrics, 'traverse_ms', 'one_tree_ms', 'traverse')} |")
    return lines


def frames_line(case):
    params, metrics = case["params"], case["metrics"]
    return (f"- {params['frames']} frames of {params['triangles']:,} moving triangles, "
            f"{params['width']}x{params['height']}, one reflection: {metrics['ms']:.1f} ms each, the first one "
            f"{metrics['first_ms']:.0f}; the program's memory grew by {metrics['grown_kib'] / 1024:.1f} MiB.")


def table(results):
    timed = [case for case in results.cases if case["ok"]]
    objects = [case for case in timed if "still" in case["params"]]
    lines = object_lines(objects) + [""] if objects else []
    about = ["- Ratios are medians over rounds, in parentheses of CPU time, where other programs count for less."]
    about += [frames_line(case) for case in timed if "frames" in case["params"]]
    return "\n".join([*lines, wrapped([*about, measured_on(results)])])
