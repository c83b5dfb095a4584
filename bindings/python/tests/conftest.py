"""A context and a queue for all tests, and meshes with rays."""

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
import pytest

import rsh
from rsh.structs import Hit, Ray


@pytest.fixture(scope="session")
def context():
    return rsh.Context()


@pytest.fixture(scope="session")
def queue(context):
    return cl.CommandQueue(context.context)


class Mesh:
    """Triangles and rays on host and device; as they come, the rays are no neighbours."""

    def __init__(self, queue, vertices, faces, rays):
        self.vertices, self.faces, self.rays = vertices, faces, rays
        self.device_vertices = cla.to_device(queue, vertices)
        self.device_faces = cla.to_device(queue, faces)
        self.device_rays = cla.to_device(queue, rays)
        self.geometry = rsh.structs.Geometry(
            vertices=self.device_vertices,
            vertex_count=len(vertices),
            indices=self.device_faces,
            triangle_count=len(faces),
        )


@pytest.fixture(scope="session")
def mesh(queue):
    random = np.random.default_rng(7)
    vertices = random.uniform(-1, 1, (300, 3)).astype(np.float32)
    faces = random.integers(0, 300, (200, 3)).astype(np.uint32)
    rays = np.zeros(500, np.dtype(Ray))
    origins, targets = random.uniform(-2, 2, (500, 3)), random.uniform(-1, 1, (500, 3))
    rays["origin_tmin"][:, :3] = origins
    rays["direction_tmax"][:, :3] = targets - origins
    rays["direction_tmax"][:, 3] = np.inf
    return Mesh(queue, vertices, faces, rays)


def crossings(vertices, faces, origins, directions):
    """t of each (ray, triangle) by Moeller and Trumbore in double precision, and how far inside the
    crossing is: the least barycentric coordinate. inf and -inf where the two are parallel."""
    corner, edge1, edge2 = (a.astype(np.float64) for a in corners(vertices, faces))
    origins, directions = origins.astype(np.float64)[:, None], directions.astype(np.float64)[:, None]
    normal = np.cross(directions, edge2)
    with np.errstate(all="ignore"):
        scale = 1 / np.sum(edge1 * normal, axis=-1)
        offset = origins - corner
        u = np.sum(offset * normal, axis=-1) * scale
        other = np.cross(offset, edge1)
        v = np.sum(directions * other, axis=-1) * scale
        t = np.sum(edge2 * other, axis=-1) * scale
    depth = np.minimum(np.minimum(u, v), 1 - u - v)
    valid = np.isfinite(scale)
    return np.where(valid, t, np.inf), np.where(valid, depth, -np.inf)


def corners(vertices, faces):
    first, second, third = (vertices[faces[:, k]] for k in range(3))
    return first, second - first, third - first


def trace(context, queue, mesh, *, engine=0, **desc):
    """bound, build and traverse; desc: what traverse gets beside the mesh. Returns the last event."""
    shape = rsh.engine_shape(engine)
    n = len(mesh.rays)
    scene = {"geometry": mesh.geometry, "shape": shape}
    bounds = allocate(context, rsh.bound_query(context, **scene).output_bytes)
    rsh.bound(context, queue, **scene, bounds=bounds)
    rays = {"rays": mesh.device_rays, "width": n, "shape": shape}
    nodes = allocate(context, rsh.build_query(context, **rays).output_bytes)
    rsh.build(context, queue, **rays, nodes=nodes)
    return rsh.traverse(
        context,
        queue,
        **scene,
        engine=engine,
        bounds=bounds,
        rays=mesh.device_rays,
        nodes=nodes,
        width=n,
        **desc,
    )


def closest(context, queue, mesh, **desc):
    hits = cla.zeros(queue, len(mesh.rays), np.dtype(Hit))
    trace(context, queue, mesh, hits=hits, **desc).wait()
    return hits.get(queue)


def allocate(context, size):
    return cl.Buffer(context.context, cl.mem_flags.READ_WRITE, size)
