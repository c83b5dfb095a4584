// moments.cpp - what rsh-render renders at some times, for aff_check.py:
//   rsh_moments SCENE OUT TIME...
// OUT gets, for each time in turn, little-endian floats: the camera's eye, the place it looks at and its
// up; then the number of lights, and of each its position and colour; then the number of triangles, and
// of each its three corners, then their three normals (0: flat).
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "scene/scene_file.hpp"
#include "scene/world.hpp"

namespace {

class Writer {
public:
    explicit Writer(const char* path) : out_(path, std::ios::binary) {}

    void write(float value) { out_.write(reinterpret_cast<const char*>(&value), sizeof value); }
    void write(size_t count) { write(static_cast<float>(count)); }
    void write(const glm::vec3& v) {
        for (int i = 0; i < 3; ++i) write(v[i]);
    }
    bool is_good() const { return bool(out_); }

private:
    std::ofstream out_;
};

void write_moment(const render::World& world, Writer& out) {
    const render::Camera& camera = world.camera();
    for (const glm::vec3& v : {camera.eye, camera.at, camera.up}) out.write(v);
    out.write(world.lights().size());
    for (const render::Light& light : world.lights()) {
        out.write(light.position);
        out.write(light.colour);
    }
    const render::Mesh& mesh = world.mesh();
    std::vector<glm::uvec3> triangles(mesh.triangles.size());  // in the order of the files
    for (size_t i = 0; i < triangles.size(); ++i)
        triangles[world.triangle_number(i)] = mesh.triangles[i];
    out.write(triangles.size());
    for (const glm::uvec3& triangle : triangles) {
        for (int i = 0; i < 3; ++i) out.write(mesh.positions[triangle[i]]);
        for (int i = 0; i < 3; ++i)
            out.write(mesh.normals.empty() ? glm::vec3(0.0f) : mesh.normals[triangle[i]]);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) {
        std::fprintf(stderr, "usage: rsh_moments SCENE OUT TIME...\n");
        return 2;
    }
    try {
        render::World world(render::read_scenes({argv[1]}));
        Writer out(argv[2]);
        for (int i = 3; i < argc; ++i) {
            world.move_to(std::atof(argv[i]));
            write_moment(world, out);
        }
        return out.is_good() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rsh_moments: %s\n", error.what());
        return 1;
    }
}
