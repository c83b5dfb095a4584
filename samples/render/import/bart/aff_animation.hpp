// aff_animation.hpp - scenes of the BART benchmark (AFF): camera, lights, transforms and morphing
// triangles at any time, over one topology. What is invisible collapses into a point.
#pragma once

#include <memory>
#include <string>

#include "model/model.hpp"

namespace render {

// `path` as in asset.hpp. Throws LoadError.
std::unique_ptr<Animation> load_aff(const std::string& path);

}  // namespace render
