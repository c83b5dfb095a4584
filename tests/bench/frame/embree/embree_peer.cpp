// embree_peer.cpp - scene, builds, and the parallel loop over tiles of rays.
#include "frame/embree/embree_peer.hpp"

#include <fmt/format.h>
#include <pmmintrin.h>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>
#include <xmmintrin.h>

#include <stdexcept>

#include "frame/embree/embree_packet.hpp"

namespace bench {
namespace {

RTCBuildQuality quality_of(EmbreeBuild build) {
    if (build == EmbreeBuild::kLow) return RTC_BUILD_QUALITY_LOW;
    return build == EmbreeBuild::kMedium ? RTC_BUILD_QUALITY_MEDIUM : RTC_BUILD_QUALITY_REFIT;
}

// Embree's manual asks for both, for speed.
class FlushDenormals {
public:
    FlushDenormals() : before_(_mm_getcsr()) {
        _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
        _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    unsigned before_;
};

RTCIntersectContext make_context(bool is_coherent) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = is_coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

// Calls work(x, y) for the first ray of every `columns` x `rows` block.
template <class Work>
void for_blocks(tbb::task_arena& arena, Size size, cl_uint columns, cl_uint rows,
                const Work& work) {
    constexpr cl_uint kTile = 32;
    const cl_uint across = (size.width + kTile - 1) / kTile;
    const cl_uint down = (size.height + kTile - 1) / kTile;
    const auto do_tile = [&](cl_uint x0, cl_uint y0) {
        for (cl_uint y = y0; y < std::min(y0 + kTile, size.height); y += rows)
            for (cl_uint x = x0; x < std::min(x0 + kTile, size.width); x += columns) work(x, y);
    };
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range2d<cl_uint>(0, down, 1, 0, across, 1),
            [&](const tbb::blocked_range2d<cl_uint>& tiles) {
                const FlushDenormals flush;
                for (cl_uint y = tiles.rows().begin(); y < tiles.rows().end(); ++y)
                    for (cl_uint x = tiles.cols().begin(); x < tiles.cols().end(); ++x)
                        do_tile(x * kTile, y * kTile);
            });
    });
}

template <int kWidth, class Answers, class Trace>
void trace_packets(tbb::task_arena& arena, const EmbreeRays& rays, bool is_coherent,
                   Answers& answers, const Trace& trace) {
    for_blocks(arena, rays.size, Packet<kWidth>::kColumns, Packet<kWidth>::kRows,
               [&](cl_uint x, cl_uint y) {
                   const Lanes<kWidth> lanes(rays.rays, rays.size, x, y);
                   if (!lanes.any) return;
                   RTCIntersectContext context = make_context(is_coherent);
                   trace(context, lanes, answers);
               });
}

RTCRay single(const rsh_ray& ray) {
    RTCRay out{};
    out.org_x = ray.origin_tmin.s[0];
    out.org_y = ray.origin_tmin.s[1];
    out.org_z = ray.origin_tmin.s[2];
    out.tnear = ray.origin_tmin.s[3];
    out.dir_x = ray.direction_tmax.s[0];
    out.dir_y = ray.direction_tmax.s[1];
    out.dir_z = ray.direction_tmax.s[2];
    out.tfar = ray.direction_tmax.s[3];
    out.mask = ~0u;
    return out;
}

rsh_hit intersect_single(RTCScene scene, const rsh_ray& ray) {
    RTCIntersectContext context = make_context(false);
    alignas(64) RTCRayHit query{};
    query.ray = single(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.primID = RSH_NO_HIT;
    rtcIntersect1(scene, &context, &query);
    return {query.ray.tfar, query.hit.u, query.hit.v, query.hit.primID};
}

bool occlude_single(RTCScene scene, const rsh_ray& ray) {
    RTCIntersectContext context = make_context(false);
    alignas(64) RTCRay query = single(ray);
    rtcOccluded1(scene, &context, &query);
    return query.tfar < 0.0f;
}

template <class Work>
void for_rays(tbb::task_arena& arena, const EmbreeRays& rays, const Work& work) {
    for_blocks(arena, rays.size, 1, 1, [&](cl_uint x, cl_uint y) {
        const size_t i = size_t{y} * rays.size.width + x;
        const rsh_ray& ray = rays.rays[i];
        if (ray.direction_tmax.s[3] >= ray.origin_tmin.s[3]) work(i, ray);
    });
}

}  // namespace

const char* name_of(EmbreeBuild build) {
    constexpr const char* kNames[] = {"low", "medium", "refit"};
    return kNames[static_cast<int>(build)];
}

// A refitted geometry is the only one of a scene that is itself built anew at low quality.
EmbreePeer::EmbreePeer(const EmbreeMesh& mesh, EmbreeBuild build, bool is_robust,
                       unsigned threads)
    : device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())),
      arena_(static_cast<int>(threads)) {
    if (!device_) throw std::runtime_error("rtcNewDevice failed");
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), is_robust ? RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST
                                             : RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_.get(), build == EmbreeBuild::kMedium
                                              ? RTC_BUILD_QUALITY_MEDIUM
                                              : RTC_BUILD_QUALITY_LOW);
    geometry_ = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry_, quality_of(build));
    rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               mesh.positions, 0, 3 * sizeof(float), mesh.vertex_count);
    rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh.triangles, 0, 3 * sizeof(cl_uint), mesh.triangle_count);
    rtcCommitGeometry(geometry_);
    rtcAttachGeometry(scene_.get(), geometry_);
    rtcReleaseGeometry(geometry_);
    rtcCommitScene(scene_.get());
}

void EmbreePeer::build() {
    rtcUpdateGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
        throw std::runtime_error("Embree could not build the scene");
}

void EmbreePeer::trace(const EmbreeRays& rays, PacketMode mode, std::vector<rsh_hit>& hits) {
    const auto packet = [&](RTCIntersectContext& context, const auto& lanes, auto& answers) {
        intersect_packet(scene_.get(), context, rays.rays, lanes, answers);
    };
    if (mode.width == 16)
        return trace_packets<16>(arena_, rays, mode.is_coherent, hits, packet);
    if (mode.width == 8) return trace_packets<8>(arena_, rays, mode.is_coherent, hits, packet);
    for_rays(arena_, rays, [&](size_t i, const rsh_ray& ray) {
        hits[i] = intersect_single(scene_.get(), ray);
    });
}

void EmbreePeer::occlude(const EmbreeRays& rays, PacketMode mode, std::vector<cl_uint>& masks) {
    const auto packet = [&](RTCIntersectContext& context, const auto& lanes, auto& answers) {
        occlude_packet(scene_.get(), context, rays.rays, lanes, answers);
    };
    if (mode.width == 16)
        return trace_packets<16>(arena_, rays, mode.is_coherent, masks, packet);
    if (mode.width == 8) return trace_packets<8>(arena_, rays, mode.is_coherent, masks, packet);
    for_rays(arena_, rays, [&](size_t i, const rsh_ray& ray) {
        masks[i] = occlude_single(scene_.get(), ray);
    });
}

rsh_hit EmbreePeer::trace_one(const rsh_ray& ray) const {
    return intersect_single(scene_.get(), ray);
}

}  // namespace bench
