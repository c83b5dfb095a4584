#include "passes/build.hpp"

namespace rsh {

// A grid one pixel wide or high is a list as well: four children in a row, half the levels.
rsh_levels levels_of(cl_uint width, cl_uint height) {
    rsh_levels levels = {};
    if (height == 0) height = 1;
    levels.is_list = width == 1 || height == 1;
    if (levels.is_list) {
        width *= height;
        height = 1;
    }
    levels.width[0] = width;
    levels.height[0] = height;
    cl_uint quads = 0;
    do {
        const cl_uint l = levels.count++;
        levels.width[l + 1] =
            levels.is_list ? (levels.width[l] + 3) / 4 : (levels.width[l] + 1) / 2;
        levels.height[l + 1] = (levels.height[l] + 1) / 2;
        levels.first_quad[l] = quads;
        quads += levels.width[l + 1] * levels.height[l + 1];
    } while (levels.width[levels.count] > 1 || levels.height[levels.count] > 1);
    levels.first_quad[levels.count] = quads;
    return levels;
}

cl_ulong ray_count(const rsh_levels& levels) {
    return cl_ulong{levels.width[0]} * levels.height[0];
}

size_t node_bytes(const rsh_levels& levels) {
    return levels.first_quad[levels.count] * sizeof(rsh_node_quad);
}

void build(Recorder& recorder, const rsh_build_desc& desc) {
    const rsh_levels levels = levels_of(desc.width, desc.height);
    const auto parents = [&levels](cl_uint level) {
        return size_t{levels.width[level + 1]} * levels.height[level + 1];
    };
    recorder.launch(RSH_STAGE_BUILD, {"program_traverse", "rsh_build_leaves"},
                    recorder.range(parents(0)), levels, desc.rays, desc.converging, desc.nodes);
    for (cl_uint level = 1; level < levels.count; ++level)
        recorder.launch(RSH_STAGE_BUILD, {"program_traverse", "rsh_build_level"},
                        recorder.range(parents(level)), levels, level, desc.nodes);
}

}  // namespace rsh
