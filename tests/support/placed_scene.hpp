// placed_scene.hpp - a scene of the tests as an rsh_scene, in buffers that the caller makes and keeps.
#pragma once

#include <rsh/rsh.h>

#include "support/scene.hpp"

namespace test {

// upload: makes a cl_mem of a vector, NULL of an empty one. Features are left to rsh_find_features.
template <class Upload>
rsh_scene placed(const Scene& scene, const Upload& upload) {
    const auto rgb = [](Float3 c) { return rsh_float4{{c.x, c.y, c.z, 0}}; };
    rsh_scene made = {};
    made.struct_size = sizeof made;
    made.geometry.vertices = upload(scene.mesh.vertices);
    made.geometry.vertex_count = cl_uint(scene.mesh.vertices.size());
    made.geometry.indices = upload(scene.mesh.indices);
    made.geometry.triangle_count = scene.mesh.triangle_count();
    made.normals = upload(scene.normals);
    made.texcoords = upload(scene.texcoords);
    made.material_ids = upload(scene.material_ids);
    made.materials = upload(scene.materials);
    made.material_count = cl_uint(scene.materials.size());
    made.lights = upload(scene.lights);
    made.light_count = cl_uint(scene.lights.size());
    made.textures = upload(scene.textures);
    made.texture_count = cl_uint(scene.textures.size());
    made.texels = upload(scene.texels);
    made.ambient = rgb(scene.ambient);
    made.environment = rgb(scene.environment);
    made.environment_texture = scene.environment_texture;
    made.cut = scene.cut;
    return made;
}

}  // namespace test
