#include "batches/seen_triangles.hpp"

#include <string>

#include "mesh/mesh.hpp"
#include "rays/levels.hpp"

namespace rsh {
namespace {

constexpr const char* kProgram = "batches/seen_triangles";

std::string part_name(const char* name, cl_uint wave) {
    return std::string("seen ") + name + ' ' + std::to_string(wave);
}

cl_uint rays_of(const rsh_traverse_desc& desc) {
    return static_cast<cl_uint>(ray_count(desc.width, desc.height));
}

}  // namespace

void reserve_seen(Layout& layout, cl_uint attributes, cl_uint wave, size_t rays) {
    const auto add = [&](const char* name, size_t words) {
        layout.add_array<cl_uint>(part_name(name, wave), words * rays);
    };
    add("corners", 9);
    if (attributes & RSH_BATCH_NORMALS) add("normals", 9);
    if (attributes & RSH_BATCH_TEXCOORDS) add("texcoords", 6);
    if (attributes & RSH_BATCH_MATERIAL_IDS) add("material ids", 1);
    add("numbers", 1);
}

SeenTriangles seen_triangles(const Scratch& scratch, cl_uint wave, cl_uint rays) {
    const auto part = [&](const char* name) { return scratch.find(part_name(name, wave)); };
    return {part("corners"),      part("normals"), part("texcoords"),
            part("material ids"), part("numbers"), rays};
}

rsh_scene scene_of(const rsh_scene& scene, const SeenTriangles& seen) {
    rsh_scene with_seen = scene;
    with_seen.geometry = {};
    with_seen.normal_stride = 0;
    with_seen.normals_offset = 0;
    with_seen.geometry.vertices = seen.corners;
    with_seen.geometry.vertex_count = 3 * seen.count;
    with_seen.geometry.triangle_count = seen.count;
    with_seen.normals = seen.normals;
    with_seen.texcoords = seen.texcoords;
    with_seen.material_ids = seen.material_ids;
    return with_seen;
}

void keep_seen(Recorder& recorder, const SceneBatch& batch, const BatchMemory& memory,
               const rsh_traverse_desc& rays, const SeenTriangles& seen) {
    recorder.launch(RSH_STAGE_OTHER, {kProgram, "rsh_keep_seen"},
                    recorder.stream_range(rays_of(rays)), mesh_view_of(batch.geometry),
                    batch.first_triangle, memory.positions, memory.indices, memory.normals,
                    memory.texcoords, memory.material_ids, rays_of(rays), rays.list_count,
                    rays.hits, seen.corners, seen.normals, seen.texcoords, seen.material_ids);
}

void number_seen(Recorder& recorder, const rsh_traverse_desc& rays, const SeenTriangles& seen) {
    recorder.launch(RSH_STAGE_OTHER, {kProgram, "rsh_number_seen"},
                    recorder.stream_range(rays_of(rays)), rays_of(rays), rays.list_count,
                    rays.hits, seen.numbers);
}

}  // namespace rsh
