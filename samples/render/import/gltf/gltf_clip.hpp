// gltf_clip.hpp - one animation of a glTF file as curves.
#pragma once

#include "import/gltf/file/accessor.hpp"
#include "import/gltf/gltf_scene.hpp"

namespace render {

// Which animation plays: that of the name, or of the number; empty: the first, and a warning where
// there are several. Nothing: the file has none. Throws an error for one that it does not have.
std::optional<size_t> choose_clip(GltfDocument& document, const std::string& clip);

// The curves of scene.nodes. `targets`: morph targets of each node's mesh.
std::vector<GltfCurve> read_clip(const GltfDocument& document, size_t clip,
                                 const GltfScene& scene, const std::vector<size_t>& targets);

}  // namespace render
