"""rsh.trimesh on trimesh's meshes: what its own tests of rays check, and what its ray objects get wrong."""

import copy
import pickle

import numpy as np
import pytest
import trimesh
from trimesh.creation import box, cylinder, icosphere

from rsh.trimesh import RayMeshIntersector

DOWN = [[0.0, 0.0, -1.0]]


def rays_down(low, high, count, z):
    """A grid of rays along -z."""
    x, y = np.meshgrid(*[np.linspace(low, high, count)] * 2)
    origins = np.stack([x.ravel(), y.ravel(), np.full(x.size, float(z))], 1)
    return origins, np.repeat(DOWN, len(origins), 0)


def hits_per_ray(ray, origins, directions):
    return np.bincount(ray.intersects_id(origins, directions)[1], minlength=len(origins))


@pytest.mark.parametrize(
    ("scale", "is_scaled"),
    [(1e-60, True), (1e-4, True), (1e-4, False), (1, False), (1e8, False), (1e60, True)],
)
def test_a_ray_through_a_box_of_any_size_hits_twice(scale, is_scaled):
    mesh = box().subdivide().subdivide().apply_scale(scale)
    ray = RayMeshIntersector(mesh, scale_to_box=is_scaled)
    for height in 0.5, 3:
        locations, index_ray, index_tri = ray.intersects_location([[0, 0, height * scale]], DOWN)
        assert index_ray.tolist() == [0, 0]
        np.testing.assert_allclose(locations[:, 2], [scale / 2, -scale / 2], rtol=1e-6)
        np.testing.assert_allclose(mesh.triangles[index_tri, :, 2].T, [locations[:, 2]] * 3, rtol=1e-6)


@pytest.mark.parametrize("shift", [(0, 0), (0.5, 0), (0, 0.5), (0.5, 0.5)])
def test_81_rays_through_vertices_or_edges_of_a_box_hit_twice(shift):
    mesh = box(extents=[16, 16, 16])
    for _ in range(4):
        mesh = mesh.subdivide()
    origins, directions = rays_down(-4, 4, 9, 20)
    origins[:, :2] += shift
    if shift == (0, 0):
        assert len(set(map(tuple, origins[:, :2])) & set(map(tuple, mesh.vertices[:, :2]))) == 81
    assert hits_per_ray(RayMeshIntersector(mesh), origins, directions).tolist() == [2] * 81


def test_rays_from_the_centre_through_vertices_hit_once():
    outer = box(extents=[60, 60, 60]).subdivide_to_size(20)
    ray = RayMeshIntersector(box(extents=[40, 40, 40]).subdivide_to_size(20))
    origins = np.zeros_like(outer.vertices)
    assert ray.intersects_any(origins, outer.vertices).all()
    assert np.all(ray.intersects_first(origins, outer.vertices) >= 0)
    assert hits_per_ray(ray, origins, outer.vertices).tolist() == [1] * len(origins)


def test_coincident_triangles_are_all_returned():
    corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    mesh = trimesh.Trimesh(corners, [[0, 1, 2]] * 3 + [[1, 0, 2]] * 2, process=False)
    index_tri, index_ray = RayMeshIntersector(mesh).intersects_id([[0.2, 0.2, 1]], DOWN)
    assert sorted(index_tri) == [0, 1, 2, 3, 4]
    assert index_ray.tolist() == [0] * 5
    assert len(RayMeshIntersector(mesh).intersects_id([[0.2, 0.2, 1]], DOWN, max_hits=2)[0]) == 2


def test_a_cylinder_is_hit_twice_everywhere():
    ray = RayMeshIntersector(cylinder(radius=1.0, height=4.0, sections=32))
    assert set(hits_per_ray(ray, *rays_down(-0.6, 0.6, 16, 5))) == {2}


def test_first_hits_are_the_nearest_and_locations_lie_on_rays():
    sphere = icosphere()
    ray = RayMeshIntersector(sphere)
    random = np.random.default_rng(1)
    origins = np.tile([[0.0, 0.0, -5.0]], (64, 1))
    directions = random.uniform(-0.1, 0.1, (64, 3)) + [0, 0, 1]
    index_tri, index_ray, locations = ray.intersects_id(
        origins, directions, multiple_hits=False, return_locations=True
    )
    assert index_ray.tolist() == list(range(64))
    np.testing.assert_array_equal(index_tri, ray.intersects_first(origins, directions))
    assert np.all(sphere.triangles_center[index_tri, 2] < 0)
    np.testing.assert_allclose(np.cross(locations - origins, directions), 0, atol=1e-14)
    planes = np.sum(sphere.face_normals[index_tri] * (locations - sphere.triangles[index_tri, 0]), axis=1)
    np.testing.assert_allclose(planes, 0, atol=1e-14)
    for i in range(8):
        alone = ray.intersects_location(origins[[i]], directions[[i]], multiple_hits=False)
        np.testing.assert_array_equal(alone[0][0], locations[i])
        assert alone[2][0] == index_tri[i]


def test_points_inside_are_told():
    sphere = icosphere(subdivisions=4)
    points = np.random.default_rng(2).uniform(-1, 1, (2000, 3))
    radius = np.linalg.norm(points, axis=1)
    inscribed = np.linalg.norm(sphere.triangles_center, axis=1).min()
    clear = (radius < inscribed * 0.999) | (radius > 1.001)
    inside = RayMeshIntersector(sphere).contains_points(points)
    np.testing.assert_array_equal(inside[clear], radius[clear] < 1)
    hollow = RayMeshIntersector(box() + icosphere(radius=0.2))
    np.testing.assert_array_equal(hollow.contains_points([[0, 0, 0], [0.4, 0, 0]]), [False, True])


def test_a_hair_above_a_surface_far_from_the_origin_is_above_it():
    wall = trimesh.Trimesh(
        [
            [528980.85, 183526.1, 0],
            [528980.85, 183526.1, 3],
            [528982.3, 183523.55, 0],
            [528982.3, 183523.55, 3],
        ],
        [[1, 0, 2], [1, 2, 3]],
        process=False,
    )
    weights = np.random.default_rng(3).dirichlet([1, 1, 1], 200)
    normals = np.repeat(wall.face_normals[:1], len(weights), 0)
    above = weights @ wall.triangles[0] + 0.001 * normals
    ray = RayMeshIntersector(wall, scale_to_box=False)
    assert not ray.intersects_any(above, normals).any()
    assert ray.intersects_any(above, -normals).all()


def test_rays_in_the_plane_of_a_mesh_hit_nothing():
    flat = trimesh.Trimesh(
        [[0, 0, 0], [1, 0, 0], [1, 3, 0], [0, 3, 0]], [[0, 1, 2], [0, 2, 3]], process=False
    )
    for several in True, False:
        locations, index_ray, index_tri = RayMeshIntersector(flat).intersects_location(
            [[-5, 1, 0]], [[1, 0, 0]], multiple_hits=several
        )
        assert (locations.shape, index_ray.shape, index_tri.shape) == ((0, 3), (0,), (0,))


def test_meshes_that_change_are_traced_as_they_are():
    mesh = box()
    ray = mesh.ray = RayMeshIntersector(mesh)
    for height in 1, 5, 2:
        mesh.vertices = box(extents=[1, 1, height]).vertices
        np.testing.assert_allclose(
            ray.intersects_location([[0.1, 0.2, 9]], DOWN)[0][0], [0.1, 0.2, height / 2]
        )
        assert not ray.intersects_any([[0.6, 0, 9]], DOWN)[0]
    index_tri = ray.intersects_first([[0.1, 0.2, 9]], DOWN)[0]
    mesh.faces = mesh.faces[::-1]
    assert ray.intersects_first([[0.1, 0.2, 9]], DOWN)[0] == 11 - index_tri
    mesh.update_faces(mesh.face_normals[:, 2] < 0.5)
    np.testing.assert_allclose(ray.intersects_location([[0.1, 0.2, 9]], DOWN)[0], [[0.1, 0.2, -1]])


def test_copies_have_the_same_mesh():
    ray = RayMeshIntersector(box(), scale_to_box=False)
    for other in copy.copy(ray), copy.deepcopy(ray), pickle.loads(pickle.dumps(ray)):
        assert other.intersects_any([[0, 0, 2]], DOWN)[0]
        assert not other._is_scaled
        assert other._scene._mesh.geometry.triangle_count == 12


def test_what_does_not_fit_is_refused():
    ray = RayMeshIntersector(box())
    with pytest.raises(ValueError, match=r"ray_directions has shape \(1, 3\), must be \(2, 3\)"):
        ray.intersects_any(np.zeros((2, 3)), DOWN)
    with pytest.raises(ValueError, match=r"points has shape \(3,\), must be \(n, 3\)"):
        ray.contains_points([0, 0, 0])
    with pytest.raises(TypeError, match="ray_origins has dtype complex128"):
        ray.intersects_first(np.zeros((1, 3), complex), DOWN)
    assert ray.intersects_first([[9, 9, 9]], DOWN).tolist() == [-1]
