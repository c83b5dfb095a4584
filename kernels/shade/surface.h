/* surface.h - the point of a surface that a ray hits: where, which way it faces, of what it is.
 * Computes no colour and no ray.
 */
#ifndef RSH_SHADE_SURFACE_H
#define RSH_SHADE_SURFACE_H

#include "mesh/plane.h"

#ifndef RSH_SMOOTH_NORMAL
#define RSH_SMOOTH_NORMAL 0 /* 1: normals are interpolated between the vertices */
#endif

/* The buffers of rsh_scene that say what the triangles are like. */
typedef struct surface_buffers {
    mesh_view mesh;
    __global const float* vertices;
    __global const uint* indices;
    __global const float* normals;
    __global const uint* material_ids;
    uint material_count;
} surface_buffers;

typedef struct surface_hit {
    triangle_points triangle;
    scaled_edges edges;
    float3 point;     /* on the triangle                                                  */
    float3 geometric; /* unit normal of the triangle, turned to the side the ray comes from */
    float3 normal;    /* unit, for shading, within 90 degrees of `geometric`              */
    float3 incident;  /* unit direction of the ray                                        */
    bool is_outside;  /* the ray comes from the side of (v1 - v0) x (v2 - v0)             */
    uint material;
} surface_hit;

/* Normal of a triangle with counter-clockwise corners, within a few ulp also for slivers: the
 * rounding of the edges, which the cross product would magnify, is put back to first order. 0:
 * no area. */
static float3 triangle_normal(const scaled_edges* edges)
{
    const float3 a = edges->edge1.high, b = edges->edge2.high;
    return unit3(cross3(a, b) + (cross3(edges->edge1.low, b) + cross3(a, edges->edge2.low)));
}

/* The barycentric point, as an offset from a corner: an error of u or v moves it along the
 * triangle only, and the size of the coordinates counts once, in the last sum. Good enough to
 * be lit; rays start at that of shade/departure.h. */
static float3 triangle_point(triangle_points p, rsh_hit hit)
{
    return p.v0 + (hit.u * (p.v1 - p.v0) + hit.v * (p.v2 - p.v0));
}

static float3 vertex_normal(const surface_buffers* buffers, uint vertex)
{
    return vload3(vertex, buffers->normals);
}

/* Interpolated normal, turned to the side of `geometric`; zero or not finite: that one. Near
 * silhouettes it may still face away from the viewer. */
static float3 smooth_normal(const surface_buffers* buffers, const surface_hit* surface,
                            rsh_hit hit)
{
    uint corner[3];
    triangle_vertices(buffers->mesh, buffers->indices, hit.primitive, corner);
    const float3 normal = unit3((1.0f - hit.u - hit.v) * vertex_normal(buffers, corner[0]) +
                                hit.u * vertex_normal(buffers, corner[1]) +
                                hit.v * vertex_normal(buffers, corner[2]));
    if (!(dot3(normal, normal) > 0.0f)) return surface->geometric;
    return dot3(normal, surface->geometric) < 0.0f ? -normal : normal;
}

static uint material_of(const surface_buffers* buffers, uint triangle)
{
    const uint id = buffers->material_ids ? buffers->material_ids[triangle] : 0;
    return id < buffers->material_count ? id : 0;
}

/* False: the ray is inactive or hits nothing. */
static bool find_surface(const surface_buffers* buffers, rsh_ray ray, rsh_hit hit,
                         surface_hit* surface)
{
    if (hit.primitive >= buffers->mesh.triangle_count || !is_active(ray)) return false;
    if (!load_triangle(buffers->mesh, buffers->vertices, buffers->indices, hit.primitive,
                       &surface->triangle))
        return false;
    surface->edges = edges_of(surface->triangle);
    const float3 normal = triangle_normal(&surface->edges);
    surface->incident = unit3(ray.direction_tmax.xyz);
    surface->is_outside = dot3(normal, surface->incident) <= 0.0f;
    surface->geometric = surface->is_outside ? normal : -normal;
    surface->point = triangle_point(surface->triangle, hit);
    surface->material = material_of(buffers, hit.primitive);
#if RSH_SMOOTH_NORMAL
    surface->normal = smooth_normal(buffers, surface, hit);
#else
    surface->normal = surface->geometric;
#endif
    return dot3(normal, normal) > 0.0f;
}

#endif
