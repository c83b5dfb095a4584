"""What is wrong is an exception with the library's message, and never a crash."""

import os
import re
import subprocess
import sys

import numpy as np
import pyopencl as cl
import pyopencl.array as cla
import pytest
from conftest import allocate, closest, trace

import rsh
from rsh.structs import Geometry, Hit, Material, Scene


def test_the_message_names_the_argument(context, queue, mesh):
    with pytest.raises(rsh.InvalidValueError, match="geometry.vertices: is NULL") as caught:
        rsh.bound(context, queue, geometry=Geometry(vertex_count=3, triangle_count=1))
    assert caught.value.status == rsh.INVALID_VALUE
    assert isinstance(caught.value, ValueError)
    with pytest.raises(rsh.InvalidValueError, match="bounds: holds 16 bytes, needs"):
        rsh.bound(context, queue, geometry=mesh.geometry, bounds=allocate(context, 16))


def test_events_that_failed_are_refused(context, queue, mesh):
    failed = cl.UserEvent(context.context)
    failed.set_status(-5)
    with pytest.raises(rsh.Error) as caught:
        trace(context, queue, mesh, hits=cla.zeros(queue, 500, np.dtype(Hit)), wait_for=[failed])
    assert caught.value.status == cl.status_code.EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST


def test_arrays_on_the_host_have_the_length_that_the_scene_says():
    with pytest.raises(ValueError, match=r"materials has shape \(1,\), must be C-contiguous and \(2,\)"):
        rsh.find_features(Scene(material_count=2), np.zeros(1, np.dtype(Material)), np.zeros(0))
    with pytest.raises(TypeError, match="materials must be a NumPy array of dtype"):
        rsh.find_features(Scene(material_count=2), np.zeros(2), np.zeros(0))


def test_progress_cancels_and_hands_on_what_it_raises(context, queue, mesh):
    hits = cla.zeros(queue, 500, np.dtype(Hit))
    seen = []
    trace(context, queue, mesh, hits=hits, progress=lambda *batch: seen.append(batch))
    assert seen == [(0, 1)]
    with pytest.raises(rsh.Error) as caught:
        trace(context, queue, mesh, hits=hits, progress=lambda *_: True)
    assert caught.value.status == rsh.CANCELLED
    with pytest.raises(ZeroDivisionError):
        trace(context, queue, mesh, hits=hits, progress=lambda batch, count: 1 / batch)


def test_a_released_context_is_refused(queue, mesh):
    with rsh.Context() as context:
        pass
    with pytest.raises(rsh.InvalidValueError, match="context"):
        rsh.bound_query(context, geometry=mesh.geometry)


def test_a_device_of_another_context_is_refused(context):
    with pytest.raises(AttributeError):
        rsh.Context(context)
    with pytest.raises(rsh.NoDeviceError, match="no such device"):
        rsh.find_device("no such device")


def reduce_in(context):
    queue = cl.CommandQueue(context.context)
    stream, count = cla.zeros(queue, 64, np.uint32), cla.zeros(queue, 1, np.uint32)
    kept = cla.zeros(queue, 64, np.uint32)
    rsh.reduce(
        context,
        queue,
        input=stream,
        count=64,
        element_bytes=4,
        keep=rsh.KEEP_NOT_NULL,
        output=kept,
        output_count=count,
    ).wait()


def test_a_context_takes_text_and_a_log(tmp_path):
    lines = []
    reduce_in(rsh.Context(log=lines.append, cache_dir=""))
    assert any(line.startswith("reduce/") for line in lines)
    with pytest.raises(rsh.Error, match=str(tmp_path)):
        reduce_in(rsh.Context(kernel_dir=str(tmp_path)))


def test_buffers_of_another_context_are_refused(mesh):
    context = rsh.Context()
    with pytest.raises(rsh.InvalidValueError, match="context"):
        closest(context, cl.CommandQueue(context.context), mesh)


@pytest.mark.parametrize("program", ["rsh.Context()", "rsh.Scene([[0, 0, 0]] * 3)", "rsh.find_device('x')"])
def test_without_a_platform_it_tells_how_to_get_one(program):
    done = without_a_platform("-c", f"import rsh; {program}")
    assert "NoDeviceError" in done.stderr
    assert "? PoCL makes one of any CPU: pip install 'pyopencl[pocl]'" in done.stderr


def test_without_a_platform_the_program_says_so_in_one_line():
    done = without_a_platform("-m", "rsh")
    assert done.returncode == 1
    assert re.fullmatch("no OpenCL platform.* pip install 'pyopencl.pocl.'.*\n", done.stderr)


def without_a_platform(*arguments):
    nowhere = {"OCL_ICD_VENDORS": "/nonexistent", "OPENCL_VENDOR_PATH": "/nonexistent"}
    command = [sys.executable, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, **nowhere})
