// mesh.hpp - rsh_geometry, and the normals of an rsh_scene, as kernels read them.
#pragma once

#include <rsh/rsh.h>

#include <algorithm>

#include "mesh/types.h"

namespace rsh {

inline mesh_view mesh_view_of(const rsh_geometry& geometry) {
    const cl_ulong vertices_first = geometry.vertices_offset / 4;
    const cl_ulong indices_first = geometry.indices_offset / 4;
    mesh_view mesh = {};
    mesh.vertices_first_low = static_cast<cl_uint>(vertices_first);
    mesh.vertices_first_high = static_cast<cl_uint>(vertices_first >> 32);
    mesh.indices_first_low = static_cast<cl_uint>(indices_first);
    mesh.indices_first_high = static_cast<cl_uint>(indices_first >> 32);
    mesh.vertex_stride = (geometry.vertex_stride ? geometry.vertex_stride : 12) / 4;
    mesh.vertex_count = geometry.vertex_count;
    mesh.triangle_count = geometry.triangle_count;
    mesh.is_indexed = geometry.indices != nullptr;
    return mesh;
}

// The triangles first .. first + count - 1 as a mesh of their own.
inline mesh_view mesh_view_of(rsh_geometry geometry, cl_uint first, cl_uint count) {
    const cl_ulong corners = cl_ulong{3} * first;
    geometry.triangle_count = count;
    if (geometry.indices) {
        geometry.indices_offset += corners * sizeof(cl_uint);
        return mesh_view_of(geometry);
    }
    const cl_uint stride = geometry.vertex_stride ? geometry.vertex_stride : 12;
    const cl_uint before =
        static_cast<cl_uint>(std::min<cl_ulong>(corners, geometry.vertex_count));
    geometry.vertices_offset += cl_ulong{before} * stride;
    geometry.vertex_count -= before;
    return mesh_view_of(geometry);
}

inline mesh_view mesh_view_of(const rsh_scene& scene) {
    const cl_ulong normals_first = scene.normals_offset / 4;
    mesh_view mesh = mesh_view_of(scene.geometry);
    mesh.normals_first_low = static_cast<cl_uint>(normals_first);
    mesh.normals_first_high = static_cast<cl_uint>(normals_first >> 32);
    mesh.normal_stride = (scene.normal_stride ? scene.normal_stride : 12) / 4;
    mesh.features = scene.features;
    return mesh;
}

}  // namespace rsh
