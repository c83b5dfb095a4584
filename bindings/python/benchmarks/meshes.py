"""Meshes whose vertices are all new in each frame, and the rays that are traced against them."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rsh.__main__ import sheet

Floats = NDArray[np.float32]
SIDE = 512


@dataclass
class Moving:
    """`vertices(phase)` of `faces`; the numbers are those of a frame."""

    name: str
    vertices: Callable[[float], Floats]
    faces: NDArray[np.uint32]


def waving_sheet(cells: int) -> Moving:
    """Return 2 cells^2 triangles over (-1, 1)^2."""
    faces = sheet(cells, 0.0)[1].astype(np.uint32)
    return Moving("sheet", lambda phase: sheet(cells, phase)[0], faces)


def waving_sphere(splits: int) -> Moving:
    """Return an icosahedron whose triangles are split in four so often, about as large as the sheet."""
    points, faces = _icosphere(splits)

    def vertices(phase: float) -> Floats:
        radius = 0.8 + 0.1 * np.sin(5 * points[:, :1] + phase) * np.cos(5 * points[:, 1:2])
        return (radius * points).astype(np.float32)

    return Moving("sphere", vertices, faces)


def _icosphere(splits: int) -> tuple[NDArray[np.float64], NDArray[np.uint32]]:
    golden = (1 + 5**0.5) / 2
    points = np.array(
        [np.roll([0, s, t * golden], k) for k in range(3) for s in (-1, 1) for t in (-1, 1)], float
    )
    near = np.linalg.norm(points[:, None] - points[None], axis=-1) < 2.1
    np.fill_diagonal(near, False)
    corners = [(a, b, c) for a in range(12) for b in range(a) for c in range(b)]
    faces = np.array([k for k in corners if near[k[0], k[1]] and near[k[1], k[2]] and near[k[0], k[2]]])
    for _ in range(splits):
        points, faces = _split(points, faces)
    return points / np.linalg.norm(points, axis=1, keepdims=True), faces.astype(np.uint32)


def _split(
    points: NDArray[np.float64], faces: NDArray[np.int64]
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Put a point on the middle of each edge."""
    edges = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2))
    edges, of_face = np.unique(edges, axis=0, return_inverse=True)
    ab, bc, ca = (len(points) + of_face.reshape(-1, 3)).T
    a, b, c = faces.T
    middles = points[edges].mean(1)
    middles /= np.linalg.norm(middles, axis=1, keepdims=True)
    split = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return np.vstack([points, middles]), np.stack([np.stack(k, 1) for k in split], 1).reshape(-1, 3)


def camera_rays() -> Floats:
    """Return a screen of rays down upon the mesh, row by row: neighbours agree."""
    x, y = np.meshgrid(*[(np.arange(SIDE) + 0.5) / SIDE * 2 - 1] * 2)
    rays = np.zeros((SIDE, SIDE, 6), np.float32)
    rays[..., 2], rays[..., 3], rays[..., 4], rays[..., 5] = 2.2, 0.45 * x, 0.45 * y, -1
    return rays


def random_rays() -> Floats:
    """Return as many from points around the mesh to points in its box, in no order."""
    random = np.random.default_rng(1)
    origins, targets = (random.uniform(-1, 1, (SIDE * SIDE, 3)) for _ in range(2))
    origins[:, 2] += 1.5
    targets[:, 2] *= 0.1
    return np.hstack([origins, targets - origins]).astype(np.float32)
