// mtl_file.hpp - Wavefront material libraries -> materials, through tinyobjloader.
//
// How the terms of MTL become those of the renderer:
//   Ka Kd Ks Ns Ke map_Kd   ambient, diffuse, specular, shininess, emission, texture
//   illum 0, 1              no highlight, whatever Ks is
//   illum 3, 5              reflection = Ks (a mirror in the colour of its highlight)
//   d < 1 (Tr > 0)          transmission = 1 - d, and ior = 1: see-through. With illum 4, 6, 7, 9
//                           the colour Tf filters it, and with 6, 7 it refracts: ior = Ni
//   neither d nor Tr        opaque; but with illum 6, 7 and an index Ni other than 1 it is glass:
//                           transmission = Tf, or white without it
// So the number of the illumination model never makes transparent what d calls opaque, nor does Tf
// alone: many exporters write both beside every material. d wins over Tr where a file has both.
//
// Options of map_Kd: -s and -o scale and shift texture coordinates, to s * uv + o; -clamp on shows
// the edge of the picture outside of 0..1. Those that would change the picture otherwise are
// warned of, as are numbers that are none. Other maps and terms are ignored.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace render {

// Adds the materials in `text`, read from `location`, by name; the first definition of a name
// stays. Textures are looked for as in references.hpp.
void read_mtl(const std::string& text, const std::string& location,
              std::map<std::string, Material>& materials, std::vector<std::string>& warnings);

}  // namespace render
