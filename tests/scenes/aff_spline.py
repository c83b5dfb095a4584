"""aff_spline.py - the key frames of AFF files: Kochanek-Bartels splines over uneven times, for vectors and,
on the logarithms of quaternions, for rotations. Written from the grammar of the format, in double precision."""
import math

import numpy as np

IDENTITY = np.array([1.0, 0.0, 0.0, 0.0])  # w, x, y, z


def rotation_about(axis, degrees):
    length = np.linalg.norm(axis)
    if length == 0.0:
        return IDENTITY
    half = math.radians(degrees) / 2.0
    return np.concatenate([[math.cos(half)], math.sin(half) * np.asarray(axis) / length])


def product(a, b):
    return np.concatenate([[a[0] * b[0] - a[1:] @ b[1:]],
                           a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])])


def conjugate(q):
    return q * np.array([1.0, -1.0, -1.0, -1.0])


def log(q):
    length = np.linalg.norm(q[1:])
    return q[1:] / length * math.atan2(length, q[0]) if length > 0.0 else np.zeros(3)


def exp(v):
    angle = np.linalg.norm(v)
    if angle == 0.0:
        return IDENTITY
    return np.concatenate([[math.cos(angle)], math.sin(angle) * v / angle])


def slerp(a, b, u):
    return product(a, exp(u * log(product(conjugate(a), b))))


def matrix_of(q):
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class Curve:
    """rows: per key its time, the value, then tension, continuity, bias."""

    def __init__(self, rows):
        rows = np.array(rows)
        self.times, self.values, self.shapes = rows[:, 0], rows[:, 1:-3], rows[:, -3:]

    def segment(self, time):
        """The number of the key where it starts, and how far along it the time is."""
        t = self.times
        time = min(max(time, t[1]), t[-2])
        i = max(k for k in range(1, len(t) - 2) if t[k] <= time)
        return i, (time - t[i]) / (t[i + 1] - t[i]) if t[i + 1] > t[i] else 1.0

    def tangents(self, i, before, here, after):
        """At both ends of the segment from key i, of the steps on it and on its neighbours."""
        t0, t1, t2, t3 = self.times[i - 1:i + 3]
        (tension1, continuity1, bias1), (tension2, continuity2, bias2) = self.shapes[i:i + 2]
        a1 = 2.0 * (t2 - t1) / (t2 - t0) if t2 > t0 else 0.0
        a2 = 2.0 * (t2 - t1) / (t3 - t1) if t3 > t1 else 0.0
        leaving = (1.0 - tension1) / 2.0 * a1 * ((1.0 - continuity1) * (1.0 - bias1) * here
                                                 + (1.0 + continuity1) * (1.0 + bias1) * before)
        arriving = (1.0 - tension2) / 2.0 * a2 * ((1.0 + continuity2) * (1.0 - bias2) * after
                                                  + (1.0 - continuity2) * (1.0 + bias2) * here)
        return leaving, arriving

    def point(self, time):
        i, u = self.segment(time)
        p0, p1, p2, p3 = self.values[i - 1:i + 3]
        leaving, arriving = self.tangents(i, p1 - p0, p2 - p1, p3 - p2)
        return ((2 * u**3 - 3 * u**2 + 1) * p1 + (3 * u**2 - 2 * u**3) * p2
                + (u**3 - 2 * u**2 + u) * leaving + (u**3 - u**2) * arriving)

    def rotation(self, time):
        i, u = self.segment(time)
        q = [rotation_about(row[:3], row[3]) for row in self.values[i - 1:i + 3]]
        for k in range(1, 4):
            if q[k - 1] @ q[k] < 0.0:
                q[k] = -q[k]
        steps = [log(product(conjugate(a), b)) for a, b in zip(q, q[1:])]
        leaving, arriving = self.tangents(i, *steps)
        inner1 = product(q[1], exp((leaving - steps[1]) / 2.0))
        inner2 = product(q[2], exp((steps[1] - arriving) / 2.0))
        return slerp(slerp(q[1], q[2], u), slerp(inner1, inner2, u), 2.0 * u * (1.0 - u))
