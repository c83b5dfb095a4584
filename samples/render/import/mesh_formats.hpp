// mesh_formats.hpp - one reader for each format of mesh files. `name` starts every message. All
// throw LoadError: for what is no number, for a file that ends early, and for a header that promises
// more than the file can hold. The warnings until then stay in `parsed`, which is empty before.
#pragma once

#include <string>
#include <vector>

#include "model/soup.hpp"

namespace render {

// What a mesh file says, before its material files are read.
struct ParsedMesh {
    Soup soup;
    std::vector<std::string> material_names;  // soup.materials are indices into these
    std::vector<std::string> material_files;  // lines, each of one or several names
    std::string texture;                      // of a file without materials
    std::vector<std::string> warnings;
};

// Wavefront OBJ, through tinyobjloader. Ignores groups, lines, points and free-form surfaces.
void read_obj(const std::string& bytes, const std::string& name, ParsedMesh& parsed);

// Geomview OFF. Text and binary; ignores colours and other attributes, refuses other dimensions
// than three.
void read_off(const std::string& bytes, const std::string& name, ParsedMesh& parsed);

// PLY, with triangle strips, normals and texture coordinates. Ignores other properties and elements.
void read_ply(const std::string& bytes, const std::string& name, ParsedMesh& parsed);

// STL, text and binary. Merges vertices that are equal bit for bit, so that every triangle stays.
void read_stl(const std::string& bytes, const std::string& name, ParsedMesh& parsed);

}  // namespace render
