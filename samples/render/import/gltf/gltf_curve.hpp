// gltf_curve.hpp - what an animation of a glTF file does to one member of one node over time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace render {

enum class GltfPath { translation, rotation, scale, weights };
enum class GltfInterpolation { step, linear, cubic_spline };

struct GltfCurve {
    uint32_t node = 0;
    GltfPath path = GltfPath::translation;
    GltfInterpolation interpolation = GltfInterpolation::linear;
    size_t width = 3;          // numbers of a value; of a rotation x, y, z, w
    std::vector<float> times;  // at least one, ascending [s]
    // A value per time; of a cubic spline three: the tangent before, the value, the tangent after.
    std::vector<float> values;
};

// The curve's value, which stands still before its first time and after its last one. Rotations take
// the shorter way (slerp) and are units.
std::vector<double> value_at(const GltfCurve& curve, double time);

}  // namespace render
