"""aff_scene.py - AFF files at a time: what they draw as triangles in the world, their camera and lights.
Written from the grammar of the format, in double precision; shares no code with samples/render/import/bart."""
import re
from pathlib import Path

import numpy as np

from aff_spline import Curve, matrix_of, rotation_about

SPHERE_TRIANGLES, CONE_TRIANGLES = 576, 48  # as samples/render tessellates: 24 sides


class Words:
    """The words of a file and of those that it includes."""

    def __init__(self, path):
        self.files = []
        self.open(Path(path))

    def open(self, path):
        text = re.sub(r"[#%][^\n]*", "", path.read_bytes().decode("latin-1"))
        self.files.append((path, iter(re.findall(r"[{}]|[^\s{}]+", text))))
        self.ahead = None

    def include(self, name):
        path = self.files[-1][0].parent / name
        if path.exists():
            self.open(path)

    def next(self):
        if self.ahead is not None:
            word, self.ahead = self.ahead, None
            return word
        while self.files:
            word = next(self.files[-1][1], None)
            if word is not None:
                return word
            self.files.pop()
        return None

    def peek(self):
        self.ahead = self.next()
        return self.ahead

    def numbers(self, count):
        return np.array([float(self.next()) for _ in range(count)])

    def rows(self, width):
        """A count, and so many rows."""
        return np.array([self.numbers(width) for _ in range(int(self.next()))]).reshape(-1, width)


def affine(linear, translation=(0.0, 0.0, 0.0)):
    matrix = np.eye(4)
    matrix[:3, :3] = linear
    matrix[:3, 3] = translation
    return matrix


class Track:
    def __init__(self):
        self.curves, self.visibility = {}, []

    def matrix(self, time):
        at = {kind: curve.rotation(time) if kind == "rot" else curve.point(time)
              for kind, curve in self.curves.items()}
        linear = matrix_of(at["rot"]) if "rot" in at else np.eye(3)
        return affine(linear * at.get("scale", np.ones(3)), at.get("transl", np.zeros(3)))

    def is_visible(self, time):
        shown = [is_visible for when, is_visible in self.visibility if when <= time]
        return bool(shown[-1]) if shown else True


class Scene:
    def __init__(self, path):
        self.words, self.level, self.node = Words(path), 0.0, 0
        self.nodes, self.open = [(0, np.eye(4))], []  # (parent, matrix or name)
        self.tracks, self.lights, self.camera = {}, [], {}
        # In the order of the file: (kind, node, what), triangles with corners and normals [n][2][3][3].
        self.things = []
        self.start = self.end = 0.0
        while (word := self.words.next()) is not None:
            self.command(word)

    def command(self, word):
        w = self.words
        skipped = {"b": 3, "am": 3, "f": 8, "fm": 12}
        if word in skipped:
            w.numbers(skipped[word])
        elif word == "v":
            while w.peek() in ("from", "at", "up", "angle", "hither", "resolution"):
                name = w.next()
                self.camera[name] = w.numbers({"angle": 1, "hither": 1, "resolution": 2}.get(name, 3))
        elif word in ("l", "la"):
            self.light(w.next() if word == "la" else None)
        elif word in ("p", "pp"):
            corners = w.rows(3 if word == "p" else 6)
            self.polygon(corners[:, :3], corners[:, 3:])
        elif word in ("tt", "ttp"):
            w.next()
            rows = np.array([w.numbers(5 if word == "tt" else 8) for _ in range(3)])
            self.polygon(rows[:, :3], rows[:, 3:-2])
        elif word == "tpa":
            rows = w.rows(19)
            self.things.append(("morph", self.node, (rows[:, 0], rows[:, 1:].reshape(-1, 3, 2, 3))))
        elif word == "s":
            self.things.append(("sphere", self.node, w.numbers(4)))
        elif word == "c":
            self.things.append(("cone", self.node, w.numbers(8)))
        elif word == "m":
            self.mesh()
        elif word == "xs":
            n = w.numbers(10)
            self.begin(affine(matrix_of(rotation_about(n[3:6], n[6])) * n[:3], n[7:]))
        elif word == "x":
            self.begin(w.next())
        elif word == "}":
            self.node = self.open.pop()
        elif word == "k":
            self.keys()
        elif word == "a":
            self.start, self.end, _ = w.numbers(3)
        elif word == "i":
            level, name = w.numbers(1)[0], w.next()
            if level <= self.level:
                w.include(name)
        elif word == "d":
            self.level = w.numbers(1)[0]
        else:
            raise SystemExit(f"unknown command {word}")

    def light(self, name):
        position, colour = self.words.numbers(3), np.ones(3)
        if re.match(r"[-+.\d]", self.words.peek() or ""):
            colour = self.words.numbers(3)
        self.lights.append((self.node, name, position, colour))

    def polygon(self, corners, normals):
        if normals.shape[1] == 0:
            normals = np.zeros_like(corners)
        both = np.stack([corners, normals])  # [2][n][3]
        fan = np.array([both[:, [0, i, i + 1]] for i in range(1, len(corners) - 1)])
        self.things.append(("triangles", self.node, fan))

    def mesh(self):
        w = self.words
        assert w.next() == "vertices"
        vertices, normals, columns = w.rows(3), None, 3
        while (word := w.next()) != "triangles":
            columns += 3
            if word == "normals":
                normals = w.rows(3)
            else:
                count = int(w.next())
                w.next()
                w.numbers(2 * count)
        numbers = w.rows(columns).astype(int)
        corners = vertices[numbers[:, :3]]
        directions = normals[numbers[:, 3:6]] if normals is not None else np.zeros_like(corners)
        self.things.append(("triangles", self.node, np.stack([corners, directions], axis=1)))

    def begin(self, what):
        assert self.words.next() == "{"
        self.open.append(self.node)
        self.nodes.append((self.node, what))
        self.node = len(self.nodes) - 1

    def keys(self):
        track = self.tracks.setdefault(self.words.next(), Track())
        assert self.words.next() == "{"
        while (kind := self.words.next()) != "}":
            if kind == "visibility":
                track.visibility = self.words.rows(2)
            else:
                track.curves[kind] = Curve(self.words.rows(8 if kind == "rot" else 7))

    def track(self, name):
        return self.tracks.get(name, Track())


class Moment:
    """A scene at a time."""

    def __init__(self, scene, time):
        self.scene, self.time, self.matrices, self.visible = scene, time, [], []
        for i, (parent, what) in enumerate(scene.nodes):
            is_moved = isinstance(what, str)
            own = scene.track(what).matrix(time) if is_moved else what
            self.matrices.append(self.matrices[parent] @ own if i else own)
            self.visible.append((i == 0 or self.visible[parent])
                                and (not is_moved or scene.track(what).is_visible(time)))

    def camera(self):
        """Eye, direction and up; unit."""
        c = self.scene.camera
        eye, direction, up = c["from"], c["at"] - c["from"], c["up"]
        if "camera" in self.scene.tracks:
            matrix = self.scene.tracks["camera"].matrix(self.time)
            eye, direction, up = matrix[:3, 3], -matrix[:3, 2], matrix[:3, 1]
        return eye, direction / np.linalg.norm(direction), up / np.linalg.norm(up)

    def lights(self):
        """Rows of position and colour."""
        rows = []
        for node, name, position, colour in self.scene.lights:
            matrix = self.matrices[node] @ self.scene.track(name).matrix(self.time)
            rows.append(np.concatenate([matrix[:3, :3] @ position + matrix[:3, 3], colour]))
        return np.array(rows).reshape(-1, 6)

    def local(self, what):
        times, keys = what
        time = min(max(self.time, times[0]), times[-1])
        return np.array([[[np.interp(time, times, keys[:, corner, which, axis]) for axis in range(3)]
                          for corner in range(3)] for which in range(2)])[None]

    def triangles(self, node, what):
        """In the world: corners and unit normals, [n][2][3][3]; of a mirror wound the other way round."""
        matrix = self.matrices[node]
        corners = what[:, 0] @ matrix[:3, :3].T + matrix[:3, 3]
        normals = what[:, 1] @ np.linalg.inv(matrix[:3, :3])
        length = np.linalg.norm(normals, axis=-1, keepdims=True)
        normals = np.divide(normals, length, out=np.zeros_like(normals), where=length > 0.0)
        placed = np.stack([corners, normals], axis=1)
        return placed[:, :, [0, 2, 1]] if np.linalg.det(matrix[:3, :3]) < 0.0 else placed

    def surface_distance(self, kind, node, shape, corners):
        """How far points of the world are from a sphere, or from the two circles of a cone."""
        matrix = self.matrices[node]
        points = (corners - matrix[:3, 3]) @ np.linalg.inv(matrix[:3, :3]).T
        if kind == "sphere":
            return np.abs(np.linalg.norm(points - shape[:3], axis=-1) - shape[3])
        axis = (shape[4:7] - shape[:3]) / np.linalg.norm(shape[4:7] - shape[:3])
        distances = []
        for centre, radius in ((shape[:3], shape[3]), (shape[4:7], shape[7])):
            along = (points - centre) @ axis
            across = np.linalg.norm(points - centre - along[..., None] * axis, axis=-1)
            distances.append(np.hypot(along, across - radius))
        return np.minimum(*distances)
