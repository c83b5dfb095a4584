"""gltf_made.py - a glTF file with all that real ones seldom have together: steps, cubic splines and normalized
integers as keys, eight joints of a vertex, sparse accessors, matrices, a mirroring scale, morphed normals."""
import base64
import json

import numpy as np

VERTICES = 12
TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
COMPONENTS = {"int8": 5120, "uint8": 5121, "int16": 5122, "uint16": 5123, "uint32": 5125, "float32": 5126}


class Maker:
    def __init__(self):
        self.random = np.random.default_rng(1)
        self.bytes, self.views, self.accessors = b"", [], []

    def view(self, array):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": array.nbytes})
        self.bytes += array.tobytes()
        return len(self.views) - 1

    def accessor(self, rows, dtype="float32", normalized=False, **more):
        rows = np.ascontiguousarray(rows, dtype)
        rows = rows.reshape(len(rows), -1)
        entry = {"componentType": COMPONENTS[dtype], "count": len(rows), "type": TYPES[rows.shape[1]]}
        entry |= {"normalized": True} if normalized else {}
        self.accessors.append(entry | {"bufferView": self.view(rows)} | more)
        return len(self.accessors) - 1

    def sparse(self, count, places, rows):
        """Zeros but for some rows."""
        self.accessors.append({
            "componentType": 5126, "count": count, "type": "VEC3",
            "sparse": {"count": len(places),
                       "indices": {"bufferView": self.view(np.array(places, "uint16")), "componentType": 5123},
                       "values": {"bufferView": self.view(np.array(rows, "float32"))}}})
        return len(self.accessors) - 1

    def floats(self, *shape):
        return self.random.uniform(-1.0, 1.0, shape)

    def units(self, *shape):
        v = self.floats(*shape)
        return v / np.linalg.norm(v, axis=-1, keepdims=True)

    def mesh(self, joints):
        """A strip with two morph targets, and 4 or 8 joints for each vertex if it is to have any."""
        attributes = {"POSITION": self.accessor(self.floats(VERTICES, 3)),
                      "NORMAL": self.accessor(self.units(VERTICES, 3))}
        for i in range(joints // 4):
            attributes[f"JOINTS_{i}"] = self.accessor(
                self.random.integers(0, 3, (VERTICES, 4)), "uint8" if i == 0 else "uint16")
            attributes[f"WEIGHTS_{i}"] = (
                self.accessor(self.random.uniform(0.1, 1.0, (VERTICES, 4)) / (joints * 0.55)) if i == 0 else
                self.accessor(self.random.integers(1, 60, (VERTICES, 4)), "uint8", normalized=True))
        targets = [{"POSITION": self.accessor(self.floats(VERTICES, 3)),
                    "NORMAL": self.accessor(0.2 * self.floats(VERTICES, 3))},
                   {"POSITION": self.sparse(VERTICES, [2, 7], self.floats(2, 3))}]
        return {"primitives": [{"attributes": attributes, "mode": 5, "targets": targets}],
                "weights": [0.25, 0.5]}

    def channels(self, keys):
        """keys: (node, path, interpolation, accessor of the times, accessor of the values)"""
        return {"name": f"clip of {len(keys)}",
                "channels": [{"sampler": i, "target": {"node": k[0], "path": k[1]}} for i, k in enumerate(keys)],
                "samplers": [{"interpolation": k[2], "input": k[3], "output": k[4]} for k in keys]}


def make_file(path):
    m = Maker()
    times = m.accessor(np.array([0.5, 1.0, 1.75, 3.0]))
    few = m.accessor(np.array([0.0, 2.5]))
    meshes = [m.mesh(0), m.mesh(4), m.mesh(8)]
    matrix = np.eye(4)
    matrix[:3, :] += 0.3 * m.floats(3, 4)
    nodes = [
        {"children": [1, 2, 3], "translation": [0.5, -1.0, 2.0], "scale": [1.0, 1.5, 0.8]},
        {"mesh": 0},
        {"mesh": 1, "skin": 0, "translation": [100.0, 0.0, 0.0]},
        {"matrix": matrix.T.flatten().tolist(), "children": [4, 5]},
        {"mesh": 2, "skin": 0},
        {"rotation": m.units(4).tolist(), "scale": [-1.0, 0.7, 1.1], "children": [6]},
        {"translation": [0.3, 0.2, 0.1], "mesh": 0},
    ]
    binds = np.tile(np.eye(4), (3, 1, 1)) + 0.2 * m.floats(3, 4, 4) * (np.arange(4) < 3)[:, None]
    skin = {"joints": [5, 6, 0], "inverseBindMatrices": m.accessor(binds.transpose(0, 2, 1).reshape(3, 16))}
    quaternions = m.accessor(np.round(m.units(4, 4) * 32767), "int16", normalized=True)
    animations = [
        m.channels([(0, "rotation", "LINEAR", times, quaternions),
                    (5, "translation", "STEP", times, m.accessor(m.floats(4, 3))),
                    (6, "scale", "LINEAR", few, m.accessor(1.5 + m.floats(2, 3))),
                    (1, "weights", "LINEAR", times, m.accessor(m.floats(8)))]),
        m.channels([(6, "rotation", "CUBICSPLINE", few, m.accessor(m.units(6, 4))),
                    (0, "translation", "CUBICSPLINE", times, m.accessor(m.floats(12, 3))),
                    (2, "weights", "CUBICSPLINE", few, m.accessor(m.floats(12)))]),
    ]
    uri = "data:application/octet-stream;base64," + base64.b64encode(m.bytes).decode()
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes, "meshes": meshes,
        "skins": [skin], "animations": animations, "accessors": m.accessors, "bufferViews": m.views,
        "buffers": [{"byteLength": len(m.bytes), "uri": uri}]}))
    return path
