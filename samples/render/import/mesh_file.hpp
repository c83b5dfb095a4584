// mesh_file.hpp - OBJ (with MTL), PLY, OFF and STL files -> a model, through OpenMesh's readers
// (STL: see stl_file.hpp). Reads no image: textures stay paths.
//
// What the model lacks of what the file promised is in Model::warnings (faces with an index out
// of range, missing materials, ...). A file that cannot be read as its header says throws
// LoadError, which names the file, what it holds and what was promised.
//
// Threads: OpenMesh's readers keep state; one load at a time.
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
