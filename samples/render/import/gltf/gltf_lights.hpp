// gltf_lights.hpp - cameras and KHR_lights_punctual of a glTF file.
//
// A light's intensity is that of glTF: candela for points and spots, lux for directions. Whitted's
// diffuse surface sends out colour * diffuse * cosine, glTF's 1 / pi of it, so the colour becomes
// colour * intensity / pi; it falls off by the square of the distance. Between a spot's cones the
// renderer goes by smoothstep. The range of a light is a hint and is ignored.
#pragma once

#include <vector>

#include "import/gltf/file/document.hpp"
#include "import/gltf/gltf_scene.hpp"

namespace render {

// The lights of the scene's nodes, and the first perspective camera in the order of the nodes.
void read_lights_and_camera(GltfDocument& document, const std::vector<bool>& is_in_scene,
                            GltfScene& scene);

}  // namespace render
