// ranges.hpp - whether what a glTF file says of its buffers, views and accessors lies within the
// bytes that it promises. Looks at its JSON alone.
#pragma once

#include "import/gltf/file/indices.hpp"

namespace render {

// `binary_bytes`: of the chunk that a buffer without an URI is in; 0: there is none. Throws an error
// that names the member, what it asks for and what is there.
void check_ranges(const JsonValue& document, const GltfIndices& indices, size_t binary_bytes);

}  // namespace render
