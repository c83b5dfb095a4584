"""rsh.open3d against what Open3D 0.20.0 answered (open3d.t.geometry.RaycastingScene, CPU) for the same calls;
tests/python/compare_open3d.py asks it anew, where it is installed."""

from types import SimpleNamespace

import numpy as np
import pytest

from rsh.open3d import RaycastingScene

# open3d.geometry.TriangleMesh.create_box()
VERTICES = [[0, 0, 0], [1, 0, 0], [0, 0, 1], [1, 0, 1], [0, 1, 0], [1, 1, 0], [0, 1, 1], [1, 1, 1]]
FACES = [
    [4, 7, 5],
    [4, 6, 7],
    [0, 2, 4],
    [2, 6, 4],
    [0, 1, 2],
    [1, 3, 2],
    [1, 5, 7],
    [1, 7, 3],
    [2, 3, 7],
    [2, 7, 6],
    [0, 4, 1],
    [1, 4, 5],
]
RAYS = [[0.5, 0.4, 10, 0, 0, -1], [-1, -1, -1, 0, 0, -1], [-2, 0.3, 0.6, 2, 0, 0], [3.25, 0.5, 5, 0, 0, -2]]
MISS = RaycastingScene.INVALID_ID


class FakeTensor:
    """Knows how to become an array, as Open3D's do."""

    def __init__(self, array):
        self.array = np.asarray(array)

    def numpy(self):
        return self.array


@pytest.fixture
def scene():
    made = RaycastingScene()
    vertex = SimpleNamespace(positions=FakeTensor(np.float32(VERTICES)))
    mesh = SimpleNamespace(vertex=vertex, triangle=SimpleNamespace(indices=FakeTensor(FACES)))
    assert made.add_triangles(mesh) == 0
    assert made.add_triangles(np.add(VERTICES, [3, 0, 0]), FACES) == 1
    return made


def test_closest_hits(scene):
    assert MISS == 4294967295
    answer = {key: values.numpy() for key, values in scene.cast_rays(FakeTensor(np.float32(RAYS))).items()}
    assert {key: (values.dtype, values.shape) for key, values in answer.items()} == {
        "t_hit": (np.float32, (4,)),
        "geometry_ids": (np.uint32, (4,)),
        "primitive_ids": (np.uint32, (4,)),
        "primitive_uvs": (np.float32, (4, 2)),
        "primitive_normals": (np.float32, (4, 3)),
    }
    np.testing.assert_allclose(answer["t_hit"], [9, np.inf, 1, 2], rtol=1e-6)
    assert answer["geometry_ids"].tolist() == [0, MISS, 0, 1]
    assert answer["primitive_ids"].tolist() == [8, MISS, 2, 9]
    np.testing.assert_allclose(
        answer["primitive_uvs"], [[0.1, 0.4], [0, 0], [0.6, 0.3], [0.25, 0.25]], atol=1e-6
    )
    np.testing.assert_array_equal(answer["primitive_normals"], [[0, 0, 1], [0, 0, 0], [-1, 0, 0], [0, 0, 1]])


def test_occlusions_and_counts(scene):
    found = scene.test_occlusions(RAYS)
    assert found.dtype == bool
    assert found.tolist() == [True, False, True, True]
    assert scene.test_occlusions(RAYS, tnear=2, tfar=8).tolist() == [False, False, True, True]
    assert scene.test_occlusions(RAYS, tnear=9.5).tolist() == [True, False, False, False]
    counts = scene.count_intersections(RAYS)
    assert counts.dtype == np.int32
    assert counts.tolist() == [2, 0, 4, 2]


def test_lists(scene):
    answer = scene.list_intersections(RAYS)
    expected = {
        "t_hit": (np.float32, [9, 10, 1, 1.5, 2.5, 3, 2, 2.5]),
        "primitive_ids": (np.uint32, [8, 10, 2, 7, 2, 7, 9, 10]),
        "geometry_ids": (np.uint32, [0, 0, 0, 0, 1, 1, 1, 1]),
        "ray_ids": (np.uint32, [0, 0, 2, 2, 2, 2, 3, 3]),
        "ray_splits": (np.uint32, [0, 2, 2, 6, 8]),
        "primitive_uvs": (
            np.float32,
            [
                [0.1, 0.4],
                [0.4, 0.5],
                [0.6, 0.3],
                [0.3, 0.3],
                [0.6, 0.3],
                [0.3, 0.3],
                [0.25, 0.25],
                [0.5, 0.25],
            ],
        ),
    }
    assert answer.keys() == expected.keys()
    for key, (dtype, values) in expected.items():
        assert answer[key].dtype == dtype, key
        np.testing.assert_allclose(answer[key], values, rtol=1e-6, err_msg=key)


def test_rays_of_a_camera():
    rays = RaycastingScene.create_rays_pinhole(
        fov_deg=60, center=[0.5, 0.5, 0.5], eye=[-1, -1, -1], up=[0, 0, 1], width_px=4, height_px=3
    )
    assert (rays.shape, rays.dtype) == ((3, 4, 6), np.float32)
    np.testing.assert_allclose(rays[0, 0], [-1, -1, -1, 1.0013876, 0.38901517, 0.34164801], rtol=1e-6)
    np.testing.assert_allclose(rays[2, 1], [-1, -1, -1, 0.56156123, 0.35743707, 0.81305254], rtol=1e-6)
    intrinsic = [[500, 0, 2], [0, 400, 1.5], [0, 0, 1]]
    extrinsic = [[0, 1, 0, 0.1], [-1, 0, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]
    rays = RaycastingScene.create_rays_pinhole(FakeTensor(intrinsic), extrinsic, 3, 2)
    assert rays.shape == (2, 3, 6)
    np.testing.assert_allclose(rays[0, 0], [0.2, -0.1, -0.3, 0.0025, -0.003, 1], rtol=1e-6)
    np.testing.assert_allclose(rays[1, 2], [0.2, -0.1, -0.3, 0, 0.001, 1], rtol=1e-6, atol=1e-9)


def test_meshes_may_be_added_between_casts(scene):
    for i in range(3):
        height = 20.0 + i
        triangle = [[0, 0, height], [1, 0, height], [0, 1, height]]
        assert scene.add_triangles(triangle, [[0, 1, 2]]) == 2 + i
        answer = scene.cast_rays([[0.2, 0.2, 30, 0, 0, -1]])
        assert (answer["geometry_ids"][0], answer["primitive_ids"][0]) == (2 + i, 0)
        assert answer["t_hit"][0] == pytest.approx(30 - height)


def test_answers_have_the_shape_of_the_rays(scene):
    rays = np.tile(RAYS, (2, 3, 1, 1))
    answer = scene.cast_rays(rays)
    assert answer["primitive_normals"].shape == (2, 3, 4, 3)
    assert answer["geometry_ids"][1, 2].tolist() == [0, MISS, 0, 1]
    assert scene.count_intersections(rays).shape == scene.test_occlusions(rays).shape == (2, 3, 4)
    empty = RaycastingScene()
    assert empty.cast_rays(RAYS)["t_hit"].tolist() == [np.inf] * 4
    assert empty.count_intersections(np.zeros((0, 6))).shape == (0,)


def test_what_does_not_fit_is_refused(scene):
    with pytest.raises(ValueError, match=r"rays has shape \(6,\), must be \(..., 6\)"):
        scene.cast_rays(RAYS[0])
    with pytest.raises(ValueError, match="triangle_indices has 8, must be below 8"):
        scene.add_triangles(VERTICES, [[0, 1, 8]])
    with pytest.raises(ValueError, match=r"vertex_positions has shape \(3,\), must be \(n, 3\)"):
        scene.add_triangles([0, 0, 0], FACES)
    with pytest.raises(ValueError, match=r"intrinsic_matrix has shape \(3,\), must be \(3, 3\)"):
        RaycastingScene.create_rays_pinhole([1, 2, 3], np.eye(4), 3, 2)
    with pytest.raises(ValueError, match="up is .*, must have another direction than center - eye"):
        RaycastingScene.create_rays_pinhole(60, [0, 0, 1], [0, 0, 0], [0, 0, 2], 3, 2)
