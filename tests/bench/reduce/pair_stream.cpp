#include "reduce/pair_stream.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "bvh/types.h"
#include "frame/ray_maker.hpp"
#include "rays/levels.hpp"
#include "reduce/streams/stream_files.hpp"

namespace bench {
namespace {

constexpr Size kFrame = {512, 512};

struct HostPair {
    cl_uint triangle, node;  // the index in its level
};

// Rays, hierarchy and spheres of one frame, read back.
class Hierarchy {
public:
    Hierarchy(const Device& device, const std::string& scene_name)
        : device_(device),
          frame_(SceneSpec{scene_name, Reflector::kFile, 0,
                           std::string(RSH_SCENE_FILES) + "/" + scene_name + ".json"}),
          scene_(device, frame_),
          rays_(device, kFrame) {
        scene_.move(0.0);
        rays_.make(scene_, RayKind::kReflection);
        build();
        bound();
    }

    const ray_levels& levels() const { return levels_; }
    cl_uint triangle_count() const { return scene_.geometry().triangle_count; }

    // Child k of a node of level + 1, as kernels/rays/cone_sphere.h sees it.
    bool meets(cl_uint level, const HostPair& pair, int k) const {
        const cone_node4& q = quads_[levels_.first_child_group[level] + pair.node];
        const cl_float4& s = spheres_[pair.triangle];
        if (!(q.radius.s[k] >= 0) || !(s.s[3] >= 0)) return false;
        if (q.sine.s[k] > 1) return true;
        const glm::dvec3 w(s.s[0] - q.apex_x.s[k], s.s[1] - q.apex_y.s[k],
                           s.s[2] - q.apex_z.s[k]);
        const glm::dvec3 axis(q.axis_x.s[k], q.axis_y.s[k], q.axis_z.s[k]);
        const double z = glm::dot(w, axis), across = glm::length(glm::cross(w, axis));
        const double sine = q.sine.s[k], cosine = std::sqrt(1 - sine * sine);
        const double reach = double(q.radius.s[k]) + s.s[3];
        if (z < 0 && across * sine < -z * cosine) return glm::length(w) <= reach;
        return across * cosine - z * sine <= reach;
    }

    // As the library counts them.
    rsh_statistics count() const;

private:
    void build() {
        rsh_build_desc desc{};
        desc.struct_size = sizeof desc;
        desc.rays = rays_.buffer()();
        desc.width = kFrame.width;
        desc.height = kFrame.height;
        desc.shape = RSH_SHAPE_CONE;
        rsh_sizes sizes{};
        sizes.struct_size = sizeof sizes;
        rsh::check(rsh_build_query(device_.rsh(), &desc, &sizes), "rsh_build_query");
        levels_ = rsh::cone_levels(desc.width, desc.height);
        nodes_ = cl::Buffer(device_.context(), CL_MEM_READ_WRITE, sizes.output_bytes);
        desc.nodes = nodes_();
        rsh::check(rsh_build(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                   "rsh_build");
        quads_.resize(levels_.first_child_group[levels_.count]);
        device_.queue().enqueueReadBuffer(nodes_, CL_TRUE, sizeof(nodes_head),
                                          quads_.size() * sizeof(cone_node4), quads_.data());
    }

    void bound() {
        spheres_.resize(triangle_count());
        const size_t bytes = spheres_.size() * sizeof(cl_float4);
        const cl::Buffer buffer(device_.context(), CL_MEM_READ_WRITE,
                                sizeof(spheres_head) + bytes);
        rsh_bound_desc desc{};
        desc.struct_size = sizeof desc;
        desc.geometry = scene_.geometry();
        desc.shape = RSH_SHAPE_CONE;
        desc.bounds = buffer();
        rsh::check(rsh_bound(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                   "rsh_bound");
        device_.queue().enqueueReadBuffer(buffer, CL_TRUE, sizeof(spheres_head), bytes,
                                          spheres_.data());
    }

    const Device& device_;
    FrameScene frame_;
    SceneOnDevice scene_;
    RayMaker rays_;
    ray_levels levels_{};
    cl::Buffer nodes_;
    std::vector<cone_node4> quads_;
    std::vector<cl_float4> spheres_;
};

rsh_statistics Hierarchy::count() const {
    rsh_traverse_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry = scene_.geometry();
    desc.rays = rays_.buffer()();
    desc.nodes = nodes_();
    desc.width = kFrame.width;
    desc.height = kFrame.height;
    desc.engine = RSH_ENGINE_PAPER_FAITHFUL;
    desc.shape = RSH_SHAPE_CONE;
    desc.budget = size_t{1} << 29;
    const cl::Buffer hits(device_.context(), CL_MEM_READ_WRITE,
                          kFrame.pixels() * sizeof(rsh_hit));
    desc.hits = hits();
    rsh::check(rsh_count_statistics(device_.rsh(), CL_TRUE), "rsh_count_statistics");
    rsh::check(rsh_traverse(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
               "rsh_traverse");
    rsh_statistics statistics{};
    statistics.struct_size = sizeof statistics;
    rsh::check(rsh_get_statistics(device_.rsh(), &statistics), "rsh_get_statistics");
    rsh::check(rsh_count_statistics(device_.rsh(), CL_FALSE), "rsh_count_statistics");
    return statistics;
}

cl_uint child_of(const ray_levels& levels, cl_uint level, cl_uint parent, int k) {
    const cl_uint x = parent % levels.width[level + 1], y = parent / levels.width[level + 1];
    return (2 * y + cl_uint(k >> 1)) * levels.width[level] + 2 * x + cl_uint(k & 1);
}

// As the engine calls it in its streams: kernels/traverse/paper_faithful/types.h.
cl_uint name_of(const ray_levels& levels, cl_uint level, cl_uint node) {
    if (level == 0) return node;
    return node / levels.width[level] << 16 | node % levels.width[level];
}

// One level of the traversal: its tested pairs. `pairs` become those that survive.
std::vector<StreamPair> descend(const Hierarchy& hierarchy, cl_uint level,
                                std::vector<HostPair>& pairs) {
    const ray_levels& levels = hierarchy.levels();
    std::vector<StreamPair> tested;
    std::vector<HostPair> survivors;
    tested.reserve(4 * pairs.size());
    for (const HostPair& pair : pairs)
        for (int k = 0; k < 4; ++k) {
            const cl_uint child = child_of(levels, level, pair.node, k);
            const bool survives = hierarchy.meets(level, pair, k);
            if (survives) survivors.push_back({pair.triangle, child});
            tested.push_back(
                {survives ? pair.triangle : RSH_NO_HIT, name_of(levels, level, child)});
        }
    pairs = std::move(survivors);
    return tested;
}

// Rounding may decide a few of them otherwise. Below a stream that outgrew the budget, the library
// does not count.
void require_close(const rsh_statistics& statistics, size_t found, cl_uint level) {
    const auto& walked = statistics.pairs_walked;
    if (std::any_of(std::begin(walked), std::end(walked), [](cl_ulong w) { return w > 0; }))
        return;
    const cl_ulong counted = statistics.pairs_tested[level];
    if (std::abs(double(found) - double(counted)) > 1e-3 * double(counted) + 8)
        throw std::runtime_error(fmt::format(
            "pairs of level {}: found {}, the library counts {}", level, found, counted));
}

// Level by level, from the coarsest to `lowest`.
void for_pair_levels(
    const Device& device, const std::string& scene, cl_uint lowest,
    const std::function<void(cl_uint level, const std::vector<StreamPair>& tested)>& use) {
    const Hierarchy hierarchy(device, scene);
    const rsh_statistics counted = hierarchy.count();
    std::vector<HostPair> pairs;
    for (cl_uint i = 0; i < hierarchy.triangle_count(); ++i) pairs.push_back({i, 0});
    for (cl_uint level = hierarchy.levels().count; level-- > lowest;) {
        const std::vector<StreamPair> tested = descend(hierarchy, level, pairs);
        require_close(counted, pairs.size(), level);
        use(level, tested);
    }
}

}  // namespace

bool has_scenes() {
    return kReadsSceneFiles && std::getenv("RSH_SCENES") != nullptr;
}

std::vector<cl_uchar> make_pair_flags(const Device& device, const std::string& pattern,
                                      size_t most) {
    const size_t colon = pattern.rfind(':');
    const cl_uint wanted = cl_uint(std::stoul(pattern.substr(colon + 1)));
    std::vector<cl_uchar> flags;
    for_pair_levels(device, pattern.substr(6, colon - 6), wanted,
                    [&](cl_uint level, const std::vector<StreamPair>& tested) {
                        if (level > wanted) return;
                        for (const StreamPair& pair : tested)
                            flags.push_back(pair.triangle != RSH_NO_HIT);
                    });
    if (flags.size() > most) flags.resize(most);
    return flags;
}

void dump_pair_streams(const Device& device, const std::string& scene,
                       const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for_pair_levels(
        device, scene, 0, [&](cl_uint level, const std::vector<StreamPair>& tested) {
            const auto path = folder / fmt::format("{}_level_{}.pairs", scene, level);
            write_pairs(path, tested);
            fmt::print("{}: {} pairs\n", path.string(), tested.size());
        });
}

}  // namespace bench
