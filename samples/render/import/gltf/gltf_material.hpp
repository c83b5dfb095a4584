// gltf_material.hpp - a glTF material (metallic and roughness) as one of Whitted's.
//
//   base colour c, metallic m, roughness r, transmission t, index of refraction n
//   mirror share  s = m (1 - r)^2     a polished metal mirrors, a rough one scatters
//   glass share   g = t (1 - m)
//   diffuse       c (1 - s) (1 - g)   the texture multiplies this alone
//   reflection    c s
//   transmission  c g                 with ior n; Fresnel's share is the renderer's
//   f0            ((n - 1) / (n + 1))^2 (1 - m) + c s
//   shininess     e = 2 / r^4 - 2     Blinn-Phong's exponent for GGX of that roughness, 1 to 10^4
//   specular      f0 (e + 8) / 8      Blinn-Phong's lobe with its energy; no channel above 1
//   emission      the emissive factor, without an emissive texture
//
// Alpha blending of a base colour with alpha a is t = 1 - a with n = 1, as `d` of MTL files is. What
// a mirror sees through a rough surface stays sharp: a ray has one direction.
#pragma once

#include "import/gltf/file/document.hpp"
#include "model/model.hpp"

namespace render {

// All of the file's, and behind them glTF's default material. What they want and do not get is a
// warning for each kind.
std::vector<Material> gltf_materials(GltfDocument& document);

// The set of texture coordinates that the base colour's texture wants: "TEXCOORD_0".
std::string gltf_texcoord_name(const tinygltf::Model& model, int material);

}  // namespace render
