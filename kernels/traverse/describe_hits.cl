/* describe_hits.cl - what else a caller wants to know of hits: their normals, points and meshes.
 *   ranges, range_count  in   the meshes; range_count 0: one, with id 0
 *   list_count           in   how many rays of ray_count there are; NULL: all
 *   hit_offsets          in   all: where each ray's hits begin, the last: how many there are; NULL:
 *                        closest, one per ray
 *   most                 all: hits that there is room for: if there are more, there are none
 *   hits                 in
 *   normals              out  three floats per hit, 0 of a miss; NULL: nobody wants them
 *   points               out  three floats per hit, NaN of a miss; NULL: likewise
 *   geometry_ids         out  one per hit, RSH_NO_HIT of a miss; NULL: likewise
 */
#define RSH_MESH_RANGES
#include "lanes/stride.h"
#include "mesh/algebra_lanes.h"
#include "mesh/mesh_ranges.h"
#include "rays/levels.h"

/* A triangle per lane. */
typedef struct triangle_lanes {
    float3v v0, v1, v2;
} triangle_lanes;

/* Of `count` hits; lanes without a triangle are 0 or NaN. */
static triangle_lanes load_triangles(mesh_view mesh, __global const float* vertices,
                                     __global const uint* indices, __global const rsh_hit* hits,
                                     uint count)
{
    float row[9][RSH_WIDTH];
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const uint triangle = k < count ? hits[k].primitive : RSH_NO_HIT;
        triangle_points p = {(float3)(0.0f), (float3)(0.0f), (float3)(0.0f)};
        if (triangle < mesh.triangle_count)
            load_triangle(mesh, vertices, indices, triangle, &p);
        const float3 corner[3] = {p.v0, p.v1, p.v2};
        for (uint i = 0; i < 3; ++i) {
            row[3 * i][k] = corner[i].x;
            row[3 * i + 1][k] = corner[i].y;
            row[3 * i + 2][k] = corner[i].z;
        }
    }
    return (triangle_lanes){{load_lanes(row[0]), load_lanes(row[1]), load_lanes(row[2])},
                            {load_lanes(row[3]), load_lanes(row[4]), load_lanes(row[5])},
                            {load_lanes(row[6]), load_lanes(row[7]), load_lanes(row[8])}};
}

static floatv distance_of(float3v a, float3v b) { return largest_v(fabs_v(minus_v(a, b))); }

/* As from_shortest_edges of mesh/plane.h. */
static triangle_lanes from_shortest_edges_v(triangle_lanes p)
{
    const floatv opposite0 = distance_of(p.v2, p.v1), opposite1 = distance_of(p.v0, p.v2),
                 opposite2 = distance_of(p.v1, p.v0);
    const intv is0 = (opposite0 >= opposite1) & (opposite0 >= opposite2);
    const intv is1 = opposite1 >= opposite2;
    return (triangle_lanes){select_v(select_v(p.v2, p.v1, is1), p.v0, is0),
                            select_v(select_v(p.v0, p.v2, is1), p.v1, is0),
                            select_v(select_v(p.v1, p.v0, is1), p.v2, is0)};
}

/* Unit, (v1 - v0) x (v2 - v0) by direction: the products in twice the precision of a float. 0 where there
 * is none. */
static float3v normals_of(triangle_lanes given)
{
    const triangle_lanes p = from_shortest_edges_v(given);
    const twofold3v a = exact_sum3_v(p.v1, opposite_v(p.v0));
    const twofold3v b = exact_sum3_v(p.v2, opposite_v(p.v0));
    const floatv extent = fmax(largest_v(fabs_v(a.high)), largest_v(fabs_v(b.high)));
    const floatv scale = scale_to_one_v(extent);
    return unit_v(twofold_cross_v(twofold_scaled_v(scale, a), twofold_scaled_v(scale, b)).high);
}

/* Where on their triangles `count` hits are. */
static float3v points_of(triangle_lanes p, __global const rsh_hit* hits, uint count,
                         uint triangle_count)
{
    float row[2][RSH_WIDTH];
    for (uint k = 0; k < RSH_WIDTH; ++k) {
        const bool is_hit = k < count && hits[k].primitive < triangle_count;
        row[0][k] = is_hit ? hits[k].u : NAN;
        row[1][k] = is_hit ? hits[k].v : NAN;
    }
    return sum_v(
        p.v0, barycentric_offset_v(p.v0, p.v1, p.v2, load_lanes(row[0]), load_lanes(row[1])));
}

static void store_vectors(float3v vector, uint count, __global float* vectors)
{
    float row[3][RSH_WIDTH];
    store_lanes(vector.x, row[0]);
    store_lanes(vector.y, row[1]);
    store_lanes(vector.z, row[2]);
    for (uint k = 0; k < count; ++k)
        vstore3((float3)(row[0][k], row[1][k], row[2][k]), k, vectors);
}

/* Of `count` hits; both may be NULL. */
static void store_normals_and_points(mesh_view mesh, __global const float* vertices,
                                     __global const uint* indices, __global const rsh_hit* hits,
                                     uint count, __global float* normals,
                                     __global float* points)
{
    if (!normals && !points) return;
    const triangle_lanes triangles = load_triangles(mesh, vertices, indices, hits, count);
    if (normals) store_vectors(normals_of(triangles), count, normals);
    if (points)
        store_vectors(points_of(triangles, hits, count, mesh.triangle_count), count, points);
}

static uint hits_of(uint ray_count, __global const uint* list_count,
                    __global const ulong* hit_offsets, uint most)
{
    if (!hit_offsets) return counted_rays(ray_count, list_count);
    const ulong total = hit_offsets[ray_count];
    return total > most ? 0 : (uint)total;
}

static uint id_of(__global const rsh_mesh_range* ranges, uint range_count, uint triangle)
{
    return range_count ? ranges[range_of(ranges, range_count, triangle)].id : 0;
}

__kernel void rsh_describe_hits(mesh_view mesh, __global const float* vertices,
                                __global const uint* indices,
                                __global const rsh_mesh_range* ranges, uint range_count,
                                uint ray_count, __global const uint* list_count,
                                __global const ulong* hit_offsets, uint most,
                                __global const rsh_hit* hits, __global float* normals,
                                __global float* points, __global uint* geometry_ids)
{
    const strided_range mine = my_blocks(hits_of(ray_count, list_count, hit_offsets, most));
    for (uint i = mine.begin; i < mine.end; i += RSH_WIDTH * mine.step) {
        const uint count = min((uint)RSH_WIDTH, mine.end - i);
        store_normals_and_points(mesh, vertices, indices, hits + i, count,
                                 normals ? normals + 3ul * i : 0,
                                 points ? points + 3ul * i : 0);
        for (uint k = 0; geometry_ids && k < count; ++k) {
            const uint triangle = hits[i + k].primitive;
            geometry_ids[i + k] = triangle < mesh.triangle_count
                                      ? id_of(ranges, range_count, triangle)
                                      : RSH_NO_HIT;
        }
    }
}
