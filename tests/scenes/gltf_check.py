#!/usr/bin/env python3
"""gltf_check.py PROGRAM FILE... - glTF files in motion against an evaluation of their own, with pygltflib and
NumPy: PROGRAM (rsh_gltf_vertices) writes the vertices of every clip of every FILE at five times, and of a file
that is made here; positions must be within 1e-5 of the model's size, unit normals within 1e-5.

Written from the specification of glTF 2.0 in double precision; shares no code with samples/render/import/gltf."""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pygltflib

from gltf_made import make_file

TIMES = 5
TOLERANCE = 1e-5
COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Document:
    """A file with the bytes of its buffers."""

    def __init__(self, path):
        self.gltf = pygltflib.GLTF2().load(str(path))
        self.gltf.convert_buffers(pygltflib.BufferFormat.BINARYBLOB)
        self.bytes = self.gltf.binary_blob()

    def packed(self, view, offset, dtype, width, count, is_strided=True):
        view = self.gltf.bufferViews[view]
        dtype = np.dtype(dtype)
        stride = (view.byteStride if is_strided else None) or dtype.itemsize * width
        start = (view.byteOffset or 0) + (offset or 0)
        return np.ndarray((count, width), dtype, self.bytes, start, (stride, dtype.itemsize)).copy()

    def numbers(self, index):
        """The elements of an accessor, one per row."""
        a = self.gltf.accessors[index]
        dtype, width = COMPONENTS[a.componentType], WIDTHS[a.type]
        if a.bufferView is None:
            rows = np.zeros((a.count, width), dtype)
        else:
            rows = self.packed(a.bufferView, a.byteOffset, dtype, width, a.count)
        if a.sparse:
            at = self.packed(a.sparse.indices.bufferView, a.sparse.indices.byteOffset,
                             COMPONENTS[a.sparse.indices.componentType], 1, a.sparse.count, False)
            rows[at[:, 0]] = self.packed(a.sparse.values.bufferView, a.sparse.values.byteOffset, dtype, width,
                                         a.sparse.count, False)
        if a.normalized and rows.dtype.kind in "iu":
            return np.maximum(rows / float(np.iinfo(rows.dtype).max), -1.0)
        return rows.astype(np.float64) if rows.dtype.kind == "f" else rows


def slerp(a, b, u):
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    cosine = float(np.dot(a, b))
    if cosine < 0.0:
        b, cosine = -b, -cosine
    angle = math.acos(min(cosine, 1.0))
    if angle < 1e-9:
        return a + u * (b - a)
    return (math.sin((1.0 - u) * angle) * a + math.sin(u * angle) * b) / math.sin(angle)


def hermite(low, out_tangent, in_tangent, high, seconds, u):
    return ((2 * u**3 - 3 * u**2 + 1) * low + seconds * (u**3 - 2 * u**2 + u) * out_tangent
            + (-2 * u**3 + 3 * u**2) * high + seconds * (u**3 - u**2) * in_tangent)


def sampled(document, sampler, path, time):
    times = document.numbers(sampler.input)[:, 0]
    values = document.numbers(sampler.output)
    is_cubic = sampler.interpolation == "CUBICSPLINE"
    if path == "weights":
        values = values.reshape(len(times) * (3 if is_cubic else 1), -1)
    keys = values.reshape(len(times), 3, -1) if is_cubic else values
    time = min(max(time, times[0]), times[-1])
    low = max(i for i in range(len(times)) if times[i] <= time)
    high = min(low + 1, len(times) - 1)
    seconds = times[high] - times[low]
    u = (time - times[low]) / seconds if seconds > 0.0 else 0.0
    if is_cubic:
        value = hermite(keys[low, 1], keys[low, 2], keys[high, 0], keys[high, 1], seconds, u)
    elif sampler.interpolation == "STEP":
        value = keys[low]
    elif path == "rotation":
        value = slerp(keys[low], keys[high], u)
    else:
        value = (1.0 - u) * keys[low] + u * keys[high]
    return value / np.linalg.norm(value) if path == "rotation" else value


def trs(translation, rotation, scale):
    x, y, z, w = rotation
    matrix = np.eye(4)
    matrix[:3, :3] = np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]) * np.array(scale)
    matrix[:3, 3] = translation
    return matrix


class Moment:
    """The nodes of a document at one time of one clip."""

    def __init__(self, document, clip, time):
        self.document, self.nodes = document, document.gltf.nodes
        self.moved = {}
        for channel in clip.channels if clip else ():
            sampler = clip.samplers[channel.sampler]
            self.moved[channel.target.node, channel.target.path] = sampled(
                document, sampler, channel.target.path, time)
        self.parents = {child: i for i, node in enumerate(self.nodes) for child in node.children or ()}

    def member(self, node, path, otherwise):
        own = getattr(self.nodes[node], path)
        return self.moved.get((node, path), otherwise if own is None else np.array(own, np.float64))

    def matrix(self, node):
        if self.nodes[node].matrix is not None:
            own = np.array(self.nodes[node].matrix, np.float64).reshape(4, 4).T
        else:
            own = trs(self.member(node, "translation", np.zeros(3)),
                      self.member(node, "rotation", np.array([0.0, 0.0, 0.0, 1.0])),
                      self.member(node, "scale", np.ones(3)))
        return self.matrix(self.parents[node]) @ own if node in self.parents else own

    def weights(self, node, count):
        # pygltflib 1.16 knows no weights of nodes; no file here has any.
        own = self.document.gltf.meshes[self.nodes[node].mesh].weights
        return self.moved.get((node, "weights"), np.array(own or [0.0] * count, np.float64))

    def joints(self, skin):
        binds = (self.document.numbers(skin.inverseBindMatrices).reshape(-1, 4, 4).transpose(0, 2, 1)
                 if skin.inverseBindMatrices is not None else [np.eye(4)] * len(skin.joints))
        return np.array([self.matrix(joint) @ bind for joint, bind in zip(skin.joints, binds)])


def morphed(document, primitive, name, weights):
    index = getattr(primitive.attributes, name)
    if index is None:
        return None
    rows = document.numbers(index)
    for target, weight in zip(primitive.targets or (), weights):
        added = target.get(name) if isinstance(target, dict) else getattr(target, name)
        if added is not None:
            rows = rows + weight * document.numbers(added)
    return rows


def vertex_matrices(moment, node, primitive, count):
    skin = moment.nodes[node].skin
    if skin is None or primitive.attributes.JOINTS_0 is None:
        return np.broadcast_to(moment.matrix(node), (count, 4, 4))
    names = ["0"] + (["1"] if getattr(primitive.attributes, "JOINTS_1", None) is not None else [])
    numbers = moment.document.numbers
    joints = np.hstack([numbers(getattr(primitive.attributes, "JOINTS_" + i)) for i in names])
    weights = np.hstack([numbers(getattr(primitive.attributes, "WEIGHTS_" + i)) for i in names])
    weights = weights / weights.sum(axis=1, keepdims=True)
    return np.einsum("vj,vjab->vab", weights, moment.joints(moment.document.gltf.skins[skin])[joints])


def nodes_of_scene(gltf):
    found, wanted = set(), list(gltf.scenes[gltf.scene or 0].nodes)
    while wanted:
        node = wanted.pop()
        found.add(node)
        wanted += gltf.nodes[node].children or []
    return sorted(found)


def evaluate(document, clip, time):
    """Positions and normals of all vertices: nodes in their order, primitives in that of the mesh."""
    moment = Moment(document, clip, time)
    positions, normals = [], []
    for node in nodes_of_scene(document.gltf):
        if document.gltf.nodes[node].mesh is None:
            continue
        for primitive in document.gltf.meshes[document.gltf.nodes[node].mesh].primitives:
            weights = moment.weights(node, len(primitive.targets or ()))
            p = morphed(document, primitive, "POSITION", weights)
            n = morphed(document, primitive, "NORMAL", weights)
            matrices = vertex_matrices(moment, node, primitive, len(p))
            positions.append(np.einsum("vab,vb->va", matrices, np.hstack([p, np.ones((len(p), 1))]))[:, :3])
            if n is None:
                normals.append(np.zeros_like(p))
                continue
            n = np.einsum("vba,vb->va", np.linalg.inv(matrices[:, :3, :3]), n)
            normals.append(n / np.linalg.norm(n, axis=1, keepdims=True))
    return np.vstack(positions), np.vstack(normals)


def dumped(program, path, clip, times, folder):
    out = Path(folder) / "vertices"
    subprocess.run([program, path, clip, out, *map(repr, times)], check=True)
    return np.fromfile(out, "<f4").reshape(len(times), -1, 3).astype(np.float64)


def check_clip(program, path, document, clip, folder):
    keys = np.concatenate([document.numbers(s.input)[:, 0] for s in clip.samplers])
    # Neither the first nor the last key is of any help to who forgets to interpolate.
    times = [float(keys.min() + (keys.max() - keys.min()) * (i + 0.37) / TIMES) for i in range(TIMES)]
    rows = dumped(program, path, clip.name or str(document.gltf.animations.index(clip)), times, folder)
    worst = worst_normal = 0.0
    for i, time in enumerate(times):
        positions, normals = evaluate(document, clip, time)
        has_normals = rows.shape[1] == 2 * len(positions)
        if not has_normals and rows.shape[1] != len(positions):
            raise SystemExit(f"{path}: {rows.shape[1]} rows of vertices, must be {len(positions)} or twice that")
        size = np.linalg.norm(positions.max(axis=0) - positions.min(axis=0))
        worst = max(worst, np.abs(rows[i, :len(positions)] - positions).max() / size)
        if has_normals:
            worst_normal = max(worst_normal, np.abs(rows[i, len(positions):] - normals).max())
    is_good = worst <= TOLERANCE and worst_normal <= TOLERANCE
    print(f"{'passed' if is_good else 'FAILED'} {path}: {clip.name}: {len(positions)} vertices at {TIMES} times, "
          f"off by at most {worst:.2g} of the size, normals by {worst_normal:.2g}")
    return is_good


def main():
    program, *paths = sys.argv[1:]
    is_good = True
    with tempfile.TemporaryDirectory() as folder:
        for path in [make_file(Path(folder) / "made.gltf"), *paths]:
            document = Document(path)
            for clip in document.gltf.animations:
                is_good = check_clip(program, path, document, clip, folder) and is_good
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
