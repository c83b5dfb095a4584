#!/usr/bin/env python3
"""compare_open3d.py [RAYS] - rsh.open3d beside Open3D, in an environment that has both: the same calls on
the same mesh, a wavy sheet over a box; prints how many rays differ in what, and by how much t does.
Ends with 1 when more than one in 1000 differs in an id or a count: rays near edges may."""
import sys

import numpy as np
import open3d
import rsh.open3d


def meshes():
    sheet = np.stack(np.meshgrid(*[np.linspace(-1, 1, 60)] * 2), -1).reshape(-1, 2)
    height = 0.1 * np.sin(7 * sheet[:, :1]) * np.cos(5 * sheet[:, 1:])
    corner = np.arange(60 * 60).reshape(60, 60)
    a, b, c, d = (corner[i, j].ravel() for i, j in (
        np.s_[:-1, :-1], np.s_[:-1, 1:], np.s_[1:, :-1], np.s_[1:, 1:]))
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([b, d, c], 1)])
    yield np.hstack([sheet, height]).astype(np.float32), faces.astype(np.uint32)
    box = open3d.t.geometry.TriangleMesh.create_box().translate([-0.5, -0.5, -2])
    yield box.vertex.positions.numpy(), box.triangle.indices.numpy().astype(np.uint32)


def answers(scene, tensor, count):
    for vertices, faces in meshes():
        scene.add_triangles(tensor(vertices), tensor(faces))
    random = np.random.default_rng(1)
    origins = random.uniform(-2, 2, (count, 3))
    rays = tensor(np.hstack([origins, random.uniform(-0.8, 0.8, (count, 3)) - origins]).astype(np.float32))
    view = scene.create_rays_pinhole(
        fov_deg=60, center=[0, 0, 0], eye=[1, -2, 1], up=[0, 0, 1], width_px=320, height_px=240)
    yield "pinhole", view
    for name, cast in ("view", scene.cast_rays(view)), ("random", scene.cast_rays(rays)):
        yield from ((f"{name} {key}", values) for key, values in sorted(cast.items()))
    yield "test_occlusions", scene.test_occlusions(rays, tnear=0.2, tfar=1.0)
    yield "count_intersections", scene.count_intersections(rays)
    listed = scene.list_intersections(rays)
    yield "keys", tuple(sorted(listed))
    yield "list per ray", np.diff(listed["ray_splits"].numpy().astype(np.int64))


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100000
    theirs = answers(open3d.t.geometry.RaycastingScene(), open3d.core.Tensor, count)
    ours = answers(rsh.open3d.RaycastingScene(), np.asarray, count)
    is_same = True
    for (name, expected), (_, found) in zip(theirs, ours, strict=True):
        if name == "keys":
            is_same &= expected == found
            continue
        expected = expected.numpy() if hasattr(expected, "numpy") else expected
        assert found.shape == expected.shape and found.dtype == expected.dtype, name
        if expected.dtype.kind == "f":
            is_hit = np.isfinite(expected) & np.isfinite(found)
            error = np.abs(expected[is_hit] - found[is_hit])
            print(f"{name}: median difference {np.median(error):.2g}, "
                  f"99.9 % within {np.quantile(error, 0.999):.2g}")
            continue
        share = np.mean(expected != found)
        print(f"{name}: {100 * share:.4f} % differ")
        is_same &= bool(share < 0.001)
    return 0 if is_same else 1


if __name__ == "__main__":
    sys.exit(main())
