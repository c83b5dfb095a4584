"""What calls make of OpenCL's objects is released, counted by a layer below pyopencl and rsh."""

import json
import os
import subprocess
import sys
from pathlib import Path

LAYERS = Path(__file__).parents[3] / "tests/support/layers"


def test_ten_thousand_calls_leave_no_object_of_opencl_behind(tmp_path):
    layer = tmp_path / "counts.so"
    sources = [LAYERS / f"{name}.cpp" for name in ("pass_on", "counts", "count_calls", "objects")]
    command = ["c++", "-std=c++17", "-shared", "-fPIC", f"-I{LAYERS.parents[1]}", "-o", layer, *sources]
    subprocess.run(command, check=True)
    done = subprocess.run(
        [sys.executable, Path(__file__).with_name("counted_calls.py"), layer, "1000"],
        env={**os.environ, "OPENCL_LAYERS": str(layer)},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr
    before, few, many, behind = json.loads(done.stdout)
    assert few["contexts_alive"] == 1, "the loader has left out the layer"
    assert few["buffers_alive"] > 0
    assert many == few
    assert behind == before
