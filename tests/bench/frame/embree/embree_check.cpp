#include "frame/embree/embree_check.hpp"

#include <algorithm>

namespace bench {
namespace {

// Between a ray and a triangle's normal; 0 when there is no triangle to speak of.
float cosine(const SceneOnDevice& scene, const rsh_ray& ray, cl_uint primitive) {
    const glm::uvec3 t = scene.frame_scene().mesh().triangles[primitive];
    const glm::vec3 a = scene.positions()[t.x];
    const glm::vec3 normal = glm::cross(scene.positions()[t.y] - a, scene.positions()[t.z] - a);
    const glm::vec3 way(ray.direction_tmax.s[0], ray.direction_tmax.s[1],
                        ray.direction_tmax.s[2]);
    const float lengths = glm::length(normal) * glm::length(way);
    return lengths > 0.0f ? glm::dot(normal, way) / lengths : 0.0f;
}

Difference judge(const SceneOnDevice& scene, const rsh_ray& ray, const rsh_hit& ours,
                 const rsh_hit& theirs) {
    const bool is_ours =
        theirs.primitive == RSH_NO_HIT || (ours.primitive != RSH_NO_HIT && ours.t < theirs.t);
    const cl_uint nearer = is_ours ? ours.primitive : theirs.primitive;
    if (nearer == RSH_NO_HIT) return Difference::kNone;
    return compare(ours, theirs, cosine(scene, ray, nearer));
}

// The closest hits of a list of rays by brute force. BLOCKS.
std::vector<rsh_hit> brute_force_hits(const Device& device, const rsh_geometry& geometry,
                                      const std::vector<rsh_ray>& rays) {
    std::vector<rsh_hit> hits(rays.size());
    if (rays.empty()) return hits;
    const size_t ray_bytes = rays.size() * sizeof(rsh_ray);
    const size_t hit_bytes = hits.size() * sizeof(rsh_hit);
    const cl::Buffer list(device.context(), CL_MEM_READ_WRITE, ray_bytes);
    const cl::Buffer out(device.context(), CL_MEM_READ_WRITE, hit_bytes);
    device.queue().enqueueWriteBuffer(list, CL_TRUE, 0, ray_bytes, rays.data());
    rsh_traverse_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry = geometry;
    desc.rays = list();
    desc.width = static_cast<cl_uint>(rays.size());
    desc.hits = out();
    desc.engine = RSH_ENGINE_BRUTE_FORCE;
    rsh::check(rsh_traverse(device.rsh(), device.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_traverse");
    device.queue().enqueueReadBuffer(out, CL_TRUE, 0, hit_bytes, hits.data());
    return hits;
}

}  // namespace

DifferenceCounts compare_hits(const SceneOnDevice& scene, const RayMaker& rays,
                              const std::vector<rsh_hit>& ours,
                              const std::vector<rsh_hit>& theirs) {
    DifferenceCounts counts;
    for (size_t i = 0; i < ours.size(); ++i)
        if (is_active(rays.rays()[i]))
            counts.add(judge(scene, rays.rays()[i], ours[i], theirs[i]));
    return counts;
}

DifferenceCounts compare_occlusion(const Device& device, const SceneOnDevice& scene,
                                   const RayMaker& rays, const std::vector<cl_uint>& ours,
                                   const EmbreePeer& embree,
                                   const std::vector<cl_uint>& theirs) {
    DifferenceCounts counts;
    std::vector<rsh_ray> differing;
    for (size_t i = 0; i < ours.size(); ++i)
        if (is_active(rays.rays()[i]) && ours[i] != theirs[i])
            differing.push_back(rays.rays()[i]);
    const size_t judged = std::min<size_t>(differing.size(), 256);
    counts.other = differing.size() - judged;
    differing.resize(judged);
    const std::vector<rsh_hit> hits = brute_force_hits(device, scene.geometry(), differing);
    for (size_t i = 0; i < judged; ++i) {
        const Difference found =
            judge(scene, differing[i], hits[i], embree.trace_one(differing[i]));
        // Both find the same closest hit after all: the occluder was one behind it, or tfar was
        // the difference.
        counts.add(found == Difference::kNone ? Difference::kOther : found);
    }
    return counts;
}

}  // namespace bench
