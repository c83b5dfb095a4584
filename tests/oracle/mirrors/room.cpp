// room.cpp - icospheres by halving edges.
#include "oracle/mirrors/room.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace oracle {
namespace {

using test::Double3;
using test::Float3;
using test::Mesh;

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

// 20 * 4^level triangles, counter-clockwise from outside, corners on the sphere around 0.
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

void add(const Mesh& sphere, const std::vector<Float3>& normals, MirrorRoom* room) {
    const uint32_t first = uint32_t(room->mesh.vertices.size());
    for (const Float3& vertex : sphere.vertices) room->mesh.vertices.push_back(vertex);
    for (const uint32_t index : sphere.indices) room->mesh.indices.push_back(first + index);
    for (const Float3& normal : normals) room->normals.push_back(normal);
}

bool is_between_spheres(Float3 point) {
    bool is_free = length(point) < 0.9f;
    for (const Sphere& sphere : kInner)
        is_free &= length(point - sphere.centre) > 1.1f * sphere.radius;
    return is_free;
}

}  // namespace

MirrorRoom mirror_room(uint32_t level, bool is_smooth) {
    const Mesh unit = icosphere(level);
    const std::vector<Float3> normals = is_smooth ? unit.vertices : std::vector<Float3>();
    MirrorRoom room;
    add(unit, normals, &room);
    for (const Sphere& sphere : kInner)
        add(scaled(unit, sphere.radius, sphere.centre), normals, &room);
    return room;
}

bool faces_the_room(const MirrorRoom& room, uint32_t triangle) {
    return triangle >= room.mesh.triangle_count() / (1 + std::size(kInner));
}

rsh_material mirror_material() {
    rsh_material mirror = {};
    mirror.reflection = {{1, 1, 1, 0}};
    mirror.texture = RSH_NO_TEXTURE;
    return mirror;
}

std::vector<rsh_ray> rays_in_mirror_room(test::Random& random, uint32_t count) {
    std::vector<rsh_ray> rays;
    while (rays.size() < count) {
        const Float3 origin = random.in_cube();
        if (is_between_spheres(origin))
            rays.push_back(test::make_ray(origin, normalize(random.direction())));
    }
    return rays;
}

}  // namespace oracle
