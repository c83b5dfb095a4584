#include "frame/build_rows.hpp"

#include <fmt/format.h>

#include "frame/checksum.hpp"
#include "timing.hpp"

namespace bench {
namespace {

void put_times(const Device& device, const RayMaker& rays, RshTracer& tracer, size_t pairs,
               nlohmann::json& metrics) {
    const size_t bytes = rays.size().pixels() * sizeof(rsh_ray);
    const cl::Buffer copy(device.context(), CL_MEM_READ_WRITE, bytes);
    const auto copy_rays = [&] {
        device.queue().enqueueCopyBuffer(rays.buffer(), copy, 0, 0, bytes);
        device.queue().finish();
    };
    const auto build = [&] { tracer.build(rays.buffer()); };
    copy_rays();  // the first one pays for the pages of `copy`
    PairedTimes times;
    for (size_t i = 0; i < pairs; ++i) times.run_pair(build, copy_rays);
    metrics.update({{"ms_build", times.base_ms().median},
                    {"ms_copy", times.work_ms().median},
                    {"build_over_copy", times.ratio().median},
                    {"build_over_copy_low", times.ratio().low},
                    {"build_over_copy_high", times.ratio().high}});
}

}  // namespace

std::string BuildRow::name() const {
    return fmt::format("frame/build/scene:{}/size:{}x{}/rays:{}", scene.name, size.width,
                       size.height, name_of(rays));
}

std::vector<BuildRow> build_rows() {
    const SceneSpec scene = {"room-floor-80k", Reflector::kFloor, 80000, "", false};
    return {{scene, {1024, 1024}, RayKind::kPrimary},
            {scene, {1024, 1024}, RayKind::kReflection}};
}

std::string case_name(const BuildRow& row, const Column& column) {
    return fmt::format("{}/{}", row.name(), column.name());
}

// The hierarchy is right when the hits found with it are.
Case measure_build(const Device& device, SceneOnDevice& scene, const BuildRow& row,
                   const Column& column, size_t pairs) {
    scene.move(0.3);
    RayMaker rays(device, row.size);
    rays.make(scene, row.rays);
    RshTracer tracer(device, scene.geometry(), row.size, RSH_QUERY_CLOSEST, column);
    tracer.allocate();
    tracer.trace(rays.buffer());
    const std::vector<rsh_hit> hits = tracer.hits();
    const size_t mismatches = tracer.mismatches();
    Case result = {case_name(row, column),
                   {{"scene", row.scene.name},
                    {"triangles", scene.geometry().triangle_count},
                    {"width", row.size.width},
                    {"height", row.size.height},
                    {"rays", name_of(row.rays)},
                    {"active_rays", rays.active_count()},
                    {"engine", column.engine_name},
                    {"bound", column.bound_name},
                    {"vector_width", column.vector_width}},
                   {{"mismatches", mismatches}, {"hits_checksum", checksum(hits)}},
                   mismatches == 0};
    if (result.ok) put_times(device, rays, tracer, pairs, result.metrics);
    return result;
}

}  // namespace bench
