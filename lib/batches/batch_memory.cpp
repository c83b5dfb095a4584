#include "batches/batch_memory.hpp"

#include <algorithm>

#include "bvh/scene_bounds.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

constexpr cl_uint kUsualBatch = 1u << 18, kLeastBatch = 1024;

}  // namespace

cl_uint most_batch_triangles(const rsh_batch_source& source) {
    const cl_uint most = source.batch_triangles ? source.batch_triangles : kUsualBatch;
    return std::min(most, source.triangle_count);
}

cl_uint least_batch_triangles(const rsh_batch_source& source) {
    return std::min(most_batch_triangles(source), kLeastBatch);
}

void reserve_batch(Layout& layout, const Context& context, const BatchNeeds& needs,
                   cl_uint triangles) {
    const auto add = [&](cl_uint attribute, const char* name, size_t bytes) {
        if (!attribute || (needs.attributes & attribute)) layout.add(name, triangles * bytes);
    };
    add(0, "batch positions", 3 * 3 * sizeof(cl_float));
    add(RSH_BATCH_INDICES, "batch indices", 3 * sizeof(cl_uint));
    add(RSH_BATCH_NORMALS, "batch normals", 3 * 3 * sizeof(cl_float));
    add(RSH_BATCH_TEXCOORDS, "batch texcoords", 3 * 2 * sizeof(cl_float));
    add(RSH_BATCH_MATERIAL_IDS, "batch material ids", sizeof(cl_uint));
    if (find_engine(needs.engine).node_shape() == RSH_SHAPE_DEFAULT) return;
    const SceneBounds& bounds = bounds_for(needs.shape);
    rsh_geometry geometry = {};
    geometry.triangle_count = triangles;
    layout.add("batch bounds", bounds.bytes_up_to(triangles));
    layout.add("batch bound scratch",
               bounds.scratch(context, geometry, RSH_BOUND_FAST).bytes());
}

BatchMemory batch_memory(const Scratch& scratch, cl_uint triangles) {
    return {scratch.find("batch positions"),     scratch.find("batch indices"),
            scratch.find("batch normals"),       scratch.find("batch texcoords"),
            scratch.find("batch material ids"),  scratch.find("batch bounds"),
            scratch.find("batch bound scratch"), triangles};
}

}  // namespace rsh
