// plain_mesh.hpp - a mesh file brought into the plain form that OpenMesh 9 reads as its author
// meant it, with what the file promises. Each plain_...() checks its format's header against
// the size of the file first, so that no promise is believed that the file cannot hold.
//
// Why at all: OpenMesh reads the values, but (tests/render/openmesh_findings_test.cpp)
//   OBJ  leaves out vertices it cannot parse (nan), which shifts all indices behind them; drops
//        repeated indices and with them triangles; knows a material only by its colour
//   OFF  accepts no comments, and believes any count in the header
//   PLY  skips face properties in front of the indices and halves the faces; needs
//        Options::Custom for a list behind them; refuses nan, and lists counted by other types
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace render {

// In face_materials: a face before the first usemtl.
constexpr uint32_t kNoMaterial = 0xffffffffu;

struct PlainMesh {
    std::string format;  // extension under which OpenMesh knows the text
    std::string text;
    size_t vertices = 0;  // what the reader has to deliver
    size_t faces = 0;
    bool has_normals = false;
    bool has_texcoords = false;
    // Coordinates that the plain form cannot carry (nan, inf, beyond a float's normal range)
    // and the vertices they belong to.
    std::vector<std::pair<uint32_t, glm::vec3>> special_positions;
    std::vector<uint32_t> face_materials;  // one per face, indices into material_names; or none
    std::vector<std::string> material_names;
    std::vector<std::string> material_files;
    std::string texture;  // of a file without materials
    std::vector<std::string> warnings;
};

// `name` starts every message. The functions throw LoadError.
PlainMesh plain_obj(const std::string& bytes, const std::string& name);
PlainMesh plain_off(const std::string& bytes, const std::string& name);
PlainMesh plain_ply(const std::string& bytes, const std::string& name);

// True of numbers that std::istream refuses or rounds differently: nan, inf, beyond a float's
// normal range.
bool is_special(double value);

// Appends "x y z\n" to `text`; a coordinate that istream would refuse goes to special_positions
// as that of vertex `index`.
void append_position(PlainMesh& plain, uint32_t index, const std::string_view (&tokens)[3],
                     const std::string& where);

}  // namespace render
