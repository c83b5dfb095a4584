#include "traverse/engine.hpp"

#include "bvh/bound.hpp"
#include "device/error.hpp"
#include "rays/bound.hpp"

namespace rsh {

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
    scratch.add("bound scratch",
                bound.bound_scratch(context, desc.geometry, RSH_UPDATE_NONE).bytes());
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

void report_progress(const rsh_traverse_desc& desc, cl_uint batch, cl_uint batch_count) {
    if (desc.progress && desc.progress(batch, batch_count, desc.progress_user))
        throw Error(RSH_CANCELLED,
                    "progress: asked to stop before batch " + std::to_string(batch));
}

}  // namespace rsh
