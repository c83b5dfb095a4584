// axes.hpp - every way to trade the error of a frame for its time: a row per way. Renders nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <rsh/rsh.h>

namespace bench::accuracy {

// How a frame is rendered. As it is here: the default, which every row changes in one thing.
struct Setting {
    cl_uint bounces = 4;
    float min_weight = 0;
    float tolerance = 0;  // above: an approximate picture
    double size = 1;      // of the picture's width and height
    cl_uint engine = RSH_ENGINE_TILES;
    rsh_features without = 0;  // that the scene has
};

struct Point {
    std::string axis, value;  // "bounces", "2"
    std::function<void(Setting&)> change;
    bool is_exact = false;  // the picture has the bits of the default one
    bool is_quick = true;   // part of --quick

    Setting setting() const {
        Setting made;
        change(made);
        return made;
    }
};

// The default first.
const std::vector<Point>& all_points();

}  // namespace bench::accuracy
