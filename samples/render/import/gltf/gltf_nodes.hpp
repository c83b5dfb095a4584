// gltf_nodes.hpp - the nodes of a glTF file as trees, and the joints of its skins.
#pragma once

#include "import/gltf/file/accessor.hpp"
#include "import/gltf/gltf_scene.hpp"

namespace render {

// Fills nodes and order. Throws an error for a node with two parents or that is its own ancestor.
void read_nodes(const GltfDocument& document, GltfScene& scene);

// Whether a node is in the file's scene: the one that it names, else its first, else all nodes.
std::vector<bool> nodes_of_scene(const GltfDocument& document, const GltfScene& scene);

void read_skins(const GltfDocument& document, GltfScene& scene);

}  // namespace render
