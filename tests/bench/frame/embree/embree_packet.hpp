// embree_packet.hpp - a packet of rays in Embree's layout: loaded from neighbouring rsh_rays,
// traced, and its answers stored. Compiled for the machine at hand, as the calls into Embree
// deserve.
#pragma once

#include <embree3/rtcore.h>

#include "frame/ray_maker.hpp"

namespace bench {

template <int kWidth>
struct Packet;

template <>
struct Packet<16> {
    static constexpr int kColumns = 4, kRows = 4;
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;
    static void intersect(const int* valid, RTCScene s, RTCIntersectContext* c, RayHit* r) {
        rtcIntersect16(valid, s, c, r);
    }
    static void occlude(const int* valid, RTCScene s, RTCIntersectContext* c, Ray* r) {
        rtcOccluded16(valid, s, c, r);
    }
};

template <>
struct Packet<8> {
    static constexpr int kColumns = 4, kRows = 2;
    using Ray = RTCRay8;
    using RayHit = RTCRayHit8;
    static void intersect(const int* valid, RTCScene s, RTCIntersectContext* c, RayHit* r) {
        rtcIntersect8(valid, s, c, r);
    }
    static void occlude(const int* valid, RTCScene s, RTCIntersectContext* c, Ray* r) {
        rtcOccluded8(valid, s, c, r);
    }
};

// Indices of a packet's rays in the grid, and which of them are active.
template <int kWidth>
struct alignas(64) Lanes {
    int valid[kWidth];
    size_t ray[kWidth];
    bool any = false;

    Lanes(const std::vector<rsh_ray>& rays, Size size, cl_uint x0, cl_uint y0) {
        using P = Packet<kWidth>;
        for (int k = 0; k < kWidth; ++k) {
            const cl_uint x = x0 + static_cast<cl_uint>(k % P::kColumns);
            const cl_uint y = y0 + static_cast<cl_uint>(k / P::kColumns);
            const bool inside = x < size.width && y < size.height;
            ray[k] = inside ? size_t{y} * size.width + x : 0;
            const rsh_ray& r = rays[ray[k]];
            // What rsh_spawn leaves out has tmax = -1.
            valid[k] = inside && r.direction_tmax.s[3] >= r.origin_tmin.s[3] ? -1 : 0;
            any |= valid[k] != 0;
        }
    }
};

template <int kWidth, class Ray>
void load(const std::vector<rsh_ray>& rays, const Lanes<kWidth>& lanes, Ray& out) {
    for (int k = 0; k < kWidth; ++k) {
        const rsh_ray& r = rays[lanes.ray[k]];
        out.org_x[k] = r.origin_tmin.s[0];
        out.org_y[k] = r.origin_tmin.s[1];
        out.org_z[k] = r.origin_tmin.s[2];
        out.tnear[k] = r.origin_tmin.s[3];
        out.dir_x[k] = r.direction_tmax.s[0];
        out.dir_y[k] = r.direction_tmax.s[1];
        out.dir_z[k] = r.direction_tmax.s[2];
        out.tfar[k] = r.direction_tmax.s[3];
        out.time[k] = 0.0f;
        out.mask[k] = ~0u;
        out.flags[k] = 0;
    }
}

template <int kWidth>
void intersect_packet(RTCScene scene, RTCIntersectContext& context,
                      const std::vector<rsh_ray>& rays, const Lanes<kWidth>& lanes,
                      std::vector<rsh_hit>& hits) {
    alignas(64) typename Packet<kWidth>::RayHit packet;
    load<kWidth>(rays, lanes, packet.ray);
    for (int k = 0; k < kWidth; ++k) {
        packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.primID[k] = RSH_NO_HIT;
        packet.hit.u[k] = packet.hit.v[k] = 0.0f;
        packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    Packet<kWidth>::intersect(lanes.valid, scene, &context, &packet);
    for (int k = 0; k < kWidth; ++k)
        if (lanes.valid[k])
            hits[lanes.ray[k]] = {packet.ray.tfar[k], packet.hit.u[k], packet.hit.v[k],
                                  packet.hit.primID[k]};
}

// Embree sets tfar to minus infinity where something is hit.
template <int kWidth>
void occlude_packet(RTCScene scene, RTCIntersectContext& context,
                    const std::vector<rsh_ray>& rays, const Lanes<kWidth>& lanes,
                    std::vector<cl_uint>& masks) {
    alignas(64) typename Packet<kWidth>::Ray packet;
    load<kWidth>(rays, lanes, packet);
    Packet<kWidth>::occlude(lanes.valid, scene, &context, &packet);
    for (int k = 0; k < kWidth; ++k)
        if (lanes.valid[k]) masks[lanes.ray[k]] = packet.tfar[k] < 0.0f;
}

}  // namespace bench
