// inspect.cpp - mesh -> welded triangles -> edges and components -> counts.
//
// A half-edge mesh cannot count what is wrong: a half-edge has one opposite, so OpenMesh refuses
// the third triangle of an edge and the second one that passes it in the same direction. Hence a
// sorted table of all edges.
#include "model/inspect.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "model/weld.hpp"

namespace render {
namespace {

struct Edge {
    uint32_t low, high;
    bool is_forward;  // from low to high
    bool operator<(const Edge& other) const {
        return std::tie(low, high) < std::tie(other.low, other.high);
    }
};

void count_edges(const std::vector<glm::uvec3>& triangles, Inspection& result) {
    std::vector<Edge> edges;
    for (const glm::uvec3& t : triangles)
        for (int i = 0; i < 3; ++i) {
            const uint32_t from = t[i], to = t[(i + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from < to});
        }
    std::sort(edges.begin(), edges.end());
    size_t odd = 0;
    for (auto first = edges.begin(); first != edges.end();) {
        const auto end = std::upper_bound(first, edges.end(), *first);
        const auto forward =
            std::count_if(first, end, [](const Edge& e) { return e.is_forward; });
        const auto count = end - first;
        result.boundary_edges += count == 1;
        result.non_manifold_edges += count > 2;
        result.flipped_edges += count % 2 == 0 && 2 * forward != count;
        odd += count % 2 != 0;
        first = end;
    }
    result.is_closed = !edges.empty() && odd == 0;
}

// Which vertices hang together: union-find with path halving.
class Sets {
public:
    explicit Sets(size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0u);
    }
    uint32_t root(uint32_t v) {
        while (parents_[v] != v) v = parents_[v] = parents_[parents_[v]];
        return v;
    }
    void join(uint32_t a, uint32_t b) { parents_[root(a)] = root(b); }

private:
    std::vector<uint32_t> parents_;
};

struct Component {
    glm::dvec3 origin{0.0}, low{INFINITY}, high{-INFINITY};
    double volume = 0.0;

    // By the tetrahedra between the triangles and a point of the component, which need not be
    // inside (divergence theorem).
    void add(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
        if (!(low.x <= high.x)) origin = a;
        for (const glm::dvec3 p : {a, b, c}) low = glm::min(low, p), high = glm::max(high, p);
        volume += glm::dot(a - origin, glm::cross(b - origin, c - origin)) / 6.0;
    }
    bool encloses(const Component& other) const {
        return glm::all(glm::lessThanEqual(low, other.low)) &&
               glm::all(glm::greaterThanEqual(high, other.high));
    }
};

// A component that is wound inwards is the wall of a cavity if it lies in one that is not.
bool all_outwards(const std::vector<Component>& components) {
    return std::all_of(components.begin(), components.end(), [&](const Component& c) {
        return c.volume > 0.0 ||
               (c.volume < 0.0 &&
                std::any_of(components.begin(), components.end(), [&](const Component& other) {
                    return other.volume > -c.volume && other.encloses(c);
                }));
    });
}

// The triangles that have three edges, in welded vertices; the others are left out.
std::vector<glm::uvec3> whole_triangles(const std::vector<glm::vec3>& positions,
                                        const std::vector<glm::uvec3>& triangles,
                                        const std::vector<uint32_t>& number,
                                        Inspection& result) {
    std::vector<glm::uvec3> whole;
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 a(positions[t.x]), b(positions[t.y]), c(positions[t.z]);
        const double twice_area = glm::length(glm::cross(b - a, c - a));
        result.degenerate_triangles += !(twice_area > 0.0 && std::isfinite(twice_area));
        const glm::uvec3 w(number[t.x], number[t.y], number[t.z]);
        if (w.x != w.y && w.y != w.z && w.z != w.x && std::isfinite(twice_area))
            whole.push_back(w);
    }
    return whole;
}

std::vector<Component> find_components(const std::vector<glm::vec3>& welded,
                                       const std::vector<glm::uvec3>& triangles) {
    Sets sets(welded.size());
    for (const glm::uvec3& t : triangles) sets.join(t.x, t.y), sets.join(t.y, t.z);
    std::map<uint32_t, Component> by_root;
    for (const glm::uvec3& t : triangles)
        by_root[sets.root(t.x)].add(welded[t.x], welded[t.y], welded[t.z]);
    std::vector<Component> components;
    for (const auto& [root, component] : by_root) components.push_back(component);
    return components;
}

}  // namespace

Inspection inspect(const std::vector<glm::vec3>& positions,
                   const std::vector<glm::uvec3>& triangles) {
    Inspection result;
    Weld weld;
    std::vector<uint32_t> number;
    for (const glm::vec3& position : positions)
        number.push_back(weld(position + 0.0f));  // -0 becomes 0
    result.vertices = weld.positions().size();
    result.triangles = triangles.size();
    const std::vector<glm::uvec3> whole = whole_triangles(positions, triangles, number, result);
    count_edges(whole, result);
    const std::vector<Component> components = find_components(weld.positions(), whole);
    result.components = components.size();
    for (const Component& c : components) result.volume += c.volume;
    result.is_wound_outwards =
        result.flipped_edges == 0 && !components.empty() && all_outwards(components);
    return result;
}

std::vector<std::string> glass_warnings(const Model& model) {
    std::vector<std::string> warnings;
    for (size_t id = 0; id < model.materials.size(); ++id) {
        const Material& material = model.materials[id];
        const bool bends_light =
            material.transmission != glm::vec3(0.0f) && material.ior != 1.0f;
        if (!bends_light) continue;
        std::vector<glm::uvec3> triangles;
        for (size_t i = 0; i < model.mesh.triangles.size(); ++i)
            if (model.mesh.material_ids[i] == id) triangles.push_back(model.mesh.triangles[i]);
        if (triangles.empty()) continue;
        const Inspection found = inspect(model.mesh.positions, triangles);
        const std::string start =
            "material '" + material.name + "' is glass, but its surface is not ";
        if (!found.is_closed)
            warnings.push_back(start + "closed: it has " +
                               std::to_string(found.boundary_edges) + " boundary and " +
                               std::to_string(found.non_manifold_edges) +
                               " non-manifold edges");
        else if (!found.is_wound_outwards)
            warnings.push_back(start + "wound outwards");
    }
    return warnings;
}

}  // namespace render
