// gltf_lights.cpp - lights and cameras, each at the origin of its node and along -z.
#include "import/gltf/gltf_lights.hpp"

#include <fmt/format.h>

namespace render {
namespace {

constexpr double kPi = 3.14159265358979323846;

Light light_of(const tinygltf::Light& light) {
    Light l;
    const bool is_directional = light.type == "directional";
    l.kind = is_directional         ? RSH_LIGHT_DIRECTIONAL
             : light.type == "spot" ? RSH_LIGHT_SPOT
                                    : RSH_LIGHT_POINT;
    l.direction = {0.0f, 0.0f, -1.0f};
    if (light.color.size() == 3)
        l.colour = glm::vec3(light.color[0], light.color[1], light.color[2]);
    l.colour *= static_cast<float>(light.intensity / kPi);
    if (!is_directional) l.attenuation = {0.0f, 0.0f, 1.0f};
    l.inner_degrees = static_cast<float>(glm::degrees(light.spot.innerConeAngle));
    l.outer_degrees = static_cast<float>(glm::degrees(light.spot.outerConeAngle));
    return l;
}

// -1: the node has none.
int light_index(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_lights_punctual");
    return found == node.extensions.end() ? -1 : found->second.Get("light").GetNumberAsInt();
}

void read_light(GltfDocument& document, uint32_t node, GltfScene& scene) {
    const int index = light_index(document.model.nodes[node]);
    if (index < 0) return;
    const tinygltf::Light& light = document.model.lights[static_cast<size_t>(index)];
    scene.lights.push_back({light_of(light), node});
    if (light.range > 0.0)
        document.warnings.push_back(fmt::format(
            "{}: extensions.KHR_lights_punctual.lights[{}].range {} is ignored: the "
            "light goes on",
            document.location, index, light.range));
}

void read_camera(GltfDocument& document, uint32_t node, GltfScene& scene) {
    const int index = document.model.nodes[node].camera;
    if (index < 0) return;
    const tinygltf::Camera& camera = document.model.cameras[static_cast<size_t>(index)];
    if (camera.type != "perspective") {
        document.warnings.push_back(
            fmt::format("{}: cameras[{}]: is {}, which is left out: must be perspective",
                        document.location, index, camera.type));
        return;
    }
    if (scene.camera) return;
    GltfCamera found{Camera(), node};
    found.camera.vertical_degrees = static_cast<float>(glm::degrees(camera.perspective.yfov));
    found.camera.near = static_cast<float>(camera.perspective.znear);
    scene.camera = found;
}

}  // namespace

void read_lights_and_camera(GltfDocument& document, const std::vector<bool>& is_in_scene,
                            GltfScene& scene) {
    for (uint32_t node = 0; node < is_in_scene.size(); ++node) {
        if (!is_in_scene[node]) continue;
        read_light(document, node, scene);
        read_camera(document, node, scene);
    }
}

}  // namespace render
