// scenes.hpp - the scenes of rsh-bench hits: rooms as people render them, and triangles and rays that
// are hard on floats. Makes them; traces nothing but the rays of rooms.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "device.hpp"
#include "stability/family.hpp"

namespace bench::hits {

struct SceneKind {
    std::string name;
    std::string group;  // of scenes that are hard for the same reason
    bool is_closed;     // whatever ray begins inside: one that hits nothing has leaked
    bool is_coherent;   // neighbouring rays are alike
    bool is_quick;      // part of --quick
    uint32_t times;     // as many rays across as asked for
    std::function<stability::Scene(const Device&, stability::Extent)> make;
};

// `extent.side` is multiplied, `extent.triangles` is for scenes whose name has no number of triangles.
const std::vector<SceneKind>& scene_kinds();

}  // namespace bench::hits
