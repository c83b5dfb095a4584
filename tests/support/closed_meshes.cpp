#include "support/closed_meshes.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace test {
namespace {

constexpr double kTurn = 2 * 3.14159265358979323846;

Double3 on_knot(double t) {
    return {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
            -std::sin(3 * t)};
}

Double3 along_knot(double t) {
    return {std::cos(t) + 4 * std::cos(2 * t), -std::sin(t) + 4 * std::sin(2 * t),
            -3 * std::cos(3 * t)};
}

struct LessBits {
    bool operator()(const Float3& a, const Float3& b) const {
        return std::make_pair(a.x, std::make_pair(a.y, a.z)) <
               std::make_pair(b.x, std::make_pair(b.y, b.z));
    }
};

// Equal corners have one number, whatever the indices.
Mesh welded(const Mesh& mesh) {
    Mesh made;
    std::map<Float3, uint32_t, LessBits> numbers;
    for (uint32_t i = 0; i < mesh.triangle_count(); ++i) {
        Corners corners;
        if (!mesh.corners(i, &corners)) continue;
        for (const Float3& corner : corners) {
            const auto [at, is_new] = numbers.emplace(corner, uint32_t(made.vertices.size()));
            if (is_new) made.vertices.push_back(corner);
            made.indices.push_back(at->second);
        }
    }
    return made;
}

// How much oftener an edge runs from the first vertex to the second than back.
using Edges = std::map<std::pair<uint32_t, uint32_t>, int>;

Edges open_edges(const Mesh& mesh) {
    Edges edges;
    for (uint32_t i = 0; i < mesh.indices.size(); ++i) {
        const uint32_t from = mesh.indices[i], to = mesh.indices[i - i % 3 + (i + 1) % 3];
        if (from < to) ++edges[{from, to}];
        if (to < from) --edges[{to, from}];
    }
    Edges open;
    for (const auto& [edge, count] : edges) {
        if (count > 0) open[edge] = count;
        if (count < 0) open[{edge.second, edge.first}] = -count;
    }
    return open;
}

}  // namespace

Mesh trefoil(uint32_t segments, uint32_t rings) {
    Mesh mesh;
    for (uint32_t r = 0; r < rings; ++r)
        for (uint32_t s = 0; s < segments; ++s) {
            const double t = kTurn * r / rings, around = kTurn * s / segments;
            const Double3 along = normalize(along_knot(t));
            // Never along z, see along_knot.
            const Double3 side = normalize(cross(along, Double3(0, 0, 1)));
            const Double3 offset =
                std::cos(around) * side + std::sin(around) * cross(along, side);
            mesh.vertices.emplace_back((1.0 / 4) * (on_knot(t) + 0.6 * offset));
        }
    add_closed_lattice(mesh, segments, rings);
    return mesh;
}

Mesh lattice_box(Random& random, uint32_t half) {
    const int n = int(half);
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1})
            for (int x = -n; x < n; ++x)
                for (int y = -n; y < n; ++y) {
                    const auto corner = [&](int i, int j) {
                        float c[3];
                        c[axis] = float(side * n);
                        c[(axis + 1) % 3] = float(x + (side > 0 ? i : j));
                        c[(axis + 2) % 3] = float(y + (side > 0 ? j : i));
                        return Float3(c[0], c[1], c[2]);
                    };
                    const Float3 a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                                 d = corner(0, 1);
                    const bool is_turned = random.chance(0.5f);
                    mesh.add(a, b, is_turned ? d : c);
                    mesh.add(is_turned ? b : a, c, d);
                }
    return welded(mesh);
}

Mesh star(uint32_t segments, uint32_t rings, float inner) {
    Mesh mesh = sphere(segments, rings);
    for (uint32_t i = 0; i < mesh.vertices.size(); i += 2)
        mesh.vertices[i] = inner * mesh.vertices[i];
    return mesh;
}

Mesh with_needles(Random& random, Mesh mesh, uint32_t count) {
    const uint32_t before = mesh.triangle_count();
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t at = 3 * random.below(before), k = random.below(3);
        const uint32_t a = mesh.indices[at + k], b = mesh.indices[at + (k + 1) % 3],
                       c = mesh.indices[at + (k + 2) % 3];
        const float along[] = {0.0f, 0.5f, 0x1p-20f, 0.3f};
        const auto middle = uint32_t(mesh.vertices.size());
        const Float3 from = mesh.vertices[a], to = mesh.vertices[b];
        mesh.vertices.push_back(from + along[random.below(4)] * (to - from));
        mesh.indices[at] = a, mesh.indices[at + 1] = middle, mesh.indices[at + 2] = c;
        mesh.indices.insert(mesh.indices.end(), {middle, b, c, a, b, middle});
    }
    return mesh;
}

// As often as edges come to a vertex they leave it, so that the way round never ends.
Mesh without_holes(const Mesh& mesh) {
    Mesh made = welded(mesh);
    for (Edges open = open_edges(made); !open.empty(); open = open_edges(made)) {
        std::vector<uint32_t> way = {open.begin()->first.first};
        auto met = way.end();
        while (met == way.end()) {
            const uint32_t next = open.lower_bound({way.back(), 0})->first.second;
            met = std::find(way.begin(), way.end(), next);
            if (met == way.end()) {
                way.push_back(next);
                met = way.end();
            }
        }
        for (auto v = met + 1; v + 1 < way.end(); ++v)
            made.indices.insert(made.indices.end(), {*met, *(v + 1), *v});
    }
    return made;
}

uint32_t count_open_edges(const Mesh& mesh) {
    uint32_t count = 0;
    for (const auto& edge : open_edges(welded(mesh))) count += uint32_t(edge.second);
    return count;
}

}  // namespace test
