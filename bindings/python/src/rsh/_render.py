"""Pictures by rsh_frame."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pyopencl.array as cla
from numpy.typing import ArrayLike, NDArray

from rsh._arrays import on_host, require
from rsh.calls import find_features, frame
from rsh.constants import LIGHT_DIRECTIONAL, NO_TEXTURE
from rsh.scene import Scene
from rsh.structs import Camera, Light, Material
from rsh.structs import Scene as SceneStruct


def look_at(eye: ArrayLike, target: ArrayLike, up: ArrayLike = (0, 0, 1), fov_deg: float = 60.0) -> Camera:
    """Make a camera for square pictures; `render` widens it.

    Parameters
    ----------
    eye, target, up : array_like, (3,)
        Where it is, what is in the middle of the picture, and what is upwards, in world units.
    fov_deg : float, optional
        The field of view from the lower to the upper edge.

    Returns
    -------
    Camera

    Raises
    ------
    ValueError
        `up` goes the same way as the view.
    """
    place, middle, upwards = (np.asarray(vector, np.float64) for vector in (eye, target, up))
    forward = middle - place
    right = np.cross(forward, upwards)
    above = np.cross(right, forward)
    if not np.linalg.norm(above) > 0:
        raise ValueError(f"up is {upwards}, must have another direction than target - eye, {forward}")
    half = np.tan(np.deg2rad(fov_deg) / 2)
    right, above = (half * axis / np.linalg.norm(axis) for axis in (right, above))
    return Camera(eye=place, forward=forward / np.linalg.norm(forward), right=right, up=above)


def render(
    scene: Scene,
    camera: Camera,
    width: int = 512,
    height: int = 512,
    *,
    materials: NDArray[Any] | None = None,
    material_ids: ArrayLike | None = None,
    lights: NDArray[Any] | None = None,
    ambient: Sequence[float] = (0.2, 0.2, 0.2),
    environment: Sequence[float] = (0, 0, 0),
    bounces: int = 4,
    tolerance: float = 0,
    progress: Callable[[int, int], object] | None = None,
) -> NDArray[np.float32]:
    """Render a picture with Whitted's reflections, refractions and shadows; BLOCKS.

    Parameters
    ----------
    scene : Scene
    camera : Camera
        As of `look_at`; its right is made longer as the picture is wider.
    width, height : int, optional
        Pixels.
    materials : ndarray of numpy.dtype(rsh.structs.Material), optional
        Else one that is white and dull.
    material_ids : array_like, (faces,), optional
        Which material each face has; else the first one.
    lights : ndarray of numpy.dtype(rsh.structs.Light), optional
        Else a white one from behind the camera, without shadows.
    ambient, environment : sequence of 3 floats, optional
        Linear colours of the light from everywhere, and of what rays see that hit nothing.
    bounces : int, optional
        The longest chain of reflections and refractions.
    tolerance : float, optional
        Above 0 the picture is approximate: a pixel between others that look alike but for so much, 0.01
        say, gets their colour. See rsh_frame in rsh.h.
    progress : callable, optional
        Is called before each wave of rays, as by rsh_frame; `rsh.progress.Bar` is one.

    Returns
    -------
    ndarray, (height, width, 4), float32
        Linear red, green and blue; the last is 1 where there is a triangle, else 0.

    Raises
    ------
    TypeError, ValueError
        An array has another type or shape.
    """
    widened = camera.copy()
    for axis in range(3):
        widened.right[axis] *= width / height
    materials = _white() if materials is None else materials
    lights = _lamp(camera) if lights is None else lights
    struct = SceneStruct(
        geometry=scene._mesh.geometry,
        materials=_sent(scene, materials),
        material_count=len(materials),
        light_count=len(lights),
        ambient=ambient,
        environment=environment,
    )
    if len(lights):
        struct.lights = _sent(scene, lights)
    if material_ids is not None:
        ids = on_host("material_ids", material_ids, np.uint32)
        count = scene._mesh.geometry.triangle_count
        require(ids.shape == (count,), "material_ids", ids, f"({count},)")
        struct.material_ids = _sent(scene, ids)
    find_features(struct, materials, lights)
    colour = cla.zeros(scene.queue, (height, width, 4), np.float32)
    waits = [*scene._mesh.events(), *colour.events]
    frame(
        scene.context,
        scene.queue,
        scene=struct,
        camera=widened,
        width=width,
        height=height,
        bounces=bounces,
        tolerance=tolerance,
        colour=colour,
        progress=progress,
        wait_for=waits,
    ).wait()
    picture: NDArray[np.float32] = colour.get(scene.queue)
    return picture


def _sent(scene: Scene, array: NDArray[Any]) -> cla.Array:
    return cla.to_device(scene.queue, np.ascontiguousarray(array))


def _white() -> NDArray[Any]:
    material = np.zeros(1, np.dtype(Material))
    material["ambient"][:, :3] = material["diffuse"][:, :3] = 0.8
    material["texture"] = NO_TEXTURE
    return material


def _lamp(camera: Camera) -> NDArray[Any]:
    light = np.zeros(1, np.dtype(Light))
    light["direction"] = camera.forward
    light["colour"][:, :3] = 1
    light["kind"] = LIGHT_DIRECTIONAL
    return light
