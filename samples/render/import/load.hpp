// load.hpp - every way to get a model or an animation from files. All paths are as in
// asset.hpp; all functions throw LoadError (text_scan.hpp) and are to be called from one thread
// at a time.
#pragma once

#include <memory>
#include <string>

#include "model/model.hpp"

namespace render {

// OBJ with MTL, PLY, OFF, STL; see mesh_file.hpp.
Model load_mesh(const std::string& path);

// A scene of the BART benchmark (AFF); see aff_animation.hpp.
std::unique_ptr<Animation> load_aff(const std::string& path);

// Positions per frame over the topology of `mesh`; see vertex_frames.hpp. An empty `json` means
// the file beside `frames` that differs in its extension only.
std::unique_ptr<Animation> load_vertex_frames(const std::string& mesh,
                                              const std::string& frames,
                                              const std::string& json = "");

}  // namespace render
