// gltf_primitive.hpp - vertices, triangles, morph targets and joints of one primitive of a mesh.
#pragma once

#include "import/gltf/file/accessor.hpp"
#include "import/gltf/gltf_scene.hpp"

namespace render {

// What primitives have and the renderer does not know, of a whole file.
struct GltfLeftOut {
    size_t lines_or_points = 0, colours = 0, without_positions = 0;  // primitives
    size_t without_weight = 0, infinite = 0;                         // vertices
};

// Nothing for points, lines and primitives without positions. `where`: "meshes[0].primitives[1]".
std::optional<GltfPrimitive> read_primitive(const GltfDocument& document,
                                            const tinygltf::Primitive& primitive,
                                            const std::string& where, GltfLeftOut& left_out);

}  // namespace render
