"""What trimesh asks of a ray object, answered by rsh: mesh.ray = RayMeshIntersector(mesh)."""

from typing import Any

import numpy as np
import pyopencl as cl
from numpy.typing import ArrayLike, NDArray

from rsh._context import Context
from rsh._rays import make_rays
from rsh.constants import NO_HIT
from rsh.scene import Scene


class RayMeshIntersector:
    """Rays against a trimesh.Trimesh, also while it changes: vertices that move are refitted.

    Mesh and rays are moved to the mesh's centre and scaled in double precision before they become floats,
    and locations are where rays meet the planes of triangles, in double precision.

    Parameters
    ----------
    geometry : trimesh.Trimesh
        Whatever has `vertices` and `faces`, and a hash that tells whether they have changed.
    scale_to_box : bool, optional
        Also scale the mesh to the size of 1.
    queue, context
        As of `Scene`.
    """

    def __init__(
        self,
        geometry: Any,
        scale_to_box: bool = True,
        *,
        queue: cl.CommandQueue | None = None,
        context: Context | None = None,
    ) -> None:
        self.mesh = geometry
        self._is_scaled, self._queue, self._context = scale_to_box, queue, context
        self._scene: Scene | None = None
        self._hash: int | None = None
        self._faces = self._triangles = np.zeros(0)
        self._centre, self._scale = np.zeros(3), 1.0

    def __getstate__(self) -> dict[str, Any]:
        """Leave out what belongs to the device."""
        return {"mesh": self.mesh, "scale_to_box": self._is_scaled}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Begin anew."""
        self.__init__(state["mesh"], state["scale_to_box"])  # type: ignore[misc]

    def __deepcopy__(self, _memo: object) -> "RayMeshIntersector":
        """Return another one of the same mesh, as trimesh does."""
        return self.__copy__()

    def __copy__(self) -> "RayMeshIntersector":
        """Return another one of the same mesh."""
        return RayMeshIntersector(self.mesh, self._is_scaled, queue=self._queue, context=self._context)

    def intersects_location(
        self, ray_origins: ArrayLike, ray_directions: ArrayLike, multiple_hits: bool = True
    ) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
        """Find where rays hit.

        Parameters
        ----------
        ray_origins, ray_directions : array_like, (n, 3)
        multiple_hits : bool, optional
            All hits of each ray, by distance; else only its closest one.

        Returns
        -------
        locations : ndarray, (m, 3), float64
        index_ray, index_tri : ndarray, (m,), int64
            Which ray hits which of mesh.faces there.
        """
        index_tri, index_ray, locations = self.intersects_id(
            ray_origins, ray_directions, multiple_hits, return_locations=True
        )
        return locations, index_ray, index_tri

    def intersects_id(
        self,
        ray_origins: ArrayLike,
        ray_directions: ArrayLike,
        multiple_hits: bool = True,
        max_hits: int = 2**31,
        return_locations: bool = False,
    ) -> Any:
        """Find which triangles rays hit.

        Parameters
        ----------
        ray_origins, ray_directions, multiple_hits
            As of `intersects_location`.
        max_hits : int, optional
            Of each ray, the closest ones.
        return_locations : bool, optional

        Returns
        -------
        index_tri, index_ray : ndarray, (m,), int64
        locations : ndarray, (m, 3), float64
            Only with `return_locations`.
        """
        origins, directions, scene, rays = self._prepared(ray_origins, ray_directions)
        if multiple_hits:
            hits, offsets = scene.all(rays)
            counts = np.diff(offsets).astype(np.int64)
            index_ray = np.repeat(np.arange(len(rays)), counts)
            is_kept = np.arange(len(hits)) - np.repeat(offsets[:-1].astype(np.int64), counts) < max_hits
            index_tri, index_ray = hits.primitive[is_kept].astype(np.int64), index_ray[is_kept]
        else:
            primitive = scene.closest(rays).primitive
            index_ray = np.flatnonzero(primitive != NO_HIT)
            index_tri = primitive[index_ray].astype(np.int64)
        if not return_locations:
            return index_tri, index_ray
        return index_tri, index_ray, self._locations(origins[index_ray], directions[index_ray], index_tri)

    def intersects_first(self, ray_origins: ArrayLike, ray_directions: ArrayLike) -> NDArray[np.int64]:
        """Return the triangle that each ray hits first, (n,), or -1."""
        _, _, scene, rays = self._prepared(ray_origins, ray_directions)
        primitive = scene.closest(rays).primitive
        return np.where(primitive == NO_HIT, -1, primitive.astype(np.int64))

    def intersects_any(self, ray_origins: ArrayLike, ray_directions: ArrayLike) -> NDArray[np.bool_]:
        """Tell whether each ray hits the mesh, (n,)."""
        _, _, scene, rays = self._prepared(ray_origins, ray_directions)
        is_hit: NDArray[np.bool_] = scene.any(rays)
        return is_hit

    def contains_points(self, points: ArrayLike) -> NDArray[np.bool_]:
        """Tell which points, (n, 3), are inside of the mesh, which must be closed."""
        scene, taken = self._current(), _rows("points", points)
        is_inside: NDArray[np.bool_] = scene.contains(self._moved(taken))
        return is_inside

    def _prepared(self, origins: ArrayLike, directions: ArrayLike) -> tuple[Any, Any, Scene, Any]:
        taken, given = _rows("ray_origins", origins), _rows("ray_directions", directions)
        if taken.shape != given.shape:
            raise ValueError(f"ray_directions has shape {given.shape}, must be {taken.shape} as ray_origins")
        length = np.linalg.norm(given, axis=1, keepdims=True)
        unit = np.divide(given, length, out=np.zeros_like(given), where=length > 0)
        scene = self._current()
        return taken, unit, scene, make_rays(self._moved(taken), unit)

    def _current(self) -> Scene:
        """Return the scene of the mesh as it is now."""
        changed = hash(self.mesh)
        if self._scene is not None and changed == self._hash:
            return self._scene
        vertices, faces = np.array(self.mesh.vertices, np.float64), np.array(self.mesh.faces)
        low, high = (vertices.min(0), vertices.max(0)) if len(vertices) else (np.zeros(3), np.ones(3))
        extent = float(np.max(high - low))
        self._centre, self._scale = (low + high) / 2, 1 / extent if self._is_scaled and extent > 0 else 1.0
        self._triangles = vertices[faces]
        if self._scene is not None and np.array_equal(faces, self._faces):
            self._scene.update(self._moved(vertices))
        else:
            moved = self._moved(vertices)
            self._scene = Scene(moved, faces, queue=self._queue, context=self._context)
        self._faces, self._hash = faces, changed
        return self._scene

    def _moved(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        return (points - self._centre) * self._scale

    def _locations(self, origins: Any, directions: Any, index_tri: Any) -> NDArray[np.float64]:
        """Where rays meet the planes of triangles."""
        triangles = self._triangles[index_tri]
        first = triangles[:, 0]
        normals = np.cross(triangles[:, 1] - first, triangles[:, 2] - first)
        t = np.sum((first - origins) * normals, axis=1) / np.sum(directions * normals, axis=1)
        locations: NDArray[np.float64] = origins + t[:, None] * directions
        return locations


def _rows(name: str, value: ArrayLike) -> NDArray[np.float64]:
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has dtype {array.dtype}, must be real numbers")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has shape {array.shape}, must be (n, 3)")
    return array.astype(np.float64)
