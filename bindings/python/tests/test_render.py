"""render and look_at against what is easily said of a picture."""

import numpy as np
import pytest

import rsh
from rsh.__main__ import sheet
from rsh.structs import Light, Material


@pytest.fixture(scope="module")
def scene():
    return rsh.Scene(*sheet(20, 0))


def test_pixels_see_what_their_rays_hit(scene):
    camera = rsh.look_at([0.3, -2, 1], [0, 0, 0], fov_deg=50)
    picture = rsh.render(scene, camera, 90, 60)
    assert (picture.shape, picture.dtype) == ((60, 90, 4), np.float32)
    x, y = np.meshgrid((np.arange(90) + 0.5) / 45 - 1, 1 - (np.arange(60) + 0.5) / 30)
    forward, right, up = (np.array(list(axis)[:3]) for axis in (camera.forward, camera.right, camera.up))
    directions = forward + 1.5 * x[..., None] * right + y[..., None] * up
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    hits = rsh.Scene(*sheet(20, 0)).closest(rsh.make_rays([0.3, -2, 1], directions), normal=True)
    is_hit = hits.primitive != rsh.NO_HIT
    assert np.mean((picture[..., 3] == 1) != is_hit) < 0.002
    seen = is_hit & (picture[..., 3] == 1)
    assert 0.2 < seen.mean() < 0.9
    light = 0.2 * 0.8 + 0.8 * np.abs(hits.normal[seen] @ forward)
    assert np.quantile(np.abs(picture[seen][:, 0] - light), 0.99) < 1e-5
    assert np.all(picture[~is_hit & (picture[..., 3] == 0)] == 0)


def test_the_middle_of_the_picture_is_the_target_and_up_is_up():
    triangle = np.array([[-1, 0, -1], [1, 0, -1], [0, 0, 3]], float)
    for up in (0, 0, 1), (0, 0, 5):
        picture = rsh.render(rsh.Scene(triangle), rsh.look_at([0, -4, 1], [0, 0, 1], up), 65, 65)
        widths = picture[..., 3].sum(1)
        assert widths[widths > 0][0] < widths[widths > 0][-1]
        np.testing.assert_array_equal(picture[..., 3], picture[:, ::-1, 3])
    with pytest.raises(ValueError, match="up is .*, must have another direction than target - eye"):
        rsh.look_at([0, 0, 0], [0, 0, 1])


def test_materials_lights_and_mirrors(scene):
    materials = np.zeros(2, np.dtype(Material))
    materials["texture"] = rsh.NO_TEXTURE
    materials["emission"][0, :3] = (0, 1, 0)
    materials["reflection"][1, :3] = 1
    faces = np.arange(800) % 2
    camera = rsh.look_at([0, -0.2, 2], [0, 0, 0])
    none = np.zeros(0, np.dtype(Light))
    asked = {"materials": materials, "material_ids": faces, "lights": none, "environment": (0, 0, 3)}
    colours = np.unique(rsh.render(scene, camera, 64, 64, **asked)[..., :3].reshape(-1, 3), axis=0)
    assert {(0, 1, 0), (0, 0, 3)} <= set(map(tuple, colours))
    dark = rsh.render(scene, camera, 64, 64, **asked, bounces=0)
    assert np.any(np.all(dark == [0, 0, 0, 1], axis=-1))
    with pytest.raises(ValueError, match=r"material_ids has shape \(3,\), must be \(800,\)"):
        rsh.render(scene, camera, materials=materials, material_ids=[0, 1, 1])
    with pytest.raises(TypeError, match="lights must be a NumPy array of dtype"):
        rsh.render(scene, camera, lights=np.zeros(1))


def test_an_approximate_picture_is_nearly_the_exact_one(scene):
    materials = np.zeros(1, np.dtype(Material))
    materials["texture"] = rsh.NO_TEXTURE
    materials["diffuse"][0, :3] = 0.5
    materials["reflection"][0, :3] = 0.5
    camera = rsh.look_at([0.3, -2, 1], [0, 0, 0])
    asked = {"materials": materials, "environment": (0.1, 0.2, 0.3)}
    exact = rsh.render(scene, camera, 128, 96, **asked)
    near = rsh.render(scene, camera, 128, 96, **asked, tolerance=0.02)
    np.testing.assert_array_equal(near[::4, ::4], exact[::4, ::4])
    differs = np.any(near != exact, axis=-1)
    assert 0.01 < differs.mean() < 0.75
    assert np.quantile(np.abs(near - exact), 0.99) < 0.05
    with pytest.raises(rsh.Error, match="tolerance: is nan, must be finite, not negative"):
        rsh.render(scene, camera, 8, 8, **asked, tolerance=float("nan"))
