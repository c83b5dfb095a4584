// seen_triangles.hpp - the triangles that the rays of a wave hit, as a mesh of their own: what shading and
// later rays need of a scene that comes in batches. Triangle i is that of ray i.
#pragma once

#include "batches/batch_memory.hpp"
#include "device/cl/recorder.hpp"

namespace rsh {

struct SeenTriangles {
    cl_mem corners, normals, texcoords, material_ids;  // NULL but for corners: not wanted
    cl_mem numbers;                                    // in the scene
    cl_uint count;
};

// Parts for that many rays of a wave; RSH_BATCH_... attributes that are wanted.
void reserve_seen(Layout& layout, cl_uint attributes, cl_uint wave, size_t rays);
SeenTriangles seen_triangles(const Scratch& scratch, cl_uint wave, cl_uint rays);
// The scene with these triangles.
rsh_scene scene_of(const rsh_scene& scene, const SeenTriangles& seen);

// Takes from a batch what closest hits name of it.
void keep_seen(Recorder& recorder, const SceneBatch& batch, const BatchMemory& memory,
               const rsh_traverse_desc& rays, const SeenTriangles& seen);
// After the last batch: hits name places of these triangles from now on.
void number_seen(Recorder& recorder, const rsh_traverse_desc& rays, const SeenTriangles& seen);

}  // namespace rsh
