#include "oracle/crossings/crossings.hpp"

#include "oracle/found.hpp"

namespace oracle {

std::vector<Crossings> crossings(const test::Mesh& mesh, const std::vector<rsh_ray>& rays,
                                 const std::vector<uint32_t>& skip, Denormals denormals) {
    std::vector<Crossings> all(rays.size());
    find_all(mesh, rays, skip, denormals, [&](size_t ray, std::vector<Found>& found) {
        for (const auto& [triangle, c] : found)
            all[ray].push_back({triangle, c.certain, c.is_slim ? c.corner_t_low : c.t_low,
                                c.is_slim ? c.corner_t_high : c.t_high, float(c.u), float(c.v),
                                c.is_slim ? 1.0f : float(c.uv_error)});
    });
    return all;
}

}  // namespace oracle
