// device_structs.hpp - materials, lights and cameras as the library's structs. Uploads nothing.
#pragma once

#include <rsh/rsh_types.h>

#include "model/model.hpp"

namespace render {

rsh_float4 device_vector(glm::vec3 xyz, float w = 0.0f);

// `texture` is an index or RSH_NO_TEXTURE.
rsh_material device_material(const Material& material, uint32_t texture);

rsh_light device_light(const Light& light);

// `aspect` is the image's width over its height.
rsh_camera device_camera(const Camera& camera, float aspect);

}  // namespace render
