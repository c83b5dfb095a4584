// ways.hpp - the ways to traverse that the library names, engine by engine with each bound that
// it takes: a new one is tested without a word in any test.
#pragma once

#include <string>
#include <vector>

#include "support/not_empty.hpp"
#include "support/trace.hpp"

namespace test {

inline TraceOptions brute_force() {
    TraceOptions options;
    options.engine = RSH_ENGINE_BRUTE_FORCE;
    return options;
}

// With each bound that the engine takes.
inline std::vector<TraceOptions> ways_of(cl_uint engine) {
    std::vector<TraceOptions> ways;
    rsh_traverse_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.width = 1;
    desc.engine = engine;
    rsh_sizes sizes = {};
    sizes.struct_size = sizeof sizes;
    for (desc.shape = 1; rsh_shape_name(desc.shape); ++desc.shape) {
        if (rsh_traverse_query(device().rsh, &desc, &sizes) != RSH_SUCCESS) continue;
        TraceOptions way;
        way.engine = engine;
        way.bound = desc.shape;
        ways.push_back(way);
    }
    return not_empty(ways, std::string("ways of ") + rsh_engine_name(engine));
}

// Brute force, the yardstick, is none of them.
inline std::vector<TraceOptions> all_ways() {
    std::vector<TraceOptions> all;
    for (cl_uint engine = 1; rsh_engine_name(engine); ++engine)
        if (engine != RSH_ENGINE_BRUTE_FORCE)
            for (const TraceOptions& way : ways_of(engine)) all.push_back(way);
    return not_empty(all, "ways");
}

inline std::vector<TraceOptions> brute_force_and_all_ways() {
    std::vector<TraceOptions> all = all_ways();
    all.push_back(brute_force());
    return all;
}

inline std::string name_of(const TraceOptions& way) {
    const char* bound = rsh_shape_name(way.bound);
    return rsh_engine_name(way.engine) + std::string(bound ? std::string(", ") + bound : "");
}

}  // namespace test
