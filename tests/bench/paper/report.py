"""Of rsh-bench paper: the figures of the paper's talk beside ours, and what the measurements say to each of its
claims."""
from paper import claims
from paper.cases import ENGINES, by_row, of_engine
from reporting.results import measured_on, wrapped


def time_cell(case):
    if not case or "ms" not in case["metrics"]:
        return "–"
    metrics = case["metrics"]
    frame = f" ({metrics['frame_ms']:.0f})" if "frame_ms" in metrics else ""
    return f"{metrics['ms']:.1f}{frame}"


def row_line(name, cases):
    """The case of each engine, at the size that the paper tells of."""
    engines = {case["params"]["engine"]: case for case in cases}
    first = cases[0]
    params, paper_ms = first["params"], first["metrics"]["paper_ms"]
    tiles = engines.get("tiles")
    speedup = f"{tiles['metrics']['speedup']:.1f}" if tiles else "–"
    rays = f"{100 * params['spawn_share']:.0f} %"
    if "reflectors" in params:
        rays += f" of {params['reflectors']} reflectors"
    cells = [time_cell(engines.get(engine)) for engine in ENGINES]
    return (f"| {name.replace('_', ' ')} | {params['scene']} | {params['triangles'] / 1000:.0f} | {rays} "
            f"| {paper_ms:g} | {' | '.join(cells)} | {speedup} |")


def table(results):
    lines = ["| | scene | thousand triangles | pixels that spawn rays | paper | paper_faithful | paper (engine) "
             "| tiles | times |", "|---|---|--:|--:|--:|--:|--:|--:|--:|"]
    for name, cases in by_row(results).items():
        told = [case for case in cases if "paper_ms" in case["metrics"]]
        if told:
            lines.append(row_line(name, told))
    about = ["- Milliseconds of bounding the scene, building the hierarchy over the rays and traversing, of all "
             "waves of a frame, by events; in parentheses the whole frame by the host's clock. The paper's: "
             "GeForce 8800 GTS, 2007. Times: the paper's over those of tiles.",
             measured_on(results)]
    return "\n".join([*lines, "", wrapped(about)])


STAGES = {"share_build": "bounds and hierarchy", "share_tests": "cones against spheres",
          "share_reduction": "reduction", "share_intersect": "rays against triangles",
          "share_shade": "shading", "share_other": "other"}


def stages(results):
    """Shares of the frame of the rows that the paper gives a time for, a line for each engine of interest."""
    lines = [f"| | | {' | '.join(STAGES.values())} |", "|---|---" + "|--:" * len(STAGES) + "|"]
    for name, cases in by_row(results).items():
        for engine in ("paper_faithful", "tiles"):
            for case in of_engine(cases, engine):
                if "paper_ms" in case["metrics"] and "share_build" in case["metrics"]:
                    cells = [f"{100 * case['metrics'][share]:.0f}" for share in STAGES]
                    lines.append(f"| {name.replace('_', ' ')} | {engine} | {' | '.join(cells)} |")
    about = ["- Percent of a frame. Of tiles, which goes from packets of rays to triangles in one kernel, all of "
             "the traversal counts as rays against triangles. Other: the camera's rays, spawning, clears, waits "
             "of the host.", measured_on(results)]
    return "\n".join([*lines, "", wrapped(about)])


SECTIONS = {"paper-stages": stages, **claims.SECTIONS}
