// gltf_vertices.cpp - the vertices of a glTF file at some times, as rsh-render's loader places them, for
// gltf_check.py:
//   rsh_gltf_vertices FILE CLIP OUT TIME...
// OUT gets, for each time, the positions of all vertices, then their normals if the file has any: three
// little-endian floats each. CLIP may be empty.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "import/gltf/gltf_animation.hpp"

namespace {

void write(std::ofstream& out, const std::vector<glm::vec3>& vectors) {
    out.write(reinterpret_cast<const char*>(vectors.data()),
              static_cast<std::streamsize>(vectors.size() * sizeof(glm::vec3)));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        std::fprintf(stderr, "usage: rsh_gltf_vertices FILE CLIP OUT TIME...\n");
        return 2;
    }
    try {
        const auto animation = render::load_gltf(argv[1], argv[2]);
        std::ofstream out(argv[3], std::ios::binary);
        for (int i = 4; i < argc; ++i) {
            const render::Mesh mesh = animation->at(std::atof(argv[i])).mesh;
            write(out, mesh.positions);
            write(out, mesh.normals);
        }
        return out ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rsh_gltf_vertices: %s\n", error.what());
        return 1;
    }
}
