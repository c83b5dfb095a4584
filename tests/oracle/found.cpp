#include "oracle/found.hpp"

#include <algorithm>

#include "oracle/filter.hpp"
#include "oracle/on_all_cores.hpp"

namespace oracle {
namespace {

constexpr size_t kRaysAtOnce = 16;

// All blocks against a few rays at a time, so that a block is read from memory once for them.
void find_for_rays(const std::vector<Block>& blocks, const test::Mesh& mesh,
                   const std::vector<rsh_ray>& rays, const std::vector<uint32_t>& skip,
                   Denormals denormals, const TakeFound& take, size_t first) {
    const size_t last = std::min(first + kRaysAtOnce, rays.size());
    std::vector<Found> found[kRaysAtOnce];
    std::vector<uint32_t> passed;
    for (const Block& block : blocks)
        for (size_t i = first; i < last; ++i) {
            if (!test::is_active(rays[i])) continue;
            passed.clear();
            filter(block, rays[i], &passed);
            for (const uint32_t triangle : passed) {
                test::Corners corners;
                if (!mesh.corners(triangle, &corners)) continue;
                if (!skip.empty() && skip[i] == triangle) continue;
                const Candidate candidate = intersect(rays[i], corners, denormals);
                if (candidate.possible) found[i - first].push_back({triangle, candidate});
            }
        }
    for (size_t i = first; i < last; ++i) take(i, found[i - first]);
}

}  // namespace

void find_all(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
              const std::vector<uint32_t>& skip, Denormals denormals, const TakeFound& take) {
    const std::vector<Block> blocks = make_blocks(mesh);
    on_all_cores((rays.size() + kRaysAtOnce - 1) / kRaysAtOnce, [&](size_t i) {
        find_for_rays(blocks, mesh, rays, skip, denormals, take, i * kRaysAtOnce);
    });
}

}  // namespace oracle
