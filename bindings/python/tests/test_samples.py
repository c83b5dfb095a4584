"""samples/python, each as it is run."""

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

SAMPLES = Path(__file__).parents[3] / "samples/python"


def run(folder, name, *options):
    command = [sys.executable, str(SAMPLES / name), *options]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True, timeout=300).stdout


def test_a_mesh_moves(tmp_path):
    assert run(tmp_path, "moving_mesh.py", "--frames", "4", "--side", "64").startswith("wave.gif: 4 frames")
    with Image.open(tmp_path / "wave.gif") as picture:
        frames = [np.asarray(frame.convert("L"), int) for frame in ImageSequence.Iterator(picture)]
    assert len(frames) == 4
    for frame, following in zip(frames, frames[1:], strict=False):
        assert np.mean(np.abs(frame - following)) > 2
        shares = [np.mean(frame < 30), np.mean((frame > 40) & (frame < 60)), np.mean(frame > 100)]
        assert min(shares) > 0.01, "background, shadow and light"


def test_a_tower_is_seen_from_what_it_sees(tmp_path):
    printed = run(tmp_path, "line_of_sight.py", "--cells", "100")
    with Image.open(tmp_path / "sight.png") as picture:
        red, green, _ = np.moveaxis(np.asarray(picture, int), -1, 0)
    assert red.shape == (101, 101)
    row, column = np.argwhere((red == 255) & (green == 0)).mean(0).astype(int)
    seen = green > 1.5 * red
    assert seen[row - 4 : row + 5, column - 4 : column + 5].sum() > 30
    share = int(re.search(r"(\d+) %", printed)[1])
    assert abs(100 * seen.mean() - share) < 2
    assert 10 < share < 90


def test_voxels_have_the_volume_of_the_torus(tmp_path):
    printed = run(tmp_path, "voxelize.py", "--side", "48")
    volume, true = map(float, re.search(r"volume ([\d.]+), true ([\d.]+)", printed).groups())
    assert abs(volume / true - 1) < 0.01
    with Image.open(tmp_path / "torus.png") as picture:
        assert picture.size == (8 * 50, 50)


def test_results_of_the_benchmark_are_drawn(tmp_path):
    results = SAMPLES.parents[1] / "docs/results/hits.json"
    assert run(tmp_path, "plot_bench.py", str(results)) == "bench.png: 21 rows, 6 contenders\n"
    with Image.open(tmp_path / "bench.png") as picture:
        pixels = np.asarray(picture.convert("RGB"), int)
    coloured = pixels.max(-1) - pixels.min(-1) > 60
    assert coloured[pixels.shape[0] // 5 :].sum() > 117 * 20, "117 marks"
    (tmp_path / "empty.json").write_text('{"suite": "frame", "cases": []}')
    with pytest.raises(subprocess.CalledProcessError) as failed:
        run(tmp_path, "plot_bench.py", "empty.json")
    assert "empty.json: no case is right and has ms_total" in failed.value.stderr


def test_results_of_frames_have_embree_beside_them(tmp_path):
    case = {"ok": True, "name": "frame/scene:room/size:8x8/rays:shadow/engine:tiles/bound:box"}
    case["metrics"] = {"ms_total": 2.0, "embree_build_ms": 1.0, "embree_trace_ms": 3.0}
    wrong = {**case, "ok": False, "name": case["name"] + "/refit"}
    (tmp_path / "frame.json").write_text(json.dumps({"suite": "frame", "cases": [case, wrong]}))
    assert run(tmp_path, "plot_bench.py", "frame.json") == "bench.png: 1 rows, 2 contenders\n"


def test_numbers_are_reduced(tmp_path):
    assert run(tmp_path, "reduce.py").split()[1:4] == ["5", "1029", "2053"]
