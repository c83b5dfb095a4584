// check.cpp - the loop of rsh_frame, spelled out in public calls with a comparison per wave.
#include "device/check.hpp"

#include <fmt/format.h>

#include <cstring>
#include <vector>

#include "device/ray_sample.hpp"

namespace render {
namespace {

// The rays of one wave on the device, with their closest hits.
struct Wave {
    std::string name;
    cl::Buffer rays, hits, weights;  // no weights: all 1
    uint32_t depth = 0;
};

class FrameCheck {
public:
    FrameCheck(const Device& device, const rsh_frame_desc& frame, uint32_t ray_step)
        : device_(device), frame_(frame), ray_step_(ray_step) {
        pixels_ = size_t{frame.width} * frame.height;
    }

    CheckResult run() {
        bound();
        follow(rasterize());
        return result_;
    }

private:
    template <typename T>
    std::vector<T> read(const cl::Buffer& buffer, size_t count) const {
        std::vector<T> items(count);
        device_.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(T), items.data());
        return items;
    }

    cl::Buffer zeroes(size_t words) const {
        cl::Buffer buffer = device_.buffer(4 * words);
        device_.queue().enqueueFillBuffer(buffer, cl_uint{0}, 0, 4 * words);
        return buffer;
    }

    void bound() {
        rsh_bound_desc desc{};
        desc.struct_size = sizeof desc;
        desc.geometry = frame_.scene->geometry;
        desc.shape = bound_of();
        rsh_sizes sizes{};
        sizes.struct_size = sizeof sizes;
        require(rsh_bound_query(device_.rsh(), &desc, &sizes), "rsh_bound_query");
        bounds_ = device_.buffer(sizes.output_bytes);
        desc.bounds = bounds_();
        require(rsh_bound(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                "rsh_bound");
    }

    Wave rasterize() {
        Wave wave{"camera", device_.buffer(32 * pixels_), device_.buffer(16 * pixels_), {}, 0};
        rsh_rasterize_desc desc{};
        desc.struct_size = sizeof desc;
        desc.geometry = frame_.scene->geometry;
        desc.camera = frame_.camera;
        desc.width = frame_.width;
        desc.height = frame_.height;
        desc.rays = wave.rays();
        desc.hits = wave.hits();
        require(rsh_rasterize(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                "rsh_rasterize");
        compare_closest(wave, "rasterized ");
        return wave;
    }

    // A wave whose hits are known: traced again, shadows cast, its secondary waves followed.
    void follow(Wave wave) {
        wave.hits = device_.buffer(16 * pixels_);
        const cl::Buffer nodes = build(wave.rays);
        rsh_traverse_desc desc = traversal(wave.rays, frame_.width, frame_.height);
        desc.nodes = nodes();
        desc.hits = wave.hits();
        traverse(desc);
        compare_closest(wave, "");
        if (frame_.scene->features & RSH_FEATURE_SHADOW)
            for (cl_uint light = 0; light < frame_.scene->light_count; ++light)
                if (frame_.scene->shadow_lights >> light & 1) cast_shadows(wave, light);
        if (wave.depth == frame_.bounces) return;
        if (frame_.scene->features & RSH_FEATURE_REFLECTION)
            follow_secondary(wave, RSH_SPAWN_REFLECTION, "reflection");
        if (frame_.scene->features & RSH_FEATURE_REFRACTION)
            follow_secondary(wave, RSH_SPAWN_REFRACTION, "refraction");
    }

    rsh_spawn_desc spawning(const Wave& wave, cl_uint kind, const cl::Buffer& spawned) const {
        rsh_spawn_desc desc{};
        desc.struct_size = sizeof desc;
        desc.scene = frame_.scene;
        desc.kind = kind;
        desc.ray_count = static_cast<cl_uint>(pixels_);
        desc.rays = wave.rays();
        desc.hits = wave.hits();
        desc.weights = wave.weights();
        desc.min_weight = frame_.min_weight;
        desc.spawned_rays = spawned();
        return desc;
    }

    void spawn(const rsh_spawn_desc& desc) const {
        require(rsh_spawn(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                "rsh_spawn");
    }

    void follow_secondary(const Wave& wave, cl_uint kind, const char* name) {
        Wave next{fmt::format("{} {}", wave.depth == 0 ? "" : wave.name, name),
                  device_.buffer(32 * pixels_),
                  {},
                  device_.buffer(16 * pixels_),
                  wave.depth + 1};
        const cl::Buffer active = zeroes(1);
        rsh_spawn_desc desc = spawning(wave, kind, next.rays);
        desc.spawned_weights = next.weights();
        desc.active_count = active();
        spawn(desc);
        if (read<cl_uint>(active, 1)[0] > 0) follow(next);
    }

    void cast_shadows(const Wave& wave, cl_uint light) {
        const cl::Buffer rays = device_.buffer(32 * pixels_);
        rsh_spawn_desc desc = spawning(wave, RSH_SPAWN_SHADOW, rays);
        desc.light = light;
        spawn(desc);
        const cl::Buffer nodes = build(rays);
        const cl::Buffer occlusion = zeroes(pixels_);
        rsh_traverse_desc any = traversal(rays, frame_.width, frame_.height);
        any.nodes = nodes();
        any.query = RSH_QUERY_ANY;
        any.occlusion = occlusion();
        any.occlusion_bit = light;
        traverse(any);
        compare_occlusion(rays, occlusion, light, wave.name);
    }

    cl_uint bound_of() const {
        return frame_.shape ? frame_.shape : rsh_engine_shape(frame_.engine);
    }

    cl::Buffer build(const cl::Buffer& rays) const {
        rsh_build_desc desc{};
        desc.struct_size = sizeof desc;
        desc.rays = rays();
        desc.width = frame_.width;
        desc.height = frame_.height;
        desc.shape = bound_of();
        rsh_sizes sizes{};
        sizes.struct_size = sizeof sizes;
        require(rsh_build_query(device_.rsh(), &desc, &sizes), "rsh_build_query");
        cl::Buffer nodes = device_.buffer(sizes.output_bytes);
        desc.nodes = nodes();
        require(rsh_build(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                "rsh_build");
        // The caller's buffer handle must outlive the commands that use it.
        device_.queue().finish();
        return nodes;
    }

    rsh_traverse_desc traversal(const cl::Buffer& rays, size_t width, cl_uint height) const {
        rsh_traverse_desc desc{};
        desc.struct_size = sizeof desc;
        desc.geometry = frame_.scene->geometry;
        desc.bounds = bounds_();
        desc.shape = bound_of();
        desc.rays = rays();
        desc.width = static_cast<cl_uint>(width);
        desc.height = height;
        desc.engine = frame_.engine;
        desc.strategy = frame_.strategy;
        desc.budget = frame_.budget;
        return desc;
    }

    void traverse(const rsh_traverse_desc& desc) const {
        require(rsh_traverse(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
                "rsh_traverse");
        device_.queue().finish();
    }

    RaySample sample(const cl::Buffer& rays) const {
        return sample_rays(read<rsh_ray>(rays, pixels_), ray_step_);
    }

    cl::Buffer upload(const RaySample& sample) const {
        const size_t bytes = sample.rays.size() * sizeof(rsh_ray);
        cl::Buffer rays = device_.buffer(bytes);
        device_.queue().enqueueWriteBuffer(rays, CL_TRUE, 0, bytes, sample.rays.data());
        return rays;
    }

    template <typename Describe>
    void count(bool is_equal, Describe describe) {
        ++result_.hits;
        if (!is_equal && result_.differ++ == 0) result_.first = describe();
    }

    void compare_closest(const Wave& wave, const char* source) {
        const RaySample sampled = sample(wave.rays);
        if (sampled.rays.empty()) return;
        const cl::Buffer rays = upload(sampled);
        const cl::Buffer hits = device_.buffer(16 * sampled.rays.size());
        rsh_traverse_desc brute = traversal(rays, sampled.rays.size(), 0);
        brute.engine = RSH_ENGINE_BRUTE_FORCE;
        brute.hits = hits();
        traverse(brute);
        const auto found = read<rsh_hit>(wave.hits, pixels_);
        const auto expected = read<rsh_hit>(hits, sampled.rays.size());
        for (size_t i = 0; i < expected.size(); ++i) {
            const rsh_hit& hit = found[sampled.index[i]];
            count(std::memcmp(&hit, &expected[i], sizeof hit) == 0, [&] {
                return fmt::format(
                    "{}{} ray {}: triangle {:#x} at {}, by brute force {:#x} at {}", source,
                    wave.name, sampled.index[i], hit.primitive, hit.t, expected[i].primitive,
                    expected[i].t);
            });
        }
    }

    void compare_occlusion(const cl::Buffer& all_rays, const cl::Buffer& occlusion,
                           cl_uint light, const std::string& wave) {
        const RaySample sampled = sample(all_rays);
        if (sampled.rays.empty()) return;
        const cl::Buffer rays = upload(sampled);
        const cl::Buffer by_force = zeroes(sampled.rays.size());
        rsh_traverse_desc brute = traversal(rays, sampled.rays.size(), 0);
        brute.engine = RSH_ENGINE_BRUTE_FORCE;
        brute.query = RSH_QUERY_ANY;
        brute.occlusion = by_force();
        brute.occlusion_bit = light;
        traverse(brute);
        const auto found = read<cl_uint>(occlusion, pixels_);
        const auto expected = read<cl_uint>(by_force, sampled.rays.size());
        for (size_t i = 0; i < expected.size(); ++i) {
            const cl_uint mask = found[sampled.index[i]];
            count(mask == expected[i], [&] {
                return fmt::format(
                    "shadow ray {} of the {} rays to light {}: mask {}, by force {}",
                    sampled.index[i], wave, light, mask, expected[i]);
            });
        }
    }

    const Device& device_;
    rsh_frame_desc frame_;
    uint32_t ray_step_;
    size_t pixels_ = 0;
    cl::Buffer bounds_;
    CheckResult result_;
};

}  // namespace

CheckResult check_frame(const Device& device, const rsh_frame_desc& frame, uint32_t ray_step) {
    return FrameCheck(device, frame, ray_step).run();
}

}  // namespace render
