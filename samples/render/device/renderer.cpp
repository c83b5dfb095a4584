// renderer.cpp - the frame, strip by strip, its steps timed.
#include "device/renderer.hpp"

#include <algorithm>
#include <chrono>

#include "device/resident_memory.hpp"
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

Renderer::Renderer(const rsh::Device& device, World& world, const RenderSettings& settings)
    : device_(device),
      world_(world),
      settings_(settings),
      scene_(device, world, settings.without, settings.cut) {
    make_bounds();
    plan_ = plan_strips(device, frame_desc(), settings.budget);
    const size_t pixels = size_t{settings.size.x} * plan_.rows;
    colour_ = device.buffer(pixels * sizeof(rsh_float4));
    strip_.width = settings.size.x;
    strip_.pixels.resize(4 * pixels);
}

// Kept from frame to frame, so that the order of the triangles is not made anew for each.
void Renderer::make_bounds() {
    auto desc = rsh::make<rsh_bound_desc>();
    desc.geometry = scene_.scene().geometry;
    desc.shape = settings_.bound ? settings_.bound : rsh_engine_shape(settings_.engine);
    bounds_ = device_.buffer(device_.sizes_of(rsh_bound_query, desc).output_bytes);
}

rsh_frame_desc Renderer::frame_desc() const {
    const glm::vec2 size(settings_.size);
    auto desc = rsh::make<rsh_frame_desc>();
    desc.scene = &scene_.scene();
    desc.camera = device_camera(world_.camera(), size.x / size.y);
    desc.width = settings_.size.x;
    desc.height = settings_.size.y;
    desc.bounces = settings_.bounces;
    desc.min_weight = settings_.min_weight;
    desc.tolerance = settings_.tolerance;
    desc.engine = settings_.engine;
    desc.shape = settings_.bound;
    desc.strategy = settings_.strategy;
    desc.budget = plan_.frame_budget;
    desc.colour = colour_.get();
    desc.bounds = bounds_.get();
    desc.mode = has_bounds_ ? RSH_BOUND_REFIT : RSH_BOUND_QUALITY;
    return desc;
}

rsh_frame_desc Renderer::strip_desc(uint32_t first_row) const {
    rsh_frame_desc desc = frame_desc();
    desc.height = std::min(plan_.rows, settings_.size.y - first_row);
    desc.window = {0, first_row, settings_.size.x, settings_.size.y};
    return desc;
}

FrameMeasure Renderer::render(double time, rsh_progress progress, void* user,
                              const TakeStrip& take) {
    FrameMeasure measure;
    measure.time = time;
    Stopwatch watch;
    world_.move_to(time);
    measure.upload_bytes = scene_.update(world_);
    rsh::check_opencl(clFinish(device_.queue()), "clFinish");
    measure.upload_ms = watch.lap();

    rsh::check(rsh_count_statistics(device_.rsh(), settings_.counts), "rsh_count_statistics");
    for (uint32_t row = 0; row < settings_.size.y; row += plan_.rows) {
        rsh_frame_desc desc = strip_desc(row);
        desc.progress = progress;
        desc.progress_user = user;
        render_strip(desc, measure);
        read_strip(desc, measure);
        take(strip_);
    }
    measure.statistics.struct_size = sizeof measure.statistics;
    if (settings_.counts)
        rsh::check(rsh_get_statistics(device_.rsh(), &measure.statistics),
                   "rsh_get_statistics");
    measure.resident_bytes = resident_bytes();
    return measure;
}

void Renderer::render_strip(const rsh_frame_desc& desc, FrameMeasure& measure) {
    Stopwatch watch;
    const rsh::Event done = device_.run(rsh_frame, desc);
    const cl_event event = done.get();
    rsh::check_opencl(clWaitForEvents(1, &event), "clWaitForEvents");
    has_bounds_ = bounds_.get() != nullptr;
    measure.total_ms += watch.lap();
}

void Renderer::read_strip(const rsh_frame_desc& desc, FrameMeasure& measure) {
    Stopwatch watch;
    strip_.first_row = desc.window.y;
    strip_.rows = desc.height;
    device_.read(colour_.get(), strip_.pixels.data(), size_t{4} * desc.width * desc.height);
    measure.read_ms += watch.lap();
}

rsh_audit_report Renderer::audit(uint32_t rays, uint32_t seed, rsh_progress progress,
                                 void* user) {
    const rsh::Buffer found = device_.buffer(sizeof(rsh_audit_report));
    rsh_audit_report sum{};
    sum.first_ray = RSH_NO_HIT;
    for (uint32_t row = 0; row < settings_.size.y; row += plan_.rows) {
        rsh_frame_desc desc = strip_desc(row);
        desc.progress = progress;
        desc.progress_user = user;
        desc.audit_rays = rays;
        desc.audit_seed = seed;
        desc.audit = found.get();
        device_.run(rsh_frame, desc);
        const auto strip = device_.download<rsh_audit_report>(found.get(), 1)[0];
        if (sum.differences == 0) sum.first_ray = strip.first_ray;
        sum.rays += strip.rays;
        sum.differences += strip.differences;
        sum.missed += strip.missed;
        sum.spurious += strip.spurious;
        sum.wrong += strip.wrong;
    }
    return sum;
}

}  // namespace render
