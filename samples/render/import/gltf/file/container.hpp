// container.hpp - a .gltf file is JSON, a .glb file holds it in its first chunk. Which of the two it
// is, its first bytes say, not its name.
#pragma once

#include <string>

namespace render {

struct GltfContainer {
    std::string json;
    bool is_binary = false;
    size_t binary_bytes = 0;  // of the second chunk of a .glb
};

// Throws LoadError, which begins with `location`, for a .glb whose header or chunks promise other
// lengths than there are.
GltfContainer open_container(const std::string& bytes, const std::string& location);

}  // namespace render
