/* plane.h - the edges of a triangle and the normal of its plane, in twice the precision of a
 * float; see mesh/twofold.h. */
#ifndef RSH_MESH_PLANE_H
#define RSH_MESH_PLANE_H

#include "mesh/twofold.h"

typedef struct scaled_edges {
    twofold3 edge1, edge2; /* v1 - v0, v2 - v0, scaled: the largest component is 1 .. 2 */
    float extent;          /* that largest component, in the world */
    float scale;           /* 0, as are the edges: that is 0 or not finite */
} scaled_edges;

static scaled_edges edges_of(triangle_points p)
{
    scaled_edges edges;
    const twofold3 edge1 = exact_sum3(p.v1, -p.v0), edge2 = exact_sum3(p.v2, -p.v0);
    edges.extent = fmax(largest3(fabs(edge1.high)), largest3(fabs(edge2.high)));
    const bool has_size = edges.extent > 0.0f && !isinf(edges.extent);
    edges.scale = has_size ? scale_to_one(edges.extent) : 0.0f;
    edges.edge1 = has_size ? twofold_scaled(edges.scale, edge1) : twofold3_of((float3)(0.0f));
    edges.edge2 = has_size ? twofold_scaled(edges.scale, edge2) : twofold3_of((float3)(0.0f));
    return edges;
}

/* The plane of a triangle. Of a sliver, or along an axis, the normal is much smaller than the
 * products that it is the difference of; by these its error counts. */
typedef struct triangle_plane {
    twofold3 normal;
    float3 products; /* sum of their sizes, per component */
} triangle_plane;

/* The same triangle, from the corner where its two shortest edges meet: products of these are the
 * smallest. */
static triangle_points from_shortest_edges(triangle_points p)
{
    const float opposite0 = largest3(fabs(p.v2 - p.v1)),
                opposite1 = largest3(fabs(p.v0 - p.v2)),
                opposite2 = largest3(fabs(p.v1 - p.v0));
    if (opposite0 >= opposite1 && opposite0 >= opposite2) return p;
    return opposite1 >= opposite2 ? (triangle_points){p.v1, p.v2, p.v0}
                                  : (triangle_points){p.v2, p.v0, p.v1};
}

static triangle_plane plane_of(triangle_points p)
{
    const scaled_edges edges = edges_of(from_shortest_edges(p));
    const float3 a = fabs(edges.edge1.high), b = fabs(edges.edge2.high);
    return (triangle_plane){twofold_cross(edges.edge1, edges.edge2),
                            a.yzx * b.zxy + a.zxy * b.yzx};
}

#endif
