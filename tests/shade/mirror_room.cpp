// mirror_room.cpp - icospheres by halving edges.
#include "shade/mirror_room.hpp"

#include <map>

namespace test {
namespace {

struct Sphere {
    Float3 centre;
    float radius;
};

const Sphere kInner[] = {{{0.55f, 0.1f, 0.05f}, 0.25f},
                         {{-0.3f, 0.45f, -0.15f}, 0.2f},
                         {{-0.2f, -0.4f, 0.3f}, 0.3f}};

using Edge = std::pair<uint32_t, uint32_t>;

uint32_t middle(Mesh* mesh, std::map<Edge, uint32_t>* middles, uint32_t a, uint32_t b) {
    const auto found = middles->emplace(std::minmax(a, b), uint32_t(mesh->vertices.size()));
    if (found.second) {
        const Double3 sum = Double3(mesh->vertices[a]) + Double3(mesh->vertices[b]);
        mesh->vertices.push_back(Float3(normalize(sum)));
    }
    return found.first->second;
}

Mesh subdivided(Mesh mesh) {
    std::map<Edge, uint32_t> middles;
    const std::vector<uint32_t> coarse = std::move(mesh.indices);
    mesh.indices.clear();
    for (size_t i = 0; i < coarse.size(); i += 3) {
        const uint32_t a = coarse[i], b = coarse[i + 1], c = coarse[i + 2];
        const uint32_t ab = middle(&mesh, &middles, a, b), bc = middle(&mesh, &middles, b, c),
                       ca = middle(&mesh, &middles, c, a);
        mesh.indices.insert(mesh.indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    return mesh;
}

}  // namespace

Mesh icosphere(uint32_t level) {
    const double g = (1 + std::sqrt(5.0)) / 2;  // corners of three golden rectangles
    Mesh mesh;
    for (const Double3& v :
         {Double3(-1, g, 0), Double3(1, g, 0), Double3(-1, -g, 0), Double3(1, -g, 0),
          Double3(0, -1, g), Double3(0, 1, g), Double3(0, -1, -g), Double3(0, 1, -g),
          Double3(g, 0, -1), Double3(g, 0, 1), Double3(-g, 0, -1), Double3(-g, 0, 1)})
        mesh.vertices.push_back(Float3(normalize(v)));
    mesh.indices = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                    4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                    6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (uint32_t i = 0; i < level; ++i) mesh = subdivided(mesh);
    return mesh;
}

Scene mirror_room(uint32_t level, bool is_smooth) {
    const Mesh unit = icosphere(level);
    Scene scene;
    scene.add(unit, 0, &unit.vertices);
    for (const Sphere& sphere : kInner)
        scene.add(scaled(unit, sphere.radius, sphere.centre), 0, &unit.vertices);
    if (!is_smooth) scene.normals.clear();
    rsh_material mirror = matte({});
    mirror.reflection = {{1, 1, 1, 0}};
    scene.materials = {mirror};
    return scene;
}

bool is_in_mirror_room(Float3 point) {
    bool is_free = length(point) < 0.9f;
    for (const Sphere& sphere : kInner)
        is_free &= length(point - sphere.centre) > 1.1f * sphere.radius;
    return is_free;
}

}  // namespace test
