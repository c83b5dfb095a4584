// device_structs.cpp - field by field into the structs of rsh_types.h.
#include "scene/device_structs.hpp"

#include <cmath>

namespace render {

rsh_float4 device_vector(glm::vec3 xyz, float w) {
    return {{xyz.x, xyz.y, xyz.z, w}};
}

rsh_material device_material(const Material& material, uint32_t texture) {
    rsh_material m{};
    m.ambient = device_vector(material.ambient);
    m.diffuse = device_vector(material.diffuse);
    m.specular = device_vector(material.specular, material.shininess);
    m.reflection = device_vector(material.reflection);
    m.transmission = device_vector(material.transmission, material.ior);
    m.emission = device_vector(material.emission);
    m.texture = texture;
    return m;
}

rsh_light device_light(const Light& light) {
    rsh_light l{};
    l.position = device_vector(light.position);
    l.direction = device_vector(glm::normalize(light.direction));
    l.colour = device_vector(light.colour);
    l.attenuation = device_vector(light.attenuation);
    l.cos_inner = std::cos(glm::radians(light.inner_degrees));
    l.cos_outer = std::cos(glm::radians(light.outer_degrees));
    l.kind = light.kind;
    l.casts_shadow = light.casts_shadow;
    return l;
}

rsh_camera device_camera(const Camera& camera, float aspect) {
    const glm::vec3 forward = glm::normalize(camera.at - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const float half_height = std::tan(0.5f * glm::radians(camera.vertical_degrees));
    rsh_camera c{};
    c.eye = device_vector(camera.eye, camera.near);
    c.forward = device_vector(forward);
    c.right = device_vector(half_height * aspect * right);
    c.up = device_vector(half_height * glm::cross(right, forward));
    return c;
}

}  // namespace render
