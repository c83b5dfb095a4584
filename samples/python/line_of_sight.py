#!/usr/bin/env python3
"""line_of_sight.py [--out sight.png] [--cells 256] - hills from above, and what a tower on them sees: a ray
from each place to the top of the tower, green where nothing is in between. Needs Pillow."""

import argparse

import numpy as np
from PIL import Image

import rsh


def hills(cells, seed=4):
    """Heights of (cells + 1)^2 places: waves of all directions, the longer the higher."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(*[np.linspace(0, 1, cells + 1)] * 2)
    height = np.zeros_like(x)
    for length in 2.0 ** -np.arange(1, 6):
        for angle, phase in random.uniform(0, 2 * np.pi, (6, 2)):
            along = np.cos(angle) * x + np.sin(angle) * y
            height += 0.06 * length**1.6 * np.sin(2 * np.pi * along / length + phase)
    return np.stack([x, y, height], -1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", default="sight.png")
    parser.add_argument("--cells", type=int, default=256)
    given = parser.parse_args()

    places = hills(given.cells)
    corner = np.arange(places[..., 0].size).reshape(places.shape[:2])
    a, b, c, d = (
        corner[rows].ravel() for rows in (np.s_[:-1, :-1], np.s_[:-1, 1:], np.s_[1:, :-1], np.s_[1:, 1:])
    )
    faces = np.concatenate([np.stack([a, b, c], 1), np.stack([b, d, c], 1)])
    scene = rsh.Scene(places.reshape(-1, 3), faces)

    row, column = np.unravel_index(np.argmax(places[..., 2]), corner.shape)
    tower = places[row, column] + [0, 0, 0.01]
    eyes = places + [0, 0, 0.001]
    is_hidden = scene.any(rsh.make_rays(eyes, tower - eyes, tmax=1))

    slope = np.gradient(places[..., 2], axis=1) * given.cells
    lit = 0.6 + 0.4 * np.clip(slope / np.abs(slope).max(), -1, 1)
    picture = 255 * lit[..., None] * np.where(is_hidden[..., None], [0.65, 0.6, 0.6], [0.5, 1, 0.5])
    picture[max(row - 2, 0) : row + 3, max(column - 2, 0) : column + 3] = [255, 0, 0]
    Image.fromarray(picture.clip(0, 255).astype(np.uint8)).save(given.out)
    print(f"{given.out}: {100 * np.mean(~is_hidden):.0f} % of the places see the tower")


if __name__ == "__main__":
    main()
