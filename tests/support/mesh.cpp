// mesh.cpp - the generators of mesh.hpp. Knows no device.
#include "support/mesh.hpp"

#include <algorithm>
#include <limits>

namespace test {
namespace {

constexpr float kPi = 3.14159265f;

Corners degenerate_triangle(Random& random) {
    const Float3 a = random.in_cube(), b = random.in_cube(), c = random.in_cube();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    switch (random.below(9)) {
        case 0:
            return {a, a, b};
        case 1:
            return {a, a, a};
        case 2:
            return {a, b, 0.5f * (a + b)};  // collinear, nearly
        case 3:
            return {a, a + 1e-6f * b, c};  // needle
        case 4:
            return {a, b, a + 0.3f * (b - a) + 1e-6f * c};  // sliver
        case 5:
            return {a, b, Float3(c.x, nan, c.z)};
        case 6:
            return {a, Float3(infinity, b.y, b.z), c};
        case 7:
            return {a, b, Float3(c.x, c.y, -infinity)};
        default:
            return {Float3(a.x, a.y, 0), Float3(b.x, b.y, 0), Float3(c.x, c.y, 0)};
    }
}

}  // namespace

uint32_t Mesh::triangle_count() const {
    return uint32_t((indices.empty() ? vertices.size() : indices.size()) / 3);
}

bool Mesh::corners(uint32_t triangle, Corners* out) const {
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t index = indices.empty() ? 3 * triangle + k : indices[3 * triangle + k];
        if (index >= vertices.size()) return false;
        (*out)[k] = vertices[index];
    }
    return true;
}

void Mesh::add(Float3 a, Float3 b, Float3 c) {
    vertices.insert(vertices.end(), {a, b, c});
}

void add_closed_lattice(Mesh& mesh, uint32_t segments, uint32_t rings) {
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t s = 0; s < segments; ++s) {
            const uint32_t a = r * segments + s, b = r * segments + (s + 1) % segments;
            const uint32_t c = (r + 1) % rings * segments + s;
            const uint32_t d = (r + 1) % rings * segments + (s + 1) % segments;
            mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
        }
}

Mesh random_soup(Random& random, uint32_t count, float size) {
    Mesh mesh;
    for (uint32_t i = 0; i < count; ++i) {
        const Float3 at = random.in_cube();
        mesh.add(at + random.in_cube(size), at + random.in_cube(size),
                 at + random.in_cube(size));
    }
    return mesh;
}

Mesh sphere(uint32_t segments, uint32_t rings, float radius) {
    Mesh mesh;
    mesh.vertices.push_back({0, radius, 0});
    for (uint32_t r = 1; r < rings + 1; ++r)
        for (uint32_t s = 0; s < segments; ++s) {
            const float theta = kPi * float(r) / float(rings + 1);
            const float phi = 2 * kPi * float(s) / float(segments);
            mesh.vertices.push_back({radius * std::sin(theta) * std::cos(phi),
                                     radius * std::cos(theta),
                                     radius * std::sin(theta) * std::sin(phi)});
        }
    mesh.vertices.push_back({0, -radius, 0});
    const uint32_t bottom = uint32_t(mesh.vertices.size()) - 1;
    const auto at = [&](uint32_t r, uint32_t s) { return 1 + r * segments + s % segments; };
    for (uint32_t s = 0; s < segments; ++s) {
        mesh.indices.insert(mesh.indices.end(), {0, at(0, s + 1), at(0, s)});
        mesh.indices.insert(mesh.indices.end(),
                            {bottom, at(rings - 1, s), at(rings - 1, s + 1)});
    }
    for (uint32_t r = 0; r + 1 < rings; ++r)
        for (uint32_t s = 0; s < segments; ++s)
            mesh.indices.insert(mesh.indices.end(),
                                {at(r, s), at(r, s + 1), at(r + 1, s), at(r, s + 1),
                                 at(r + 1, s + 1), at(r + 1, s)});
    return mesh;
}

Mesh torus(uint32_t segments, uint32_t rings, float radius, float tube) {
    Mesh mesh;
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t s = 0; s < segments; ++s) {
            const float u = 2 * kPi * float(r) / float(rings);
            const float v = 2 * kPi * float(s) / float(segments);
            const float out = radius + tube * std::cos(v);
            mesh.vertices.push_back({out * std::cos(u), tube * std::sin(v), out * std::sin(u)});
        }
    add_closed_lattice(mesh, segments, rings);
    return mesh;
}

Mesh grid(uint32_t n) {
    Mesh mesh;
    for (uint32_t y = 0; y <= n; ++y)
        for (uint32_t x = 0; x <= n; ++x)
            mesh.vertices.push_back(
                {2.0f * float(x) / float(n) - 1, 2.0f * float(y) / float(n) - 1, 0});
    for (uint32_t y = 0; y < n; ++y)
        for (uint32_t x = 0; x < n; ++x) {
            const uint32_t a = y * (n + 1) + x, c = a + n + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, c, a + 1, c + 1, c});
        }
    return mesh;
}

Mesh scaled(Mesh mesh, float scale, Float3 offset) {
    for (Float3& v : mesh.vertices) v = scale * v + offset;
    return mesh;
}

Mesh degenerate_soup(Random& random, uint32_t count) {
    Mesh mesh;
    for (uint32_t i = 0; i < count; ++i) {
        const Corners c = degenerate_triangle(random);
        mesh.add(c[0], c[1], c[2]);
        if (random.chance(0.3f)) mesh.add(c[0], c[1], c[2]);
        if (random.chance(0.2f)) mesh.add(c[2], c[0], c[1]);
        if (random.chance(0.3f)) mesh.add(random.in_cube(), random.in_cube(), random.in_cube());
    }
    for (uint32_t i = 0; i < mesh.vertices.size(); ++i) mesh.indices.push_back(i);
    for (uint32_t t = 0; t < mesh.triangle_count(); t += 17)
        mesh.indices[3 * t + t % 3] = t % 2 ? 0xffffffffu : uint32_t(mesh.vertices.size());
    return mesh;
}

Mesh turned_copies(Random& random, const Mesh& once, uint32_t count) {
    Mesh mesh;
    for (uint32_t i = 0; i < count; ++i) {
        Corners c;
        once.corners(random.below(once.triangle_count()), &c);
        if (random.chance(0.5f)) std::swap(c[1], c[2]);
        std::rotate(c.begin(), c.begin() + random.below(3), c.end());
        mesh.add(c[0], c[1], c[2]);
    }
    return mesh;
}

Mesh square_triangles(Random& random, uint32_t count) {
    Mesh mesh;
    for (uint32_t t = 0; t < count; ++t) {
        const Float3 p = random.in_cube();
        Float3 along[2];
        const uint32_t axis = random.below(3);
        (&along[0].x)[axis] = random.between(-0.1f, 0.1f);
        (&along[1].x)[(axis + 1) % 3] = random.between(-0.1f, 0.1f);
        mesh.add(p, p + along[0], p + along[1]);
    }
    return mesh;
}

Mesh large_next_to_tiny(Random& random, uint32_t count) {
    Mesh mesh;
    mesh.add({-1e6f, -1e6f, -1.5f}, {1e6f, -1e6f, -1.5f}, {0, 2e6f, -1.5f});
    for (uint32_t i = 0; i < count; ++i) {
        const Float3 at = random.in_cube();
        const float size = random.between(1e-6f, 1e-2f);
        mesh.add(at + random.in_cube(size), at + random.in_cube(size),
                 at + random.in_cube(size));
    }
    return mesh;
}

}  // namespace test
