"""Who traces a moving mesh: `frame(vertices)` takes new ones and returns t and triangle of each ray.

All arrays are NumPy's, float32 and uint32, before and after; each contender has its rays as it takes them.
"""

from typing import Any

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore import EmbreeDevice
from embreex.rtcore_scene import EmbreeScene
from numpy.typing import NDArray

import rsh
from rsh._default import default
from rsh._hits import HIT

Answer = tuple[NDArray[np.float32], NDArray[np.uint32]]


class Refitted:
    """rsh.Scene: bounds are made once, then refitted, or made anew where refitting has degraded them."""

    def __init__(self, vertices: Any, faces: Any, rays: Any) -> None:
        self._scene, self._rays = rsh.Scene(vertices, faces), rays

    def frame(self, vertices: Any) -> Answer:
        self._scene.update(vertices)
        hits = self._scene.closest(self._rays)
        return hits.t.ravel(), hits.primitive.ravel()


class Rebuilt:
    """rsh.bound with BOUND_FAST in each frame, as if it had nothing to do with the one before."""

    def __init__(self, vertices: Any, faces: Any, rays: Any) -> None:
        self._context, self._queue = default()
        self._rays, self._faces = rays, cla.to_device(self._queue, faces)
        self._scene: dict[str, Any] = {"mode": rsh.BOUND_FAST, "shape": rsh.engine_shape(rsh.ENGINE_TILES)}
        self._scene["geometry"] = rsh.structs.Geometry(
            vertices=cla.to_device(self._queue, vertices),
            vertex_count=len(vertices),
            indices=self._faces,
            triangle_count=len(faces),
        )
        size = rsh.bound_query(self._context, **self._scene).output_bytes
        self._bounds = cl.Buffer(self._context.context, cl.mem_flags.READ_WRITE, size)
        self._hits = cla.empty(self._queue, rays.shape[:-1], HIT)

    def frame(self, vertices: Any) -> Answer:
        context, queue = self._context, self._queue
        self._scene["geometry"].vertices = cla.to_device(queue, vertices)
        rsh.bound(context, queue, **self._scene, bounds=self._bounds)
        floats, shape = cla.to_device(queue, self._rays), self._rays.shape[:-1]
        rays = {
            "origins": rsh.structs.RayFloats(buffer=floats, offset=0, stride=24),
            "directions": rsh.structs.RayFloats(buffer=floats, offset=12, stride=24),
            "width": shape[-1],
            "height": shape[0] if len(shape) > 1 else 0,
        }
        scene = {"geometry": self._scene["geometry"], "bounds": self._bounds, "engine": rsh.ENGINE_TILES}
        rsh.trace(context, queue, **scene, **rays, hits=self._hits)
        hits = self._hits.get(queue)
        return hits["t"].ravel(), hits["primitive"].ravel()


class Embreex:
    """A new scene in each frame, as embreex has nothing else; one thread traces, all build."""

    def __init__(self, faces: Any, rays: Any, *, robust: bool) -> None:
        self._device, self._faces, self._robust = EmbreeDevice(), faces, robust
        flat = rays.reshape(-1, 6)
        self._origins, self._directions = (np.ascontiguousarray(flat[:, k : k + 3]) for k in (0, 3))

    def frame(self, vertices: Any) -> Answer:
        scene = EmbreeScene(self._device, robust=self._robust)
        TriangleMesh(scene, vertices, self._faces)
        hits = scene.run(self._origins, self._directions, output=True)
        return hits["tfar"], hits["primID"].view(np.uint32)
