"""What Open3D's RaycastingScene answers of rays, answered by rsh. Needs no open3d, but takes its tensors."""

from typing import Any

import numpy as np
import pyopencl as cl
from numpy.typing import NDArray

from rsh._arrays import on_host, require
from rsh._context import Context
from rsh._rays import make_rays
from rsh.constants import NO_HIT
from rsh.open3d._pinhole import look_at, pinhole_rays
from rsh.scene import Scene


class Tensor(np.ndarray[Any, Any]):
    """An array of NumPy that also has the method by which programs for Open3D ask for one."""

    def numpy(self) -> NDArray[Any]:
        """Return the array."""
        return self.view(np.ndarray)


class RaycastingScene:
    """Meshes that rays are cast against.

    Rays are (..., 6): origin and direction, of any length but zero; t counts in units of that length. Answers
    have the shape of the rays without the 6.

    Parameters
    ----------
    nthreads : int, optional
        Is ignored: the OpenCL device has its own.
    queue, context
        As of `rsh.Scene`.
    """

    INVALID_ID = NO_HIT

    def __init__(
        self, nthreads: int = 0, *, queue: cl.CommandQueue | None = None, context: Context | None = None
    ) -> None:
        self._queue, self._context = queue, context
        self._meshes: list[tuple[NDArray[Any], NDArray[Any]]] = []
        self._starts = np.zeros(1, np.int64)
        self._scene: Scene | None = None

    def add_triangles(self, vertex_positions: Any, triangle_indices: Any = None) -> int:
        """Add a mesh.

        Parameters
        ----------
        vertex_positions : array_like, (n, 3), or a mesh
            What has `vertex.positions` and `triangle.indices` is taken for both.
        triangle_indices : array_like, (m, 3)

        Returns
        -------
        int
            Its geometry id.
        """
        if triangle_indices is None:
            mesh = vertex_positions
            vertex_positions, triangle_indices = mesh.vertex.positions, mesh.triangle.indices
        vertices = on_host("vertex_positions", _as_numpy(vertex_positions))
        faces = on_host("triangle_indices", _as_numpy(triangle_indices), np.uint32)
        for name, array in (("vertex_positions", vertices), ("triangle_indices", faces)):
            require(array.ndim == 2 and array.shape[1] == 3, name, array, "(n, 3)")
        if faces.size and faces.max() >= len(vertices):
            raise ValueError(f"triangle_indices has {faces.max()}, must be below {len(vertices)}")
        self._meshes.append((vertices, faces))
        self._starts = np.append(self._starts, self._starts[-1] + len(faces))
        self._scene = None
        return len(self._meshes) - 1

    def cast_rays(self, rays: Any, nthreads: int = 0) -> dict[str, Tensor]:
        """Find the closest hits.

        Returns
        -------
        dict
            `t_hit`: inf for a miss; `geometry_ids`, `primitive_ids`: index of the triangle in its mesh, both
            INVALID_ID for a miss; `primitive_uvs`; `primitive_normals`: unit, 0 for a miss.
        """
        taken = _taken(rays)
        hits = self._current().closest(taken.reshape(-1, 6), normal=True)
        answer = self._described(hits)
        answer["primitive_normals"] = hits.normal
        shape = taken.shape[:-1]
        return {key: values.reshape(shape + values.shape[1:]).view(Tensor) for key, values in answer.items()}

    def test_occlusions(
        self, rays: Any, tnear: float = 0.0, tfar: float = np.inf, nthreads: int = 0
    ) -> Tensor:
        """Tell whether rays hit anything with tnear <= t <= tfar, as bool."""
        taken = _taken(rays)
        ends = make_rays(taken[..., :3], taken[..., 3:], tnear, tfar)
        is_hit: NDArray[Any] = self._current().any(ends.reshape(-1, 8))
        return is_hit.reshape(taken.shape[:-1]).view(Tensor)

    def count_intersections(self, rays: Any, nthreads: int = 0) -> Tensor:
        """Count the triangles that each ray crosses, as int32; rsh_traverse says how edges count."""
        taken = _taken(rays)
        counts: NDArray[Any] = self._current().count(taken.reshape(-1, 6)).astype(np.int32)
        return counts.reshape(taken.shape[:-1]).view(Tensor)

    def list_intersections(self, rays: Any, nthreads: int = 0) -> dict[str, Tensor]:
        """List the triangles that rays cross, ray by ray and by t.

        Returns
        -------
        dict
            `ray_splits`, (rays + 1,): ray i has those from ray_splits[i] up to ray_splits[i + 1]; `ray_ids`,
            `t_hit`, `geometry_ids`, `primitive_ids`, `primitive_uvs` of each.
        """
        hits, offsets = self._current().all(_taken(rays).reshape(-1, 6))
        answer = self._described(hits)
        answer["ray_splits"] = offsets.astype(np.uint32)
        counts = np.diff(offsets).astype(np.int64)
        answer["ray_ids"] = np.repeat(np.arange(len(counts), dtype=np.uint32), counts)
        return {key: values.view(Tensor) for key, values in answer.items()}

    @staticmethod
    def create_rays_pinhole(*args: Any, **kwargs: Any) -> Tensor:
        """Make the rays of a camera: (height_px, width_px, 6), float32, through the pixels' centres.

        Parameters
        ----------
        intrinsic_matrix, extrinsic_matrix : array_like, (3, 3) and (4, 4)
            Of the camera, from the world to it; or instead of both
        fov_deg : float
            The horizontal field of view, with `center`, `eye` and `up`: what it looks at, from where, and
            which way the rows of the picture go.
        width_px, height_px : int
        """
        if len(args) + len(kwargs) == 4:
            return pinhole_rays(*args, **kwargs).view(Tensor)
        return look_at(*args, **kwargs).view(Tensor)

    def _current(self) -> Scene:
        if self._scene is None:
            firsts = np.cumsum([0] + [len(vertices) for vertices, _ in self._meshes])
            vertices = np.concatenate([np.zeros((0, 3), np.float32), *(v for v, _ in self._meshes)])
            faces = [f.astype(np.int64) + first for (_, f), first in zip(self._meshes, firsts, strict=False)]
            joined = np.concatenate([np.zeros((0, 3), np.int64), *faces])
            self._scene = Scene(vertices, joined, queue=self._queue, context=self._context)
        return self._scene

    def _described(self, hits: Any) -> dict[str, NDArray[Any]]:
        is_hit = hits.primitive != NO_HIT
        geometry = np.searchsorted(self._starts, hits.primitive, side="right") - 1
        geometry[~is_hit] = 0
        primitive = np.where(is_hit, hits.primitive - self._starts[geometry], NO_HIT)
        return {
            "t_hit": np.ascontiguousarray(hits.t),
            "geometry_ids": np.where(is_hit, geometry, NO_HIT).astype(np.uint32),
            "primitive_ids": primitive.astype(np.uint32),
            "primitive_uvs": np.stack([hits.u, hits.v], -1),
        }


def _as_numpy(array: Any) -> Any:
    return array.numpy() if hasattr(array, "numpy") else array


def _taken(rays: Any) -> NDArray[Any]:
    taken = on_host("rays", _as_numpy(rays))
    require(taken.ndim >= 2 and taken.shape[-1] == 6, "rays", taken, "(..., 6)")
    return taken
