#include "accuracy/axes.hpp"

#include <fmt/format.h>

namespace bench::accuracy {
namespace {

Point bounces(cl_uint count, bool is_quick) {
    return {"bounces", fmt::format("{}", count), [=](Setting& s) { s.bounces = count; }, false,
            is_quick};
}

Point min_weight(float weight) {
    return {"min_weight", fmt::format("{}", weight),
            [=](Setting& s) { s.min_weight = weight; }};
}

Point tolerance(float tolerance) {
    return {"tolerance", fmt::format("{}", tolerance),
            [=](Setting& s) { s.tolerance = tolerance; }};
}

Point size(double times, const char* name) {
    return {"size", name, [=](Setting& s) { s.size = times; }};
}

Point engine(cl_uint engine) {
    return {"engine", rsh_engine_name(engine), [=](Setting& s) { s.engine = engine; }, true};
}

Point without(const char* axis, rsh_features feature) {
    return {axis, "off", [=](Setting& s) { s.without = feature; }};
}

}  // namespace

// To add an axis: what it changes in Setting, and its rows here. A row whose feature the scene does not
// have is left out. Each engine takes one shape of nodes, so that spheres and cones against boxes is
// paper_faithful against paper.
const std::vector<Point>& all_points() {
    static const std::vector<Point> all = {
        {"default", "-", [](Setting&) {}},
        bounces(0, true),
        bounces(1, true),
        bounces(2, true),
        bounces(3, false),
        bounces(5, false),
        bounces(6, false),
        bounces(7, false),
        bounces(8, true),
        min_weight(0.01f),
        min_weight(0.03f),
        min_weight(0.1f),
        min_weight(0.3f),
        tolerance(0.003f),
        tolerance(0.01f),
        tolerance(0.03f),
        size(0.25, "1/4"),
        size(0.5, "1/2"),
        size(2, "2"),
        size(4, "4"),
        engine(RSH_ENGINE_PAPER),
        engine(RSH_ENGINE_PAPER_FAITHFUL),
        engine(RSH_ENGINE_BRUTE_FORCE),
        without("shadow", RSH_FEATURE_SHADOW),
        without("reflection", RSH_FEATURE_REFLECTION),
        without("refraction", RSH_FEATURE_REFRACTION),
        without("texture", RSH_FEATURE_TEXTURE),
    };
    return all;
}

}  // namespace bench::accuracy
