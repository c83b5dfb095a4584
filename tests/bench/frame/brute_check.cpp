// brute_check.cpp - choosing the sample, tracing it, comparing bytes.
#include "frame/brute_check.hpp"

#include <algorithm>
#include <cstring>

namespace bench {
namespace {

// Ray-triangle tests that take about half a second on two cores.
constexpr double kTests = 1.5e8;

std::vector<size_t> choose(const std::vector<rsh_ray>& rays, size_t triangles) {
    std::vector<size_t> active;
    for (size_t i = 0; i < rays.size(); ++i)
        if (is_active(rays[i])) active.push_back(i);
    const size_t wanted =
        std::clamp(size_t(kTests / double(triangles)), size_t{64}, size_t{1024});
    const size_t step = std::max<size_t>(1, active.size() / wanted);
    std::vector<size_t> sample;
    for (size_t i = step / 2; i < active.size(); i += step) sample.push_back(active[i]);
    return sample;
}

// A list of rays against all triangles into `answers`, which keep their bytes as they come.
template <class Answer>
void trace(const Device& device, rsh_traverse_desc desc, const std::vector<rsh_ray>& rays,
           std::vector<Answer>& answers) {
    if (rays.empty()) return;
    const size_t bytes = answers.size() * sizeof(Answer);
    const cl::Buffer list(device.context(), CL_MEM_READ_WRITE, rays.size() * sizeof(rsh_ray));
    const cl::Buffer out(device.context(), CL_MEM_READ_WRITE, bytes);
    device.queue().enqueueWriteBuffer(list, CL_TRUE, 0, rays.size() * sizeof(rsh_ray),
                                      rays.data());
    device.queue().enqueueWriteBuffer(out, CL_TRUE, 0, bytes, answers.data());
    desc.struct_size = sizeof desc;
    desc.rays = list();
    desc.width = static_cast<cl_uint>(rays.size());
    desc.engine = RSH_ENGINE_BRUTE_FORCE;
    (desc.query == RSH_QUERY_ANY ? desc.occlusion : desc.hits) = out();
    require(rsh_traverse(device.rsh(), device.queue()(), &desc, 0, nullptr, nullptr),
            "rsh_traverse");
    device.queue().enqueueReadBuffer(out, CL_TRUE, 0, bytes, answers.data());
}

template <class Answer>
size_t count_differing(const std::vector<size_t>& sample, const std::vector<Answer>& expected,
                       const std::vector<Answer>& actual) {
    size_t count = 0;
    for (size_t i = 0; i < sample.size(); ++i)
        count += std::memcmp(&expected[i], &actual[sample[i]], sizeof(Answer)) != 0;
    return count;
}

}  // namespace

std::vector<rsh_hit> brute_force_hits(const Device& device, const rsh_geometry& geometry,
                                      const std::vector<rsh_ray>& rays) {
    rsh_traverse_desc desc{};
    desc.geometry = geometry;
    std::vector<rsh_hit> hits(rays.size());
    trace(device, desc, rays, hits);
    return hits;
}

BruteCheck::BruteCheck(const Device& device, const rsh_geometry& geometry, const RayMaker& rays,
                       bool is_shadow)
    : sample_(choose(rays.rays(), geometry.triangle_count)) {
    std::vector<rsh_ray> list;
    for (const size_t i : sample_) list.push_back(rays.rays()[i]);
    if (!is_shadow) {
        hits_ = brute_force_hits(device, geometry, list);
        return;
    }
    rsh_traverse_desc desc{};
    desc.geometry = geometry;
    desc.query = RSH_QUERY_ANY;
    occlusion_.resize(list.size());
    trace(device, desc, list, occlusion_);
}

size_t BruteCheck::mismatches(const std::vector<rsh_hit>& hits) const {
    return count_differing(sample_, hits_, hits);
}

size_t BruteCheck::mismatches(const std::vector<cl_uint>& occlusion) const {
    return count_differing(sample_, occlusion_, occlusion);
}

}  // namespace bench
