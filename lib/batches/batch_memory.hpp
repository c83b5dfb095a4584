// batch_memory.hpp - where a batch of a scene lies on the device: how much memory it takes, and its parts.
#pragma once

#include <algorithm>

#include "device/cl/scratch.hpp"
#include "device/layout.hpp"

namespace rsh {

// The triangles of a batch: on the device, packed.
struct SceneBatch {
    cl_uint first_triangle;
    rsh_geometry geometry;
};

// What a call needs of the batches of a source.
struct BatchNeeds {
    const rsh_batch_source* source;
    cl_uint attributes;  // RSH_BATCH_... that are wanted
    cl_uint engine;
    cl_uint shape;
};

// The most triangles that a batch may have, by the source alone; of the scene, if that has fewer.
cl_uint most_batch_triangles(const rsh_batch_source& source);
// With fewer, a pass over the scene would be all overhead.
cl_uint least_batch_triangles(const rsh_batch_source& source);

// How many triangles from the least on, up to the most, take no more bytes than that; 0: not even the least.
template <class BytesOf>
cl_uint fitting_triangles(const rsh_batch_source& source, cl_ulong bytes, BytesOf bytes_of) {
    cl_uint most = most_batch_triangles(source), fits = 0;
    cl_uint tried = most;
    const cl_uint least = least_batch_triangles(source);
    while (fits < most) {
        if (bytes_of(tried) <= bytes)
            fits = tried;
        else if (tried == least)
            return 0;
        else
            most = tried - 1;
        tried = fits == 0 ? std::max(least, most / 2) : fits + (most - fits + 1) / 2;
    }
    return fits;
}

// Parts named "batch ...", for so many triangles.
void reserve_batch(Layout& layout, const Context& context, const BatchNeeds& needs,
                   cl_uint triangles);

struct BatchMemory {
    cl_mem positions, indices, normals, texcoords, material_ids;  // NULL: not wanted
    cl_mem bounds, bound_scratch;                                 // NULL: the engine takes none
    cl_uint triangles;                                            // that there is room for
};
BatchMemory batch_memory(const Scratch& scratch, cl_uint triangles);

}  // namespace rsh
