// ways.hpp - the ways to traverse that the library names, engine by engine with each bound that
// it takes: a new one is tested without a word in any test.
#pragma once

#include <string>
#include <vector>

#include "support/trace.hpp"

namespace test {

// Brute force, the yardstick, is none of them.
inline std::vector<TraceOptions> all_ways() {
    std::vector<TraceOptions> ways;
    rsh_traverse_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.width = 1;
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    for (desc.engine = 1; rsh_engine_name(desc.engine); ++desc.engine)
        for (desc.shape = 1; rsh_shape_name(desc.shape); ++desc.shape) {
            if (desc.engine == RSH_ENGINE_BRUTE_FORCE) continue;
            if (rsh_traverse_query(device().rsh, &desc, &sizes) != RSH_SUCCESS) continue;
            TraceOptions way;
            way.engine = desc.engine;
            way.bound = desc.shape;
            ways.push_back(way);
        }
    return ways;
}

inline std::string name_of(const TraceOptions& way) {
    const char* bound = rsh_shape_name(way.bound);
    return rsh_engine_name(way.engine) + std::string(bound ? std::string(", ") + bound : "");
}

inline TraceOptions brute_force() {
    TraceOptions options;
    options.engine = RSH_ENGINE_BRUTE_FORCE;
    return options;
}

}  // namespace test
