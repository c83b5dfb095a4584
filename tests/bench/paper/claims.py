"""What the measurements say to each claim of the paper: a section of docs/paper.md each."""
import statistics

from paper.cases import ENGINES, TITLES, by_row, of_engine, series, summary, told
from reporting.results import wrapped


def number(value, digits=2):
    return "not measured" if value is None else f"{value:.{digits}f}"


def by_engine(results, metric, digits=2):
    return ", ".join(f"{engine} {number(summary(results, engine).get(metric), digits)}" for engine in ENGINES)


def triangles(results):
    lines = []
    for row, title in TITLES.items():
        lines.append(f"- {title}: exponent of time over triangles {by_engine(results, row + '_exponent')}; "
                     f"nanoseconds per further triangle {by_engine(results, row + '_ns_per_triangle', 0)}.")
        batches = [f"{batches:.0f}" for _, batches in
                   series(results, row, "triangles", "paper_faithful", "batches")]
        if batches:
            lines.append(f"- {title}: batches of paper_faithful, by size: {', '.join(batches)}.")
    return wrapped(lines)


def pixels(results):
    lines = [f"- Exponent of time over pixels: {by_engine(results, 'pixels_exponent')}."]
    for engine in ENGINES:
        sizes = ", ".join(f"{width}² {ms:.1f}" for width, ms in
                          series(results, "resolution", "width", engine))
        if sizes:
            lines.append(f"- {engine}, milliseconds: {sizes}.")
    return wrapped(lines)


def build(results):
    lines = []
    for case in by_row(results).get("build", []):
        metrics, engine = case["metrics"], case["params"]["engine"]
        lines.append(f"- {engine}: 1 M rays in {metrics['ms']:.1f} ms (paper: {metrics['paper_ms']:g}), "
                     f"{metrics['build_over_copy']:.2f} times as long as to copy them.")
    lines.append(f"- Most that it takes of bound, build and traversal in a row: "
                 f"{by_engine(results, 'build_share', 3)}.")
    return wrapped(lines)


def median_share(cases, stage):
    shares = [case["metrics"][stage] / case["metrics"]["ms"] for case in cases]
    return (statistics.median(shares), min(shares), max(shares)) if shares else None


def tests(results):
    cases = told(results, "paper_faithful")
    lines = []
    for stage, name in (("ms_tests", "cones against spheres"), ("ms_reduction", "reduction"),
                        ("ms_intersect", "rays against triangles")):
        found = median_share(cases, stage)
        if found:
            lines.append(f"- {name}: {found[0]:.0%} of bound, build and traversal in the median row, "
                         f"{found[1]:.0%} to {found[2]:.0%}.")
    for case in cases:
        metrics = case["metrics"]
        lines.append(f"- {case['params']['row'].replace('_', ' ')}: {metrics['node_tests'] / metrics['rays']:.0f} "
                     f"tests of spheres and {metrics['ray_tests'] / metrics['rays']:.0f} of triangles a ray.")
    return wrapped(lines)


def spheres(results):
    lines = []
    for case in by_row(results).get("sphere_for_triangle", []):
        metrics = case["metrics"]
        cost = metrics["triangle_ns"] / metrics["sphere_ns"]
        lines.append(f"- {case['params']['scene']}: {metrics['false_positives']:.0%} of the cones that a "
                     f"triangle's sphere meets do not meet the triangle. Spheres need "
                     f"{metrics['break_even']:.2f} times the tests of cones and leave "
                     f"{metrics['ray_tests_ratio']:.1f} times the rays, but a test of the triangle costs "
                     f"{cost:.1f} times one of its sphere: the descent by triangles takes "
                     f"{metrics['exact_over_sphere']:.2f} times as long.")
    return wrapped(lines)


TOP = 3  # levels: 64 nodes


def left_after_top(pairs):
    """Share of all pairs of a triangle and one of the 4^TOP nodes that the tests above left. The last stream
    is of all triangles and the root."""
    return pairs[-1 - TOP] / (pairs[-1] * 4**TOP) if len(pairs) > TOP else None


def top_levels(results):
    lines = []
    for case in told(results, "paper_faithful"):
        params = case["params"]
        left = left_after_top(case["metrics"].get("pairs_by_level", []))
        if left is not None:
            lines.append(f"- {params['row'].replace('_', ' ')}: {left:.0%} of the pairs of a triangle and one of "
                         f"{4**TOP} nodes are left after {TOP} levels, where {params['spawn_share']:.0%} of the "
                         "pixels spawn rays.")
    return wrapped(lines)


def occlusion(results):
    lines = [f"- 16 sheets behind each other against one sheet of as many triangles: "
             f"{by_engine(results, 'occlusion_ratio', 1)} times as long."]
    for engine in ENGINES:
        layers = ", ".join(f"{count} {ms:.0f}" for count, ms in series(results, "occlusion", "layers", engine))
        if layers:
            lines.append(f"- {engine}, milliseconds by sheets: {layers}.")
    return wrapped(lines)


def reduction(results):
    cases = {case["params"]["strategy"]: case["metrics"] for case in by_row(results).get("reduction", [])
             if "strategy" in case["params"]}
    lines = ["| strategy | reduction, ms | bound + build + traversal, ms |", "|---|--:|--:|"]
    lines += [f"| {name} | {metrics['ms_reduction']:.1f} | {metrics['ms']:.1f} |"
              for name, metrics in sorted(cases.items(), key=lambda item: item[1]["ms_reduction"])]
    if not {"block", "block_search", "scan_scatter", "horn"} <= cases.keys():
        return "\n".join(lines)

    def times(rival, own):
        return f"{cases[rival]['ms_reduction'] / cases[own]['ms_reduction']:.1f}"

    about = [f"- With searches in place of scatter, as on the cards of 2007: horn takes "
             f"{times('horn', 'block_search')} times as long as block_search, the paper's own.",
             f"- With scatter: scan_scatter takes {times('scan_scatter', 'block')} times as long as block, the "
             "paper's own."]
    return "\n".join([*lines, "", wrapped(about)])


def since(results):
    """tiles over paper_faithful on the same machine, and both over the paper's card."""
    faithful = {case["name"].rsplit("/", 1)[0]: case["metrics"] for case in told(results, "paper_faithful")}
    lines = []
    for case in told(results, "tiles"):
        other = faithful.get(case["name"].rsplit("/", 1)[0])
        if other:
            metrics = case["metrics"]
            lines.append(f"- {case['params']['row'].replace('_', ' ')}: paper_faithful {other['speedup']:.2f} times as "
                         f"quick as the paper's card, tiles {metrics['speedup']:.1f}; of the two, "
                         f"{other['ms'] / metrics['ms']:.0f} times.")
    return wrapped(lines)


def frames(results):
    lines = []
    for row in ("museum3", "museum8"):
        for case in by_row(results).get(row, []):
            metrics, engine = case["metrics"], case["params"]["engine"]
            times = metrics.get("ms_by_frame", [])
            if times:
                lines.append(f"- {row}, {engine}: {len(times)} frames, {min(times):.0f} to {max(times):.0f} ms, "
                             f"mean {metrics['ms']:.0f}.")
    return wrapped(lines)


def batches(results):
    lines = []
    series_of_batches = series(results, "batches", "batches", "tiles")
    if series_of_batches:
        times = ", ".join(f"{count:.0f}: {ms:.1f}" for count, ms in series_of_batches)
        slope = number(summary(results, "tiles").get("ms_per_batch"))
        lines.append(f"- One scene in so many batches, milliseconds: {times}. A further batch: {slope}; the "
                     "paper's: 30.")
    for case in by_row(results).get("large_batches", []):
        if "ms" in case["metrics"]:
            lines.append(f"- {case['params']['triangles'] / 1e6:.1f} million triangles in "
                         f"{case['params']['batches']} batches: {case['metrics']['ms']:.0f} ms, the frame "
                         f"{case['metrics']['frame_ms']:.0f}; the paper's: 18500.")
    for case in by_row(results).get("out_of_core", []):
        if "frame_ms" in case["metrics"]:
            metrics, mib = case["metrics"], 1 << 20
            lines.append(f"- {case['params']['triangles'] / 1e6:.1f} million triangles, one reflection and a "
                         f"shadow, within {case['params']['budget'] / mib:.0f} MiB of the device's memory: "
                         f"{metrics['frame_ms'] / 1000:.1f} s a frame, the process {metrics['process_bytes'] / mib:.0f} "
                         "MiB.")
    return wrapped(lines)


SECTIONS = {"paper-triangles": triangles, "paper-pixels": pixels, "paper-build": build, "paper-tests": tests,
            "paper-spheres": spheres, "paper-top-levels": top_levels, "paper-occlusion": occlusion,
            "paper-reduction": reduction, "paper-since": since, "paper-frames": frames, "paper-batches": batches}
