"""The generated structs against what the library describes."""

import ctypes as ct
import gc
import importlib.util
from pathlib import Path

import numpy as np
import pyopencl.array as cla
import pytest
from pyopencl.tools import ImmediateAllocator, MemoryPool

import rsh
from rsh import _library, structs

GENERATE = Path(__file__).parents[1] / "generate"


@pytest.fixture(scope="module")
def interface():
    spec = importlib.util.spec_from_file_location("described", GENERATE / "described.py")
    described = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(described)
    return described.Interface(_library.library)


def test_every_struct_lies_as_the_library_has_it(interface):
    for name, described in interface.structs.items():
        if name.endswith("_info") or name == "rsh_interface":
            continue
        made = getattr(structs, "".join(word.capitalize() for word in name.split("_")[1:]))
        assert ct.sizeof(made) == described.size
        for field in described.fields:
            place = getattr(made, field.name)
            assert (place.offset, place.size) == (field.offset, field.size), (name, field.name)


def test_every_function_and_constant_is_there(interface):
    for name in interface.functions:
        if name not in (
            "rsh_create_context",
            "rsh_release_context",
            "rsh_last_error",
            "rsh_describe_interface",
        ):
            assert getattr(rsh, name.removeprefix("rsh_")).__doc__
    for name, value in interface.constants.items():
        assert getattr(rsh, name.removeprefix("RSH_")) == value


def test_structs_in_buffers_are_dtypes():
    assert np.dtype(structs.Hit) == np.dtype([("t", "<f4"), ("u", "<f4"), ("v", "<f4"), ("primitive", "<u4")])
    assert np.dtype(structs.Material).itemsize == 128


def test_a_struct_keeps_what_its_parts_referred_to(queue):
    pool = MemoryPool(ImmediateAllocator(queue))
    for outer in structs.ShadeDesc, structs.FrameDesc:
        scene = structs.Scene(materials=cla.zeros(queue, 8, np.float32, allocator=pool))
        desc = outer(scene=scene)
        scene.materials = None
        gc.collect()
        assert pool.active_blocks == 1, desc
        del desc
        gc.collect()
        assert pool.active_blocks == 0


def test_what_is_no_member_or_of_a_wrong_type_is_refused(queue):
    geometry = structs.Geometry()
    with pytest.raises(AttributeError, match="Geometry has no member vertex"):
        geometry.vertex = 1
    with pytest.raises(TypeError, match="Geometry.vertices is ndarray, must be a pyopencl.Buffer"):
        geometry.vertices = np.zeros(3)
    with pytest.raises(ValueError, match="Geometry.vertices has strides .*, must be C-contiguous"):
        geometry.vertices = cla.zeros(queue, (8, 8), np.float32).T
    with pytest.raises(TypeError, match="Geometry.vertex_count"):
        geometry.vertex_count = 1.5
    with pytest.raises(ValueError, match="Camera.eye has 2 numbers, must have 3 or 4"):
        structs.Camera(eye=(1, 2))
    with pytest.raises(TypeError, match="TraverseDesc.geometry"):
        rsh.structs.TraverseDesc(geometry=structs.Camera())
    with pytest.raises(AttributeError, match="assign the whole part"):
        structs.BoundDesc(geometry=geometry).geometry.vertices = cla.zeros(queue, 3, np.float32)
