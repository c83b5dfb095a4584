#!/usr/bin/env python3
"""moving_mesh.py [--out wave.gif] [--frames 40] [--side 256] - a sheet that waves, lit, as a GIF: in each
frame all vertices are new, the bounds are refitted, and a shadow ray starts at each hit. Needs Pillow."""

import argparse

import numpy as np
from PIL import Image

import rsh
from rsh.__main__ import sheet
from rsh.progress import watched


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", default="wave.gif")
    parser.add_argument("--frames", type=int, default=40)
    parser.add_argument("--side", type=int, default=256)
    given = parser.parse_args()

    pixels = (np.arange(given.side) + 0.5) / given.side * 2 - 1
    x, y = np.meshgrid(pixels, -pixels)
    eye = np.array([0.0, -1.9, 1.3])
    forward, up = np.array([0, 0.83, -0.56]), np.array([0, 0.56, 0.83])
    rays = rsh.make_rays(eye, forward + 0.6 * (x[..., None] * [1, 0, 0] + y[..., None] * up))
    to_light = np.array([0.75, 0.3, 0.59])

    vertices, faces = sheet(120, 0)
    scene = rsh.Scene(vertices, faces)
    pictures = []
    for phase in watched(np.linspace(0, 2 * np.pi, given.frames, endpoint=False), "frames"):
        vertices = sheet(120, phase)[0] * [1, 1, 2]
        scene.update(vertices)
        hits = scene.closest(rays, normal=True, location=True)
        is_hit = hits.primitive != rsh.NO_HIT
        is_dark = np.ones(is_hit.shape, bool)
        is_dark[is_hit] = scene.any(rsh.make_rays(hits.location[is_hit] + 1e-4 * to_light, to_light))
        light = np.where(is_dark, 0, np.clip(hits.normal @ to_light, 0, 1))
        grey = np.where(is_hit, 50 + 205 * light, 15).astype(np.uint8)
        pictures.append(Image.fromarray(grey))
    pictures[0].save(given.out, save_all=True, append_images=pictures[1:], duration=50, loop=0)
    print(f"{given.out}: {given.frames} frames, {len(faces)} triangles")


if __name__ == "__main__":
    main()
