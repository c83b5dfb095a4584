// check_fields.hpp - checks of fields that several descriptors have. The files check_*.cpp
// alone include it.
#pragma once

#include "api/buffers.hpp"
#include "api/check.hpp"

namespace rsh {

// Rays of one call. Rounded up to whole work-groups, their number still fits 32 bits.
constexpr cl_uint kMaxRays = 1u << 28;
constexpr cl_uint kMaxSide = 16384;

void check_buffers(Buffers& buffers, const rsh_geometry& geometry);
void check_buffers(Buffers& buffers, const rsh_scene& scene);
// Triangles that come in batches, in place of these.
void check_source(const rsh_batch_source& source, const rsh_geometry& geometry);
void refuse(const void* given, const char* field, const char* with);
// The triangles that rays have left.
void check_skip(Buffers& buffers, const rsh_traverse_desc& desc);
// What a traversal is to find.
void check_answers(Buffers& buffers, const rsh_traverse_desc& desc);

// Words that this version of the interface gives no meaning.
void check_reserved(const char* field, const cl_uint* words, size_t count);
void check_vector(const char* field, const rsh_float4& v);
// A grid, or a list when height is 0 or 1.
void check_ray_grid(cl_uint width, cl_uint height);
void check_budget(size_t budget);
void check_min_weight(float weight);

// A list may be shorter than the host knows.
template <class Desc>
void check_list_count(const Desc& desc) {
    require(!desc.list_count || desc.height <= 1, "height", desc.height,
            "0 or 1 with a list_count");
}

}  // namespace rsh
