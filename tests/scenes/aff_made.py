"""aff_made.py - an AFF file with all that BART's have seldom or never: lights that move, transforms in
transforms, mirroring and uneven scales, what vanishes, splines with tension, continuity and bias."""
import numpy as np

KEYS = 7
KINDS = {"transl": 3, "scale": 3, "rot": 4}


class Maker:
    def __init__(self):
        self.random = np.random.default_rng(1)
        self.lines = []

    def add(self, *words):
        self.lines.append(" ".join(f"{w:.9g}" if isinstance(w, float) else str(w) for w in words))

    def floats(self, count):
        return self.random.uniform(-1.0, 1.0, count).tolist()

    def triangle(self, command, numbers, texture=()):
        self.add(command, *texture, *[x for _ in range(3) for x in self.floats(numbers)])

    def things(self):
        """One of each command that draws."""
        self.add("p 3", *self.floats(9))
        self.add("p 4", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)
        self.add("pp 3", *self.floats(18))
        self.triangle("tt", 5, ["none.ppm"])
        self.triangle("ttp", 8, ["none.ppm"])
        self.add("s", *self.floats(3), 0.5)
        self.add("c", *self.floats(3), 0.5, *self.floats(3), 0.2)
        self.add("m vertices 4", *self.floats(12), "normals 2", *self.floats(6),
                 "texturecoords 2 none.ppm", *self.floats(4),
                 "triangles 2  0 1 2 0 1 0 0 0 1   3 2 1 1 1 0 1 1 0")
        self.add("m vertices 3", *self.floats(9), "triangles 1  2 0 1")
        self.add("tpa 4")
        for time in (-0.5, 1.0, 1.75, 3.0):
            self.add(time, *self.floats(18))

    def curve(self, kind, values=None):
        times = np.cumsum(self.random.uniform(0.3, 1.1, KEYS)) - 1.0
        self.add(kind, KEYS)
        for i, time in enumerate(times):
            value = values[i] if values else self.floats(KINDS[kind])
            if kind == "rot":
                value = value[:3] + [200.0 * value[3]]
            self.add(float(time), *value, *self.floats(3))

    def keys(self, name, kinds, **values):
        self.add("k", name, "{")
        for kind in kinds:
            if kind == "visibility":
                self.add("visibility 3  0.6 0  1.4 1  2.7 0")
            else:
                self.curve(kind, values.get(kind))
        self.add("}")

    def static(self, scale):
        self.add("xs", *scale, *self.floats(3), 130.0, *self.floats(3), "{")


def make_file(path):
    m = Maker()
    m.add("v from 0 1 5 at 0 0 0 up 0 1 0 angle 40 hither .1 resolution 8 6")
    m.add("a 0 3.2 33")
    m.add("l 1 2 3 .5 .25 1")
    m.things()
    m.static([1.5, -0.7, 1.0])
    m.add("l", *m.floats(3))
    m.add("la lamp", *m.floats(3), 0.1, 0.2, 0.3)
    m.add("x outer {")
    m.things()
    m.add("la lamp", *m.floats(3))
    m.static([0.5, 1.0, 2.0])
    m.add("x inner {")
    m.things()
    m.add("} } } }")
    m.add("x gone {")
    m.things()
    m.add("}")
    m.keys("lamp", ["transl", "rot"])
    m.keys("outer", ["transl", "rot", "scale"], scale=[[1.0 + 0.1 * i, 0.5, 2.0] for i in range(KEYS)])
    # Turns what is in it inside out on its way.
    m.keys("inner", ["rot", "scale"], scale=[[1.0, s, 1.0] for s in (1, 1, 0.8, -0.7, -1, 0.9, 1)])
    m.keys("gone", ["visibility", "rot"])
    m.keys("camera", ["transl", "rot"])
    path.write_text("\n".join(m.lines) + "\n")
    return path
