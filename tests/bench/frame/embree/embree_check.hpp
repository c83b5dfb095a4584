// embree_check.hpp - all answers of a frame against Embree's, differences counted by cause.
#pragma once

#include "frame/embree/differences.hpp"
#include "frame/embree/embree_peer.hpp"

namespace bench {

DifferenceCounts compare_hits(const SceneOnDevice& scene, const RayMaker& rays,
                              const std::vector<rsh_hit>& ours,
                              const std::vector<rsh_hit>& theirs);

// Rays that only one of the two calls occluded are traced again for their closest hits, by
// brute force and one by one, and judged by these; at most 256 of them, the rest are counted as
// other.
DifferenceCounts compare_occlusion(const Device& device, const SceneOnDevice& scene,
                                   const RayMaker& rays, const std::vector<cl_uint>& ours,
                                   const EmbreePeer& embree,
                                   const std::vector<cl_uint>& theirs);

}  // namespace bench
