// gltf_animation.hpp - glTF 2.0 files (.gltf and .glb): triangles, nodes, skins, morph targets,
// materials, lights and a camera, at any time of one of their clips. Reads no image: textures stay
// paths, or the bytes that the file holds.
//
// Ignored with a warning: points and lines, vertex colours, textures other than that of the base
// colour, orthographic cameras, the range of lights, and extensions that gltf/file/document.cpp does
// not know.
#pragma once

#include <memory>
#include <string>

#include "model/model.hpp"

namespace render {

// `path` as in asset.hpp. `clip`: the name of an animation of the file, or its number; empty: the
// first. Throws std::runtime_error, which names the member, what it is and what it must be.
std::unique_ptr<Animation> load_gltf(const std::string& path, const std::string& clip = "");

}  // namespace render
