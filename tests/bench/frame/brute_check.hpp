// brute_check.hpp - the yardstick: a sample of the active rays against every triangle, on the
// device, and how many answers of a frame differ from it in any bit.
#pragma once

#include "frame/ray_maker.hpp"

namespace bench {

class BruteCheck {
public:
    // Traces an even sample of the rays that `rays` made last. BLOCKS, for a second or so.
    BruteCheck(const Device& device, const rsh_geometry& geometry, const RayMaker& rays,
               bool is_shadow);

    size_t sample_size() const { return sample_.size(); }
    size_t mismatches(const std::vector<rsh_hit>& hits) const;
    size_t mismatches(const std::vector<cl_uint>& occlusion) const;

private:
    std::vector<size_t> sample_;  // indices of rays
    std::vector<rsh_hit> hits_;
    std::vector<cl_uint> occlusion_;
};

// The closest hits of a list of rays by brute force. BLOCKS.
std::vector<rsh_hit> brute_force_hits(const Device& device, const rsh_geometry& geometry,
                                      const std::vector<rsh_ray>& rays);

}  // namespace bench
