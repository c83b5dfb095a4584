// gltf_curve.cpp - interpolation as glTF 2.0 defines it (appendix C).
#include "import/gltf/gltf_curve.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace render {
namespace {

// Key `low` and the next one, and how far between them the time is.
struct Place {
    size_t low = 0, high = 0;
    double u = 0.0;
    double seconds = 0.0;  // from one to the other
};

Place place_of(const std::vector<float>& times, double time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return {};
    const auto high = static_cast<size_t>(after - times.begin());
    if (after == times.end()) return {high - 1, high - 1, 0.0, 0.0};
    const double start = times[high - 1], seconds = double{times[high]} - start;
    return {high - 1, high, (time - start) / seconds, seconds};
}

// Of a cubic spline, `part` is 0 for the tangent before, 1 for the value, 2 for the tangent after.
double component(const GltfCurve& curve, size_t key, size_t i, size_t part = 1) {
    const bool is_cubic = curve.interpolation == GltfInterpolation::cubic_spline;
    return curve.values[(is_cubic ? 3 * key + part : key) * curve.width + i];
}

double cubic(const GltfCurve& curve, const Place& place, size_t i) {
    const double u = place.u, u2 = u * u, u3 = u2 * u;
    return (2.0 * u3 - 3.0 * u2 + 1.0) * component(curve, place.low, i) +
           place.seconds * (u3 - 2.0 * u2 + u) * component(curve, place.low, i, 2) +
           (3.0 * u2 - 2.0 * u3) * component(curve, place.high, i) +
           place.seconds * (u3 - u2) * component(curve, place.high, i, 0);
}

glm::dquat unit(const glm::dquat& q) {
    const double length = glm::length(q);
    return length > 0.0 ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

glm::dquat quaternion(const GltfCurve& curve, size_t key) {
    return unit(glm::dquat(component(curve, key, 3), component(curve, key, 0),
                           component(curve, key, 1), component(curve, key, 2)));
}

std::vector<double> numbers(const glm::dquat& q) {
    return {q.x, q.y, q.z, q.w};
}

}  // namespace

std::vector<double> value_at(const GltfCurve& curve, double time) {
    Place place = place_of(curve.times, time);
    if (curve.interpolation == GltfInterpolation::step) place.u = 0.0;
    const bool is_rotation = curve.path == GltfPath::rotation;
    if (is_rotation && curve.interpolation != GltfInterpolation::cubic_spline)
        return numbers(
            glm::slerp(quaternion(curve, place.low), quaternion(curve, place.high), place.u));
    std::vector<double> value(curve.width);
    for (size_t i = 0; i < curve.width; ++i)
        value[i] = curve.interpolation == GltfInterpolation::cubic_spline
                       ? cubic(curve, place, i)
                       : glm::mix(component(curve, place.low, i),
                                  component(curve, place.high, i), place.u);
    if (!is_rotation) return value;
    return numbers(unit(glm::dquat(value[3], value[0], value[1], value[2])));
}

}  // namespace render
