"""rsh_as_ray.py - a plugin of pytest: trimesh's ray objects, with and without Embree, are rsh's."""
import rsh.trimesh
import trimesh.ray.ray_pyembree
import trimesh.ray.ray_triangle

for module in (trimesh.ray.ray_pyembree, trimesh.ray.ray_triangle):
    module.RayMeshIntersector = rsh.trimesh.RayMeshIntersector
