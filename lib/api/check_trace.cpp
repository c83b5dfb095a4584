// check_trace.cpp - from triangles and rays to answers in one call.
#include "api/check_fields.hpp"
#include "bvh/scene_bounds.hpp"
#include "rays/levels.hpp"
#include "rays/pack_rays.hpp"
#include "trace/trace.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

// The names of an array and of its members.
struct FloatsNames {
    const char *buffer, *offset, *stride, *reserved;
};
#define RSH_FLOATS_NAMES(name) \
    { name ".buffer", name ".offset", name ".stride", name ".reserved" }
constexpr FloatsNames kOrigins = RSH_FLOATS_NAMES("origins");
constexpr FloatsNames kDirections = RSH_FLOATS_NAMES("directions");
constexpr FloatsNames kTmin = RSH_FLOATS_NAMES("tmin");
constexpr FloatsNames kTmax = RSH_FLOATS_NAMES("tmax");
#undef RSH_FLOATS_NAMES

void check_floats(const FloatsNames& names, const rsh_ray_floats& floats, cl_uint bytes) {
    require(floats.offset % 4 == 0, names.offset, floats.offset, "a multiple of 4");
    require(floats.stride == 0 || (floats.stride >= bytes && floats.stride % 4 == 0),
            names.stride, floats.stride, "0 or a multiple of 4, at least ", bytes);
    check_reserved(names.reserved, &floats.reserved, 1);
}

// All of them, with `use(names, floats, bytes)`.
template <class Use>
void for_each_floats(const rsh_trace_desc& desc, Use use) {
    use(kOrigins, desc.origins, kVectorBytes);
    use(kDirections, desc.directions, kVectorBytes);
    use(kTmin, desc.tmin, kNumberBytes);
    use(kTmax, desc.tmax, kNumberBytes);
}

bool has_hits(const rsh_trace_desc& desc) {
    return desc.query == RSH_QUERY_CLOSEST || desc.query == RSH_QUERY_ALL;
}

void check_ray_buffers(Buffers& buffers, const rsh_trace_desc& desc, cl_ulong rays) {
    if (desc.rays) {
        buffers.in("rays", desc.rays, rays * sizeof(rsh_ray));
        return;
    }
    if (rays == 0) return;
    require_not_null(desc.origins.buffer, "rays, and origins.buffer");
    require_not_null(desc.directions.buffer, kDirections.buffer);
    for_each_floats(
        desc, [&](const FloatsNames& names, const rsh_ray_floats& floats, cl_uint bytes) {
            buffers.optional_in(names.buffer, floats.buffer,
                                (rays - 1) * stride_of(floats, bytes) + bytes, floats.offset);
        });
}

void check_batches(const rsh_trace_desc& desc) {
    check_source(*desc.batches, desc.geometry);
    require(desc.query <= RSH_QUERY_ANY, "query", desc.query,
            "RSH_QUERY_CLOSEST or RSH_QUERY_ANY with batches");
    require(!desc.continued, "continued", desc.continued, "0 with batches");
    require(!desc.first_triangle, "first_triangle", desc.first_triangle, "0 with batches");
    refuse(desc.bounds, "bounds", "batches");
}

// Of hits, some of which are of triangles that are not there.
void refuse_descriptions(const rsh_trace_desc& desc, const char* with) {
    refuse(desc.normals, "normals", with);
    refuse(desc.points, "points", with);
    refuse(desc.geometry_ids, "geometry_ids", with);
}

}  // namespace

void check_shape(const rsh_trace_desc& desc) {
    check_shape(trace_traverse(desc));
    if (desc.batches) check_batches(desc);
    if (desc.batches) refuse_descriptions(desc, "batches");
    if (desc.continued || desc.first_triangle)
        refuse_descriptions(desc, "continued or first_triangle");
    require(desc.converging <= 1, "converging", desc.converging, "0 or 1");
    for_each_floats(desc,
                    [&](const FloatsNames& names, const rsh_ray_floats& floats, cl_uint bytes) {
                        check_floats(names, floats, bytes);
                        if (desc.rays) refuse(floats.buffer, names.buffer, "rays");
                    });
    if (has_hits(desc)) return;
    refuse_descriptions(desc, "a query that lists no hits");
}

void check_buffers(const Context& context, const rsh_trace_desc& desc) {
    Buffers buffers(context);
    const rsh_traverse_desc pass = trace_traverse(desc);
    const cl_ulong rays = ray_count(desc.width, desc.height);
    check_buffers(buffers, desc.geometry);
    check_ray_buffers(buffers, desc, rays);
    buffers.optional_in("list_count", desc.list_count, 4);
    check_skip(buffers, pass);
    if (desc.batches && desc.skip) require_not_null(desc.skip_corners, "skip_corners");
    buffers.optional_in("ray_masks", desc.ray_masks, rays * 4);
    if (find_engine(desc.engine).node_shape() != RSH_SHAPE_DEFAULT)
        buffers.optional_in("bounds", desc.bounds, bounds_for(pass.shape).bytes(desc.geometry));
    check_answers(buffers, pass);
    const cl_ulong hits = answer_bytes(pass) / sizeof(rsh_hit);
    buffers.optional_out("normals", desc.normals, hits * kVectorBytes);
    buffers.optional_out("points", desc.points, hits * kVectorBytes);
    buffers.optional_out("geometry_ids", desc.geometry_ids, hits * sizeof(cl_uint));
    buffers.scratch(desc.scratch, trace_scratch(context, desc).bytes());
}

}  // namespace rsh
