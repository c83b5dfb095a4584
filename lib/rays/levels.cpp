#include "rays/levels.hpp"

namespace rsh {

namespace {

// Level 0 alone. A grid one pixel wide or high is a list as well: its children in a row.
ray_levels ray_level(cl_uint width, cl_uint height) {
    ray_levels levels = {};
    if (height == 0) height = 1;
    levels.is_list = width == 1 || height == 1;
    levels.width[0] = levels.is_list ? width * height : width;
    levels.height[0] = levels.is_list ? 1 : height;
    return levels;
}

// Adds the level above the topmost one, which is returned.
cl_uint add_level(ray_levels& levels) {
    const cl_uint l = levels.count++, branching = levels.branching;
    const cl_uint in_row = levels.is_list ? branching * branching : branching;
    levels.width[l + 1] = (levels.width[l] + in_row - 1) / in_row;
    levels.height[l + 1] = (levels.height[l] + branching - 1) / branching;
    return l;
}

}  // namespace

ray_levels cone_levels(cl_uint width, cl_uint height) {
    ray_levels levels = ray_level(width, height);
    levels.branching = 2;
    cl_uint quads = 0;
    do {
        const cl_uint l = add_level(levels);
        levels.first_child_group[l] = quads;
        quads += levels.width[l + 1] * levels.height[l + 1];
    } while (levels.width[levels.count] > 1 || levels.height[levels.count] > 1);
    levels.first_child_group[levels.count] = quads;
    return levels;
}

ray_levels box_levels(cl_uint width, cl_uint height) {
    ray_levels levels = ray_level(width, height);
    levels.branching = 4;
    add_level(levels);
    add_level(levels);
    return levels;
}

ray_levels group_levels(cl_uint width, cl_uint height) {
    ray_levels levels = ray_level(width, height);
    levels.branching = 4;
    add_level(levels);
    do {
        const cl_uint l = add_level(levels);
        levels.first_child_group[l + 1] =
            levels.first_child_group[l] + static_cast<cl_uint>(node_count(levels, l + 1));
    } while (node_count(levels, levels.count) > 1);
    return levels;
}

}  // namespace rsh
