// document.hpp - a .gltf or .glb file, read by tinygltf after its JSON has been checked: in what this
// hands out, every index names something, and every accessor lies within its bytes.
//
// tinygltf 2.7 takes a member of another type for one that is missing, reads up to 8 bytes behind
// a .glb file whose chunk BIN promises them, and does not look where an image's view lies.
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <vector>

namespace render {

struct GltfDocument {
    std::string location;  // of the file, the start of messages
    // Images that the file holds are in Image::image as the file encodes them.
    tinygltf::Model model;
    std::vector<std::string> warnings;
};

// `path` as in asset.hpp. Reads the files of buffers, but none of images. Throws std::runtime_error,
// also for a file that requires an extension that is not known.
GltfDocument read_gltf_document(const std::string& path);

}  // namespace render
