#include "paper/frame.hpp"

#include <algorithm>

#include "timing.hpp"

namespace bench::paper {

double FrameWork::ms() const {
    return stage_ms[RSH_STAGE_BOUND] + stage_ms[RSH_STAGE_BUILD] + stage_ms[RSH_STAGE_TEST] +
           stage_ms[RSH_STAGE_REDUCE] + stage_ms[RSH_STAGE_INTERSECT];
}

double FrameWork::batches() const {
    return double(statistics.batches) / double(std::max<cl_ulong>(statistics.traversals, 1));
}

Frame::Frame(const Device& device, const FrameSettings& settings) : device_(device) {
    desc_ = rsh::make<rsh_frame_desc>();
    desc_.width = settings.size.width;
    desc_.height = settings.size.height;
    desc_.bounces = settings.bounces;
    desc_.engine = settings.engine;
    desc_.strategy = settings.strategy;
    desc_.budget = settings.budget;
}

void Frame::place(const rsh_scene& scene, const rsh_camera& camera) {
    scene_ = scene;
    desc_.scene = &scene_;
    desc_.camera = camera;
}

void Frame::take_batches(const rsh_batch_source& source) {
    scene_.geometry = {};
    scene_.normals = scene_.texcoords = scene_.material_ids = nullptr;
    if (!(source.attributes & RSH_BATCH_NORMALS)) scene_.features &= ~RSH_FEATURE_SMOOTH_NORMAL;
    desc_.batches = &source;
}

std::vector<NamedBytes> Frame::needs() {
    rsh_sizes sizes = rsh::make<rsh_sizes>();
    rsh::check(rsh_frame_query(device_.rsh(), &desc_, &sizes), "rsh_frame_query");
    scratch_bytes_ = sizes.scratch_bytes;
    return {{"the scratch memory", scratch_bytes_},
            {"the picture", size_t{desc_.width} * desc_.height * sizeof(cl_float4)}};
}

void Frame::allocate() {
    const auto make = [&](size_t bytes) {
        return cl::Buffer(device_.context(), CL_MEM_READ_WRITE, std::max<size_t>(bytes, 1));
    };
    const std::vector<NamedBytes> all = needs();
    scratch_ = make(all[0].bytes);
    colour_ = make(all[1].bytes);
    desc_.scratch = scratch_();
    desc_.colour = colour_();
}

double Frame::render() {
    return milliseconds([&] {
        rsh::check(rsh_frame(device_.rsh(), device_.queue()(), &desc_, 0, nullptr, nullptr),
                   "rsh_frame");
        device_.queue().finish();
    });
}

FrameWork Frame::count() {
    FrameWork work;
    rsh::check(rsh_count_statistics(device_.rsh(), CL_TRUE), "rsh_count_statistics");
    work.frame_ms = render();
    work.statistics = rsh::make<rsh_statistics>();
    rsh::check(rsh_get_statistics(device_.rsh(), &work.statistics), "rsh_get_statistics");
    rsh::check(rsh_count_statistics(device_.rsh(), CL_FALSE), "rsh_count_statistics");
    for (size_t i = 0; i < work.stage_ms.size(); ++i)
        work.stage_ms[i] = 1e-6 * double(work.statistics.stage_ns[i]);
    return work;
}

std::vector<cl_float4> Frame::pixels() const {
    std::vector<cl_float4> found(size_t{desc_.width} * desc_.height);
    device_.queue().enqueueReadBuffer(colour_, CL_TRUE, 0, found.size() * sizeof(cl_float4),
                                      found.data());
    return found;
}

rsh_audit_report Frame::audit(double tests_per_wave) {
    const cl::Buffer found(device_.context(), CL_MEM_READ_WRITE, sizeof(rsh_audit_report));
    const double triangles = std::max<double>(scene_.geometry.triangle_count, 1);
    desc_.audit = found();
    desc_.audit_rays =
        static_cast<cl_uint>(std::clamp(tests_per_wave / triangles, 32.0, 4096.0));
    render();
    desc_.audit = nullptr;
    desc_.audit_rays = 0;
    rsh_audit_report report{};
    device_.queue().enqueueReadBuffer(found, CL_TRUE, 0, sizeof report, &report);
    return report;
}

}  // namespace bench::paper
