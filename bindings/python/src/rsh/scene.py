"""Scene: rays against a mesh that may move."""

from typing import Any

import numpy as np
import pyopencl as cl
from numpy.typing import ArrayLike, NDArray

from rsh._arrays import Floats, is_on_device, queue_of
from rsh._call import WaitFor
from rsh._context import Context
from rsh._default import context_of, default
from rsh._hits import HIT, Hits, find_locations, record_hits
from rsh._mesh import Mesh
from rsh._rays import make_rays
from rsh._tracer import Traced, Tracer
from rsh.constants import ENGINE_DEFAULT, QUERY_ALL, QUERY_ANY, QUERY_COUNT


class Scene:
    """Triangles that rays are traced against. Hits equal brute force, bit for bit.

    Rays are arrays (n, 6): origin, direction; (n, 8), as `make_rays` and rsh_ray have them: origin,
    tmin, direction, tmax; or as a screen (h, w, 6 or 8), where neighbours are traced together. Of NumPy's
    arrays, the answer is NumPy's. Of C-contiguous float32 arrays on the device nothing is copied, and the
    answer stays there; its `events` tell when it is there, as of any array of pyopencl. So it is with
    `pyopencl.SVM` of an array in shared virtual memory, which must not be mapped meanwhile. Answers have the
    shape of the rays without its last number.

    Parameters
    ----------
    vertices : array_like or pyopencl.array.Array, (n, 3)
        In world units, as float32; on the device also (n, 4), of which the last is ignored.
    faces : array_like or pyopencl.array.Array, (m, 3), optional
        Three vertices each; without them any three vertices after each other are a triangle.
    queue : pyopencl.CommandQueue, optional
        Without it that of `vertices`, else one that the process has for it. Shared virtual memory needs it.
    context : Context, optional
        Shares its programs and memory with what else uses it.
    engine : int, optional
        `rsh.ENGINE_TILES` and the like.
    ranges : ndarray of numpy.dtype(rsh.structs.MeshRange), optional
        Which triangles are which mesh.
    still_faces : int, optional
        So many faces, the first ones, never move: `update` costs what the others cost, but for the copy of
        the vertices.

    Raises
    ------
    TypeError, ValueError
        An array is not of these shapes and types; there are fewer faces than that.
    NoDeviceError
        There is no OpenCL device.
    """

    def __init__(
        self,
        vertices: Floats,
        faces: Floats | None = None,
        *,
        queue: cl.CommandQueue | None = None,
        context: Context | None = None,
        engine: int = ENGINE_DEFAULT,
        ranges: NDArray[Any] | None = None,
        still_faces: int = 0,
    ) -> None:
        if queue is None and is_on_device(vertices):
            queue = queue_of(vertices)
        if queue is None and context is not None:
            queue = cl.CommandQueue(context.context, context.device)
        if queue is None:
            context, queue = default()
        self.queue, self.context = queue, context or context_of(queue)
        self._mesh = Mesh(self.context, queue, engine)
        self._mesh.set_vertices(vertices)
        self._mesh.set_faces(faces)
        self._mesh.set_still(still_faces)
        if ranges is not None:
            self._mesh.set_ranges(ranges)
        self._tracer = Tracer(self.context, queue, self._mesh, engine)

    def update(self, vertices: Floats) -> None:
        """Move the vertices; the next query refits the bounds, or makes them anew where that is better.

        Parameters
        ----------
        vertices : array_like or pyopencl.array.Array, (n, 3)
            As many as before, those of still faces where they were.
        """
        self._mesh.set_vertices(vertices)

    def closest(
        self, rays: Floats, *, normal: bool = False, location: bool = False, wait_for: WaitFor = None
    ) -> Any:
        """Find the closest hit of each ray.

        Parameters
        ----------
        rays : array_like or pyopencl.array.Array
        normal : bool, optional
            Also the unit normals of the triangles hit, (v1 - v0) x (v2 - v0); 0 for a miss.
        location : bool, optional
            Also where on the triangle it is, by `u` and `v`; NaN for a miss. Of NumPy's rays in double
            precision, on the device as float32.
        wait_for : iterable of pyopencl.Event, optional

        Returns
        -------
        recarray or pyopencl.array.Array
            `t` in units of the direction's length, `u`, `v`, `primitive`: index of the triangle, `rsh.NO_HIT`
            for a miss, whose t is inf (on the device: the ray's tmax); `normal` and `location`. On the device
            these are arrays of their own, (..., 3): with any, a tuple of hits, normals, locations.
        """
        traced = self._tracer.take(rays)
        hits = traced.empty(traced.shape, HIT)
        asked = self._asked(traced, traced.shape, rays, normal, location)
        traced.run(wait_for, hits=hits, **asked)
        if is_on_device(rays):
            return (hits, *asked.values()) if asked else hits
        return self._records(hits, asked.get("normals"), location)

    def closest_hits(
        self, origins: ArrayLike, directions: ArrayLike, *, normal: bool = False, location: bool = False
    ) -> Hits:
        """Find the closest hits of the rays of `make_rays`; a shorthand for `closest`."""
        hits: Hits = self.closest(make_rays(origins, directions), normal=normal, location=location)
        return hits

    def any(self, rays: Floats, *, wait_for: WaitFor = None) -> Any:
        """Tell whether each ray hits anything.

        Returns
        -------
        ndarray of bool, or pyopencl.array.Array of uint32, 0 or 1
        """
        traced = self._tracer.take(rays)
        mask = traced.empty(traced.shape, np.uint32).fill(0)
        traced.run(wait_for, query=QUERY_ANY, occlusion=mask)
        return mask if is_on_device(rays) else mask.get(self.queue).astype(bool)

    def count(self, rays: Floats, *, wait_for: WaitFor = None) -> Any:
        """Count the triangles that each ray crosses; see rsh_traverse for rays through edges.

        Returns
        -------
        ndarray or pyopencl.array.Array, uint32
        """
        traced = self._tracer.take(rays)
        counts = traced.empty(traced.shape, np.uint32)
        traced.run(wait_for, query=QUERY_COUNT, hit_counts=counts)
        return counts if is_on_device(rays) else counts.get(self.queue)

    def all(
        self, rays: Floats, *, normal: bool = False, location: bool = False, wait_for: WaitFor = None
    ) -> tuple[Any, Any]:
        """List all triangles that each ray crosses, by t. BLOCKS to learn how many there are.

        Parameters
        ----------
        rays, normal, location, wait_for
            As for `closest`.

        Returns
        -------
        hits : recarray or pyopencl.array.Array
            Ray by ray, as of `closest`; on the device with `normal` or `location` such a tuple.
        offsets : ndarray or pyopencl.array.Array, uint64, (rays + 1,)
            Ray i has hits[offsets[i]:offsets[i + 1]].
        """
        traced = self._tracer.take(rays)
        count = int(np.prod(traced.shape))
        offsets = traced.empty((count + 1,), np.uint64)
        if count == 0:
            offsets.fill(0)
        capacity, total = 0, max(2 * count, 1024)
        while total > capacity:
            capacity = total
            hits = traced.empty((capacity,), HIT)
            asked = self._asked(traced, (capacity,), rays, normal, location)
            lists = {"query": QUERY_ALL, "hit_offsets": offsets, "hit_capacity": capacity}
            traced.run(wait_for, hits=hits, **asked, **lists)
            total = int(offsets[count:].get(self.queue)[0])
        hits, asked = hits[:total], {name: array[:total] for name, array in asked.items()}
        if is_on_device(rays):
            return (hits, *asked.values()) if asked else hits, offsets
        return self._records(hits, asked.get("normals"), location), offsets.get(self.queue)

    def contains(self, points: Floats, *, wait_for: WaitFor = None) -> Any:
        """Tell which points are inside of the mesh, which must be closed.

        Parameters
        ----------
        points : array_like or pyopencl.array.Array, (n, 3)

        Returns
        -------
        ndarray of bool, or pyopencl.array.Array of uint32, 0 or 1
            By the parity of the triangles above each point; right unless it is nearer to the surface than
            t errs, see rsh_traverse.
        """
        traced = self._tracer.take_points(points)
        counts = traced.empty(traced.shape, np.uint32)
        traced.run(wait_for, query=QUERY_COUNT, hit_counts=counts)
        return counts & 1 if is_on_device(points) else counts.get(self.queue) % 2 == 1

    @staticmethod
    def _asked(
        traced: Traced, shape: tuple[int, ...], rays: Floats, normal: bool, location: bool
    ) -> dict[str, Any]:
        """Return arrays for what rsh_trace is to tell beside hits."""
        wanted = {"normals": normal, "points": location and is_on_device(rays)}
        return {name: traced.empty((*shape, 3), np.float32) for name in wanted if wanted[name]}

    def _records(self, hits: Any, normals: Any, location: bool) -> Hits:
        raw = hits.get(self.queue)
        found = find_locations(raw, *self._mesh.on_host()) if location else None
        return record_hits(raw, None if normals is None else normals.get(self.queue), found)
