// schema.hpp - the members of a glTF file's JSON that rsh-render reads, but for buffers, views and
// accessors: their types, their ranges, and whether each index names something that is there.
#pragma once

#include "import/gltf/file/indices.hpp"

namespace render {

// Throws an error that names the member, what was found and what is allowed.
void check_schema(const JsonValue& document, const GltfIndices& indices);

}  // namespace render
