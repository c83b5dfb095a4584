#!/usr/bin/env python3
"""voxelize.py [--out torus.png] [--side 64] - a torus as voxels, by parity: a point is inside where a ray
from it crosses the surface an odd number of times. Prints the volume beside the true one; the picture has
slices. Needs Pillow."""

import argparse

import numpy as np
from PIL import Image

import rsh

RADIUS, TUBE = 0.7, 0.25


def torus(count):
    angles = np.arange(count) / count * 2 * np.pi
    u, v = np.meshgrid(angles, angles, indexing="ij")
    ring = RADIUS + TUBE * np.cos(v)
    vertices = np.stack([ring * np.cos(u), ring * np.sin(u), TUBE * np.sin(v)], -1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(count), np.arange(count), indexing="ij")
    at = lambda row, column: (row % count * count + column % count).ravel()  # noqa: E731
    a, b, c, d = at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)
    return vertices, np.concatenate([np.stack([a, b, c], 1), np.stack([b, d, c], 1)])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", default="torus.png")
    parser.add_argument("--side", type=int, default=64)
    given = parser.parse_args()

    centres = (np.arange(given.side) + 0.5) / given.side * 2 - 1
    x, y, z = np.meshgrid(centres, centres, centres, indexing="ij")
    points = np.stack([x, y, z], -1).reshape(-1, 3)
    inside = rsh.Scene(*torus(256)).contains(points).reshape(x.shape)

    volume, true = inside.mean() * 8, 2 * np.pi**2 * RADIUS * TUBE**2
    slices = np.linspace(0, given.side - 1, 10).astype(int)[1:-1]
    picture = np.concatenate([np.pad(inside[:, k], 1) for k in slices], axis=1)
    Image.fromarray((picture * 255).astype(np.uint8)).save(given.out)
    print(f"{given.out}: {inside.sum()} of {inside.size} voxels, volume {volume:.4f}, true {true:.4f}")


if __name__ == "__main__":
    main()
