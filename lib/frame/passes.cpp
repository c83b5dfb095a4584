#include "frame/passes.hpp"

#include <algorithm>

#include "shade/shade.hpp"

namespace rsh {
namespace {

// Of what a frame may take, for the streams of pairs.
size_t stream_budget(const rsh_frame_desc& desc) {
    return desc.budget ? std::max<size_t>(desc.budget / 8, RSH_MIN_BUDGET) : 0;
}

}  // namespace

bool needs_shadows(const rsh_frame_desc& desc) {
    return shadow_lights(*desc.scene) != 0;
}

bool needs_bounces(const rsh_frame_desc& desc) {
    return desc.bounces > 0 &&
           (desc.scene->features & (RSH_FEATURE_REFLECTION | RSH_FEATURE_REFRACTION)) != 0;
}

bool needs_traversals(const rsh_frame_desc& desc) {
    return needs_shadows(desc) || needs_bounces(desc) || desc.batches;
}

BatchNeeds batch_needs(const rsh_frame_desc& desc) {
    const rsh_features features = desc.scene->features;
    cl_uint needed = RSH_BATCH_INDICES | RSH_BATCH_MATERIAL_IDS;
    if (features & RSH_FEATURE_SMOOTH_NORMAL) needed |= RSH_BATCH_NORMALS;
    if (features & RSH_FEATURE_TEXTURE) needed |= RSH_BATCH_TEXCOORDS;
    return {desc.batches, desc.batches->attributes & needed, desc.engine, desc.shape};
}

bool is_approximate(const rsh_frame_desc& desc) {
    return desc.tolerance > 0 && (needs_shadows(desc) || needs_bounces(desc));
}

std::string numbered(const char* name, cl_uint bounce) {
    return std::string(name) + ' ' + std::to_string(bounce);
}

rsh_rasterize_desc rasterize_of(const rsh_frame_desc& desc) {
    rsh_rasterize_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.scene->geometry;
    pass.camera = desc.camera;
    pass.width = desc.width;
    pass.height = desc.height;
    pass.window = desc.window;
    return pass;
}

rsh_traverse_desc traverse_of(const rsh_frame_desc& desc, cl_uint width, cl_uint height) {
    rsh_traverse_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.geometry = desc.scene->geometry;
    pass.width = width;
    pass.height = height;
    pass.engine = desc.engine;
    pass.shape = desc.shape;
    pass.strategy = desc.strategy;
    pass.budget = stream_budget(desc);
    return pass;
}

rsh_reduce_desc pack_listed_of(const rsh_frame_desc& desc, cl_uint step) {
    rsh_reduce_desc pass = {};
    pass.struct_size = sizeof pass;
    pass.strategy = desc.strategy;
    pass.keep = RSH_KEEP_NOT_NULL;
    pass.element_bytes = sizeof(cl_uint);
    pass.count = listed_words(grid_of(desc.width, desc.height, step));
    return pass;
}

}  // namespace rsh
