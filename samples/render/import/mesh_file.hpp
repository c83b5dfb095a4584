// mesh_file.hpp - OBJ (with MTL), PLY, OFF and STL files -> a model. Reads no image: textures stay
// paths.
//
// What the model lacks of what the file promised is in Model::warnings (faces with an index out
// of range, missing materials, ...). A file that cannot be read as its header says throws
// LoadError, which names the file, what it holds and what was promised.
//
// OBJ and MTL are read by tinyobjloader, the others by readers of our own. OpenMesh 9 has readers,
// but they shift indices behind a nan, drop triangles with repeated corners, believe any count of a
// header, accept no comments in OFF, and halve the faces of a PLY file with another face property
// (tests/render/import/openmesh_findings_test.cpp).
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"

namespace render {

// `path` as in asset.hpp.
Model load_mesh(const std::string& path);

// The same with the file's number of each vertex, for attributes that a second file stores.
struct NumberedModel {
    Model model;
    std::vector<uint32_t> source;
    size_t file_vertices = 0;
};
NumberedModel load_numbered_mesh(const std::string& path);

}  // namespace render
