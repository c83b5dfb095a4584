// vertex_frames.hpp - a mesh whose vertices move from frame to frame, read from raw positions:
// little-endian float32 [frame][vertex][x, y, z] in the vertex order of the mesh file, beside a
// JSON object with frames, vertices, triangles, time_start and time_end. Linear between frames;
// the time is clamped, not repeated.
#pragma once

#include <memory>
#include <string>

#include "model/model.hpp"

namespace render {

// Positions per frame over the topology of `mesh`; an empty `json` means the file beside `frames`
// that differs in its extension only. Paths as in asset.hpp. Throws LoadError.
std::unique_ptr<Animation> load_vertex_frames(const std::string& mesh,
                                              const std::string& frames,
                                              const std::string& json = "");

}  // namespace render
