// renderer.cpp - the frame, its steps timed.
#include "device/renderer.hpp"

#include <chrono>

#include "scene/device_structs.hpp"

namespace render {
namespace {

class Stopwatch {
public:
    // Milliseconds since construction or the last lap.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double, std::milli> passed = now - last_;
        last_ = now;
        return passed.count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Renderer::Renderer(const Device& device, World& world, const RenderSettings& settings)
    : device_(device),
      world_(world),
      settings_(settings),
      scene_(device, world, settings.without, settings.cut),
      colour_(device.buffer(size_t{16} * settings.size.x * settings.size.y)),
      frame_{settings.size.x, settings.size.y,
             std::vector<float>(size_t{4} * settings.size.x * settings.size.y)} {
    make_bounds();
}

// Kept from frame to frame, so that the order of the triangles is not made anew for each.
void Renderer::make_bounds() {
    rsh_bound_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry = scene_.scene().geometry;
    desc.shape = settings_.bound ? settings_.bound : rsh_engine_shape(settings_.engine);
    rsh_sizes sizes{};
    sizes.struct_size = sizeof sizes;
    require(rsh_bound_query(device_.rsh(), &desc, &sizes), "rsh_bound_query");
    if (sizes.output_bytes > 0) bounds_ = device_.buffer(sizes.output_bytes);
}

rsh_frame_desc Renderer::frame_desc() const {
    const glm::vec2 size(settings_.size);
    rsh_frame_desc desc{};
    desc.struct_size = sizeof desc;
    desc.scene = &scene_.scene();
    desc.camera = device_camera(world_.camera(), size.x / size.y);
    desc.width = settings_.size.x;
    desc.height = settings_.size.y;
    desc.bounces = settings_.bounces;
    desc.min_weight = settings_.min_weight;
    desc.engine = settings_.engine;
    desc.shape = settings_.bound;
    desc.strategy = settings_.strategy;
    desc.budget = settings_.budget;
    desc.colour = colour_();
    desc.bounds = bounds_();
    desc.mode = has_bounds_ ? RSH_BOUND_REFIT : RSH_BOUND_QUALITY;
    return desc;
}

FrameMeasure Renderer::render(double time, rsh_progress progress, void* user) {
    FrameMeasure measure;
    measure.time = time;
    Stopwatch watch;
    world_.move_to(time);
    scene_.update(world_);
    device_.queue().finish();
    measure.upload_ms = watch.lap();

    rsh_frame_desc desc = frame_desc();
    desc.progress = progress;
    desc.progress_user = user;
    require(rsh_count_statistics(device_.rsh(), settings_.counts), "rsh_count_statistics");
    watch.lap();
    cl::Event done;
    require(rsh_frame(device_.rsh(), device_.queue()(), &desc, 0, nullptr, &done()),
            "rsh_frame");
    done.wait();
    has_bounds_ = bounds_() != nullptr;
    measure.total_ms = watch.lap();

    measure.statistics.struct_size = sizeof measure.statistics;
    if (settings_.counts)
        require(rsh_get_statistics(device_.rsh(), &measure.statistics), "rsh_get_statistics");
    watch.lap();
    device_.queue().enqueueReadBuffer(colour_, CL_TRUE, 0, frame_.pixels.size() * sizeof(float),
                                      frame_.pixels.data());
    measure.read_ms = watch.lap();
    return measure;
}

rsh_audit_report Renderer::audit(uint32_t rays, uint32_t seed, rsh_progress progress,
                                 void* user) {
    const cl::Buffer found = device_.buffer(sizeof(rsh_audit_report));
    rsh_frame_desc desc = frame_desc();
    desc.progress = progress;
    desc.progress_user = user;
    desc.audit_rays = rays;
    desc.audit_seed = seed;
    desc.audit = found();
    require(rsh_frame(device_.rsh(), device_.queue()(), &desc, 0, nullptr, nullptr),
            "rsh_frame");
    rsh_audit_report report{};
    device_.queue().enqueueReadBuffer(found, CL_TRUE, 0, sizeof report, &report);
    return report;
}

}  // namespace render
