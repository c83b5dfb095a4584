#!/usr/bin/env python3
"""mutations.py RSH_BENCH - breaks kernels on purpose, one bound at a time, and requires that the
families of rsh-bench stability that should notice do. Kernels are changed in a copy.

Not here, as no family can notice them alone, which is derived, not only measured:
- RSH_RAISED (rays/box_node.h). Boxes and origins are padded by 64u of their largest components, u =
  2^-24, and a hit lies within 31u of them; rounding the padded values takes 1u, the difference, the
  reciprocal and the product 7u of a distance that is at most their sum. 25u are left, so that near
  and far bounds do not have to be raised as well.
- The padding of cones (rays/cone_sphere.h) and the sine of a single ray (rays/build_cones.cl). Where
  divisions are rounded correctly, a hit lies within 6u of the distance beside its ray, its axis errs
  by 2u, the difference to the centre and the cross product by 2u each: 12u, of which the sine
  allows for 16u and the padding for 128u. Either is enough; one of them is needed.
"""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAD = ("mesh/boxes16.h", "return 0x1p-18f * largest + 0x1p-124f;", "return 0.0f;")
CONE = ("rays/cone_sphere.h", "sum + 0x1p-17f *", "sum + 0.0f *")
SINE = ("rays/build_cones.cl", "#define RSH_LEAF_SINE 0x1p-20f", "#define RSH_LEAF_SINE 0.0f")
TIE = ("traverse/packet_hits.h", "((uintv)(triangle->index) < packet->primitive[v])",
       "((uintv)(triangle->index) > packet->primitive[v])")
OFFSET = ("shade/branch.h", "rounded_to_side(start, side, sent.direction)", "from->point")
LEAVING = ("mesh/leaving.h", "if (!may_separate(of, ray, triangle)) return false;", "return false;")
BOTH = ("mesh/crossing.h", "if (!doubtful) return may_be;", "return may_be;")
AREA = ("mesh/intersect.h", "(floatv)(0x1p-102f)", "(floatv)(0x1p-24f)")

# What is changed, and in which engine which families notice it, if not by the closest hits then by
# another query.
MUTATIONS = {
    "boxes are not padded": ([PAD], "paper", ["long_legs"]),
    "neither cones nor rays are padded": ([CONE, SINE], "paper_faithful", ["corners_from_afar"]),
    "of equal t the higher wins": ([TIE], "paper", ["duplicates", "coplanar_layers", "layers_1e5"]),
    "spawned rays start where rounding puts them": ([OFFSET], "tiles", ["spawned_reflected",
                                                                         "spawned_refracted"]),
    "no plane separates a ray from what it left": ([LEAVING], "tiles", ["spawned_reflected"]),
    "small triangles are seen edge-on": ([AREA], "brute_force", ["sizes_apart"]),
    "both triangles of an edge are crossed": ([BOTH], "tiles", ["watertight_inside",
                                                                "watertight_outside",
                                                                "lattice_room"], "count"),
}


def change(folder, changes):
    for file, old, new in changes:
        path = folder / "kernels" / file
        text = path.read_text()
        if old not in text:
            raise SystemExit(f"{path} has no \"{old}\": the list of mutations must follow")
        path.write_text(text.replace(old, new))


def unnoticed(bench, folder, name):
    """The families of a mutation that are all right."""
    changes, engine, families, query = (*MUTATIONS[name], "closest")[:4]
    shutil.copytree(ROOT / "kernels", folder / "kernels")
    (folder / "include/rsh").mkdir(parents=True)
    shutil.copy(ROOT / "include/rsh/rsh_types.h", folder / "include/rsh")
    change(folder, changes)
    result = folder / "result.json"
    environment = dict(os.environ, RSH_KERNEL_DIR=str(folder / "kernels"),
                       RSH_CACHE_DIR=str(folder.parent / "cache"))
    done = subprocess.run(
        [bench, "stability", "--quick", "--json", result, "--filter",
         f"family:({'|'.join(families)})/engine:{engine}/.*query:{query}"],
        env=environment, capture_output=True, text=True)
    cases = json.loads(result.read_text())["cases"] if result.exists() else []
    if not cases or any("error" in c["metrics"] for c in cases):
        raise SystemExit(f"{name}: rsh-bench failed: {done.stdout}{done.stderr}")
    return [f for f in families
            if all(c["ok"] for c in cases if c["params"]["family"] == f)]


def main():
    bench = sys.argv[1]
    with tempfile.TemporaryDirectory() as work, concurrent.futures.ThreadPoolExecutor(2) as pool:
        folders = {name: pathlib.Path(work) / str(i) for i, name in enumerate(MUTATIONS)}
        missed = pool.map(lambda name: unnoticed(bench, folders[name], name), MUTATIONS)
        failures = 0
        for name, families in zip(MUTATIONS, missed):
            print(f"{name}: " + (f"NOT NOTICED by {', '.join(families)}" if families else
                                 f"noticed by {', '.join(MUTATIONS[name][2])}"))
            failures += bool(families)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
