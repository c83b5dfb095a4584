#include "bounds/levels.hpp"

namespace rsh {

rsh_levels ray_level(cl_uint width, cl_uint height) {
    rsh_levels levels = {};
    if (height == 0) height = 1;
    levels.is_list = width == 1 || height == 1;
    levels.width[0] = levels.is_list ? width * height : width;
    levels.height[0] = levels.is_list ? 1 : height;
    return levels;
}

cl_uint add_level(rsh_levels& levels) {
    const cl_uint l = levels.count++, fan = levels.fan;
    const cl_uint in_row = levels.is_list ? fan * fan : fan;
    levels.width[l + 1] = (levels.width[l] + in_row - 1) / in_row;
    levels.height[l + 1] = (levels.height[l] + fan - 1) / fan;
    return l;
}

}  // namespace rsh
