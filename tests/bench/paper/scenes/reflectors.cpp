// reflectors.cpp - a union of sets over the corners of reflecting triangles.
#include "paper/scenes/reflectors.hpp"

#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace bench::paper {
namespace {

class Sets {
public:
    explicit Sets(size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    uint32_t find(uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(uint32_t a, uint32_t b) { parent_[find(a)] = find(b); }

private:
    std::vector<uint32_t> parent_;
};

bool reflects(const rsh_material& material) {
    for (int i = 0; i < 3; ++i)
        if (material.reflection.s[i] > 0 || material.transmission.s[i] > 0) return true;
    return false;
}

// For each vertex, the first one at its place.
std::vector<uint32_t> first_at_place(const std::vector<glm::vec3>& positions) {
    std::map<std::tuple<float, float, float>, uint32_t> places;
    std::vector<uint32_t> first;
    for (const glm::vec3& p : positions)
        first.push_back(
            places.emplace(std::tuple(p.x, p.y, p.z), uint32_t(first.size())).first->second);
    return first;
}

}  // namespace

size_t count_reflectors(const StillScene& scene, const std::vector<rsh_hit>& hits) {
    const render::Mesh& mesh = scene.mesh;
    const auto is_reflecting = [&](size_t triangle) {
        return reflects(scene.materials[mesh.material_ids[triangle]]);
    };
    const std::vector<uint32_t> place = first_at_place(mesh.positions);
    Sets things(mesh.positions.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!is_reflecting(i)) continue;
        const glm::uvec3 t = mesh.triangles[i];
        things.join(place[t.x], place[t.y]);
        things.join(place[t.x], place[t.z]);
    }
    std::set<uint32_t> seen;
    for (const rsh_hit& hit : hits)
        if (hit.primitive != RSH_NO_HIT && is_reflecting(hit.primitive))
            seen.insert(things.find(place[mesh.triangles[hit.primitive].x]));
    return seen.size();
}

}  // namespace bench::paper
