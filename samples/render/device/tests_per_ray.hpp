// tests_per_ray.hpp - how many boxes and triangles each camera ray is tested against when the engine tiles
// traces it, for a map of where a picture's rays are dear.
#pragma once

#include <cstdint>
#include <vector>

#include "device/device.hpp"

namespace render {

class TestsPerRay {
public:
    // Of the picture's geometry as it is now; for up to `most_rows` rows of it at a time.
    TestsPerRay(const rsh::Device& device, const rsh_frame_desc& picture, uint32_t most_rows);

    // rays: of `rows` whole rows.
    std::vector<uint32_t> count(const rsh::Buffer& rays, uint32_t rows) const;

private:
    rsh_build_desc build(const rsh::Buffer& rays, uint32_t rows) const;
    rsh_traverse_desc traverse(const rsh::Buffer& rays, uint32_t rows) const;

    const rsh::Device& device_;
    const rsh_geometry geometry_;
    const uint32_t width_;
    rsh::Buffer bounds_, nodes_, hits_, tests_;
};

}  // namespace render
