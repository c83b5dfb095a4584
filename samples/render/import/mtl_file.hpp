// mtl_file.hpp - Wavefront material libraries -> materials, through tinyobjloader.
//
// How the terms of MTL become those of the renderer:
//   Ka Kd Ks Ns Ke map_Kd   ambient, diffuse, specular, shininess, emission, texture
//   illum 3, 5              reflection = Ks (a mirror in the colour of its highlight)
//   illum 4, 6, 7, 9        glass: transmission = Tf, or without it 1 - d, or white if d is 1;
//                           illum 6 and 7 refract with ior = Ni, 4 and 9 let rays pass straight
//   d < 1 (Tr > 0), else    transmission = 1 - d, ior = 1: see-through, not glass. Tf is not
//                           used here, since exporters write it beside every opaque material.
// d wins over Tr where a file has both. Other maps and terms are ignored.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace render {

// Adds the materials in `text`, read from `location`, by name; the first definition of a name
// stays. Textures become paths beside `location`.
void read_mtl(const std::string& text, const std::string& location,
              std::map<std::string, Material>& materials, std::vector<std::string>& warnings);

}  // namespace render
