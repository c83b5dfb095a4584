#include "oracle/mirrors/float_state.hpp"

namespace oracle {
namespace {

using test::Double3;
using test::Float3;

// The floats below and above a number.
struct Between {
    float low, high;
};

Between floats_around(Quad value) {
    const float nearest = float(value);
    if (Quad(nearest) > value) return {std::nextafter(nearest, -INFINITY), nearest};
    return {nearest, std::nextafter(nearest, INFINITY)};
}

}  // namespace

MirrorRay rounded(const MirrorRay& ray, const Quad3&) {
    return {Quad3(Float3(ray.origin)), Quad3(Float3(ray.direction)), ray.skip};
}

MirrorRay departed(const MirrorRay& ray, const Quad3& plane) {
    const Quad3 unit = Quad(1 / length(Double3(ray.direction))) * ray.direction;
    const Quad reach = 0.75 * 0x1p-24 * max_norm(Double3(ray.origin));
    const Quad3 place = ray.origin + reach * unit;
    const Between x = floats_around(place.x), y = floats_around(place.y),
                  z = floats_around(place.z);
    MirrorRay best = ray;
    Quad least = -1;  // of none yet
    for (int i = 0; i < 8; ++i) {
        const Quad3 corner(i & 1 ? x.high : x.low, i & 2 ? y.high : y.low,
                           i & 4 ? z.high : z.low);
        const Quad3 way = corner - ray.origin;
        const Quad along = dot(way, unit);
        const Quad badness = dot(way, way) - 0.75 * along * along;
        if (dot(way, plane) <= 0 || (least >= 0 && badness >= least)) continue;
        best.origin = corner;
        least = badness;
    }
    return best;
}

}  // namespace oracle
