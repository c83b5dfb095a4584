#include "bounds/bound.hpp"
#include "core/error.hpp"
#include "engines/brute_force.hpp"
#include "engines/paper.hpp"
#include "engines/paper_faithful.hpp"
#include "engines/tiles.hpp"
#include "passes/bound.hpp"

namespace rsh {

// The first one is the default.
const std::vector<const Engine*>& engines() {
    static const Tiles tiles;
    static const Paper paper;
    static const PaperFaithful paper_faithful;
    static const BruteForce brute_force;
    static const std::vector<const Engine*> all = {&tiles, &paper, &paper_faithful,
                                                   &brute_force};
    return all;
}

const Engine& find_engine(cl_uint id) {
    if (id == RSH_ENGINE_DEFAULT) return *engines().front();
    for (const Engine* engine : engines())
        if (engine->id() == id) return *engine;
    throw Error(RSH_INVALID_VALUE,
                "engine: is " + std::to_string(id) + ", must be RSH_ENGINE_...");
}

void check_bound(const Engine& engine, cl_uint bound) {
    const cl_uint id = find_bound(bound).id();
    std::string taken;
    for (const cl_uint own : engine.bounds()) {
        if (own == id) return;
        taken += (taken.empty() ? "" : " or ") + std::string(find_bound(own).name());
    }
    if (taken.empty()) return;
    throw Error(RSH_INVALID_VALUE, std::string("bound: is ") + find_bound(bound).name() +
                                       ", must be " + taken + " with engine " + engine.name());
}

void reserve_bounds(Layout& scratch, const Context& context, const rsh_traverse_desc& desc,
                    SceneBounds bounds) {
    if (bounds == SceneBounds::given) return;
    const Bound& bound = find_bound(desc.bound);
    scratch.add("bounds", bound.scene_bytes(desc.geometry));
    scratch.add("bound scratch", bound.bound_scratch(context, desc.geometry).bytes());
}

cl_mem make_bounds(Recorder& recorder, const rsh_traverse_desc& desc, const Scratch& scratch) {
    rsh_bound_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.geometry;
    pass.bound = desc.bound;
    pass.bounds = scratch["bounds"];
    pass.scratch = scratch["bound scratch"];
    bound(recorder, pass);
    return pass.bounds;
}

}  // namespace rsh
