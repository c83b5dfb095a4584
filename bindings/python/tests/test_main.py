"""python -m rsh."""

import re
import subprocess
import sys

import numpy as np

from rsh.__main__ import sheet


def test_it_tells_devices_and_measures():
    done = subprocess.run(
        [sys.executable, "-m", "rsh", "0.1"], capture_output=True, text=True, check=True, timeout=300
    )
    lines = done.stdout.splitlines()
    assert re.match(r"rsh 0\.1\.0, pyopencl \d", lines[0])
    assert sum(line.startswith("-> ") for line in lines) == 1
    assert "  unsafe strategies: none" in lines
    assert "  wrong arithmetic: none" in lines
    assert done.stderr == "", "no bars where there is no terminal"
    measured = re.findall(r"(\d+) triangles, (\w+): +([\d.]+) ms \((\d+) % of the rays hit\)", done.stdout)
    assert [(row[0], row[1]) for row in measured] == [
        (str(2 * n * n), kind) for n in (100, 200, 400) for kind in ("camera", "random")
    ]
    assert all(float(ms) > 0 and 90 <= int(share) <= 100 for _, _, ms, share in measured)


def test_the_sheet_is_a_height_field_without_holes():
    vertices, faces = sheet(8, 0.5)
    corners = vertices[faces].astype(float)
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2] / 2
    assert np.all(areas > 0)
    assert np.isclose(areas.sum(), 4)
