#include "ablation/frame_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "support/placed_scene.hpp"

namespace bench::ablation {
namespace {

// Of a picture, in its middle: what brute force renders again.
constexpr cl_uint kSampleWidth = 32, kSampleHeight = 24;

}  // namespace

FrameWork::FrameWork(const Device& device, const FrameSetup& setup, cl_uint width,
                     cl_uint height)
    : Work(device) {
    queue_ = cl::CommandQueue(device.context(), device.device(),
                              setup.is_profiled ? CL_QUEUE_PROFILING_ENABLE : 0);
    place(setup.scene, setup.also);
    desc_ = rsh::make<rsh_frame_desc>();
    desc_.scene = &scene_;
    desc_.camera = test::look_at({0.4f, 2.2f, 5.5f}, {0, 0.8f, 0}, width, height);
    desc_.width = width;
    desc_.height = height;
    desc_.bounces = setup.bounces;
    desc_.min_weight = setup.min_weight;
    desc_.engine = RSH_ENGINE_TILES;
    desc_.audit_rays = setup.audit_rays;
    audit_ = buffer(setup.audit_rays ? sizeof(rsh_audit_report) : 0);
    desc_.audit = audit_();
    colour_ = buffer(size_t{width} * height * sizeof(cl_float4));
    desc_.colour = colour_();
    scratch_ = scratch_of(rsh_frame_query, desc_);
    desc_.scratch = scratch_();
}

void FrameWork::place(const test::Scene& scene, rsh_features also) {
    scene_ = test::placed(scene, [this](const auto& items) {
        buffers_.push_back(upload(items));
        return buffers_.back()();
    });
    rsh::check(rsh_find_features(&scene_, scene.materials.data(), scene.lights.data()),
               "rsh_find_features");
    scene_.features |= also;
    // A lamp that casts none: of a frame that is ready for shadows, all are asked about.
    if (also & RSH_FEATURE_SHADOW) scene_.shadow_lights = (1u << scene_.light_count) - 1;
}

void FrameWork::prepare(rsh_context context) const {
    rsh_prepare_desc prepared = rsh::make<rsh_prepare_desc>();
    prepared.frame = &desc_;
    rsh::check(rsh_prepare(context, &prepared), "rsh_prepare");
}

void FrameWork::run(rsh_context context) {
    rsh::check(rsh_frame(context, queue_(), &desc_, 0, nullptr, nullptr), "rsh_frame");
    queue_.finish();
}

std::vector<uint8_t> FrameWork::answer() const {
    std::vector<uint8_t> pixels;
    append(colour_, size_t{desc_.width} * desc_.height * sizeof(cl_float4), pixels);
    return pixels;
}

bool FrameWork::is_right(rsh_context context) const {
    rsh_frame_desc sample = desc_;
    sample.engine = RSH_ENGINE_BRUTE_FORCE;
    sample.width = std::min(kSampleWidth, desc_.width);
    sample.height = std::min(kSampleHeight, desc_.height);
    sample.window = {(desc_.width - sample.width) / 2, (desc_.height - sample.height) / 2,
                     desc_.width, desc_.height};
    sample.audit_rays = 0;
    sample.audit = nullptr;
    rsh_sizes sizes = rsh::make<rsh_sizes>();
    rsh::check(rsh_frame_query(context, &sample, &sizes), "rsh_frame_query");
    const size_t row = sample.width * sizeof(cl_float4);
    const cl::Buffer colour(device_.context(), CL_MEM_READ_WRITE, row * sample.height);
    const cl::Buffer scratch(device_.context(), CL_MEM_READ_WRITE, sizes.scratch_bytes);
    sample.colour = colour();
    sample.scratch = scratch();
    rsh::check(rsh_frame(context, queue_(), &sample, 0, nullptr, nullptr), "rsh_frame");
    std::vector<uint8_t> expected;
    append(colour, row * sample.height, expected);
    const std::vector<uint8_t> pixels = answer();
    for (size_t y = 0; y < sample.height; ++y) {
        const size_t first =
            ((sample.window.y + y) * desc_.width + sample.window.x) * sizeof(cl_float4);
        if (std::memcmp(&pixels[first], &expected[y * row], row) != 0) return false;
    }
    rsh_audit_report report = {};
    if (audit_()) queue_.enqueueReadBuffer(audit_, CL_TRUE, 0, sizeof report, &report);
    return report.differences == 0;
}

// The cut of rays that are not traced has a program of its own where the environment is an image.
std::string FrameWork::programs() const {
    return fmt::format("frame features:{:02x} lights:{:x} bounces:{} audit:{} cut:{} weight:{}",
                       scene_.features, scene_.shadow_lights, desc_.bounces > 0,
                       desc_.audit_rays > 0, scene_.cut, desc_.min_weight > 0);
}

}  // namespace bench::ablation
