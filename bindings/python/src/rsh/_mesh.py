"""The triangles of a scene on the device, with bounds that follow them."""

from threading import Lock
from typing import Any

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
from numpy.typing import NDArray
from pyopencl.tools import ImmediateAllocator, MemoryPool

from rsh._arrays import Floats, is_on_device, on_device, on_host, require
from rsh._context import Context
from rsh._memory import place_of
from rsh.calls import bound, bound_query, default_engine, engine_shape
from rsh.constants import BOUND_QUALITY, BOUND_REFIT, ENGINE_BRUTE_FORCE, ENGINE_DEFAULT
from rsh.structs import Geometry, MeshRange


class Mesh:
    """Vertices, faces and bounds; the bounds are made when they are first asked for."""

    def __init__(self, context: Context, queue: cl.CommandQueue, engine: int) -> None:
        self._context, self._queue, self._lock = context, queue, Lock()
        self._pool = MemoryPool(ImmediateAllocator(queue))
        self._engine = default_engine(context) if engine == ENGINE_DEFAULT else engine
        self.geometry = Geometry()
        self._bounded: cl.Event | None = None
        self._bounds: cl.Buffer | None = None
        self._are_bounds_old = True
        self._vertices: cla.Array | None = None
        self._faces: cla.Array | None = None
        self._ranges: cla.Array | None = None
        self._host: tuple[NDArray[Any], NDArray[Any]] | None = None

    def set_faces(self, faces: Floats | None) -> None:
        """Take the faces, or without any three vertices after each other for each."""
        assert self._vertices is not None
        if faces is None:
            count = self._vertices.shape[0] // 3
            require(self._vertices.shape[0] % 3 == 0, "vertices", self._vertices, "(3 n, 3) without faces")
        else:
            self._faces = self._taken("faces", faces, [np.uint32, np.int32], (3,))
            count = self._faces.shape[0]
            self.geometry.indices, self.geometry.indices_offset = place_of(self._faces)
        self.geometry.triangle_count = count

    def set_still(self, faces: int) -> None:
        """Take how many faces, the first ones, stand still."""
        count = self.geometry.triangle_count
        if not 0 <= faces <= count:
            raise ValueError(f"still_faces is {faces}, must be 0 .. {count}, the number of faces")
        self.geometry.still_triangles = faces

    def set_vertices(self, vertices: Floats) -> None:
        """Take vertices, of arrays on the device without a copy."""
        taken = self._taken("vertices", vertices, [np.float32], (3, 4))
        count = self._vertices.shape[0] if self._vertices is not None else taken.shape[0]
        require(taken.shape[0] == count, "vertices", taken, f"({count}, 3) as before")
        with self._lock:
            self._vertices, self._host, self._are_bounds_old = taken, None, True
            self.geometry.vertices, self.geometry.vertices_offset = place_of(taken)
            self.geometry.vertex_stride = 4 * taken.shape[1]
            self.geometry.vertex_count = count

    def set_ranges(self, ranges: NDArray[Any]) -> None:
        """Take which triangles are which mesh."""
        if ranges.dtype != np.dtype(MeshRange):
            raise TypeError(f"ranges has dtype {ranges.dtype}, must be numpy.dtype(rsh.structs.MeshRange)")
        self._ranges = cla.to_device(self._queue, np.ascontiguousarray(ranges))
        self.geometry.ranges, self.geometry.range_count = self._ranges, len(ranges)

    def _taken(self, name: str, array: Any, dtypes: list[type[Any]], widths: tuple[int, ...]) -> cla.Array:
        is_there = is_on_device(array)
        taken: Any = (
            on_device(name, array, self._queue, dtypes) if is_there else on_host(name, array, dtypes[0])
        )
        allowed = " or ".join(f"(n, {width})" for width in widths)
        require(taken.ndim == 2 and taken.shape[1] in widths, name, taken, allowed)
        if is_there:
            return taken  # type: ignore[no-any-return]
        return cla.to_device(self._queue, taken, allocator=self._pool)

    def bounds(self) -> cl.Buffer | None:
        """Return bounds of the triangles as they are now; brute force needs none."""
        if self._engine == ENGINE_BRUTE_FORCE or self.geometry.triangle_count == 0:
            return None
        with self._lock:
            if self._are_bounds_old:
                self._bound()
            return self._bounds

    def _bound(self) -> None:
        desc: dict[str, Any] = {"geometry": self.geometry, "shape": engine_shape(self._engine)}
        desc["mode"] = BOUND_QUALITY if self._bounds is None else BOUND_REFIT
        if self._bounds is None:
            size = bound_query(self._context, **desc).output_bytes
            self._bounds = cl.Buffer(self._context.context, cl.mem_flags.READ_WRITE, size)
        self._bounded = bound(self._context, self._queue, **desc, bounds=self._bounds, wait_for=self.events())
        self._are_bounds_old = False

    def events(self) -> list[cl.Event]:
        """Return what a call has to wait for."""
        arrays = [array for array in (self._vertices, self._faces, self._ranges) if array is not None]
        own = [] if self._bounded is None else [self._bounded]
        return own + [event for array in arrays for event in array.events]

    def on_host(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return vertices (n, 3) and faces (m, 3) as NumPy's; the device is asked once."""
        assert self._vertices is not None
        if self._host is None:
            count = self.geometry.triangle_count
            faces = np.arange(3 * count).reshape(-1, 3)
            if self._faces is not None:
                faces = self._faces.get(self._queue)
            self._host = self._vertices.get(self._queue)[:, :3], faces
        return self._host
