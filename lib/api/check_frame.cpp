// check_frame.cpp - calls that start at the camera: rasterize and frame.
#include <cmath>
#include <iterator>

#include "api/check_fields.hpp"
#include "bvh/scene_bounds.hpp"
#include "camera/rasterize.hpp"
#include "frame/memory.hpp"
#include "reduce/strategy.hpp"
#include "traverse/engine.hpp"

namespace rsh {
namespace {

void check_side(const char* field, cl_uint side) {
    require(side >= 1 && side <= kMaxSide, field, side, "1 .. ", kMaxSide);
}

void check_axis(const char* field, const rsh_float4& v) {
    check_vector(field, v);
    require(v.s[0] != 0 || v.s[1] != 0 || v.s[2] != 0, field, 0, "a direction");
}

void check_camera(const rsh_camera& camera) {
    check_reserved("camera.reserved", camera.reserved, std::size(camera.reserved));
    check_vector("camera.eye", camera.eye);
    check_axis("camera.forward", camera.forward);
    check_axis("camera.right", camera.right);
    check_axis("camera.up", camera.up);
    const float near = camera.eye.s[3], far = camera.forward.s[3];
    require(near >= 0 && std::isfinite(near), "camera.eye.w (near)", near,
            "finite, not negative");
    require(far == 0 || far > near, "camera.forward.w (far)", far, "0 or above near");
}

// One axis of a window of `side` pixels.
void check_window(const char* first_field, cl_uint first, const char* picture_field,
                  cl_uint picture, cl_uint side) {
    require(picture == 0 || (picture >= side && picture <= kMaxSide), picture_field, picture,
            "0 or ", side, " .. ", kMaxSide);
    const cl_uint most = picture ? picture - side : 0;
    require(first <= most, first_field, first, "at most ", most);
}

void check_window(const rsh_window& window, cl_uint width, cl_uint height) {
    check_window("window.x", window.x, "window.picture_width", window.picture_width, width);
    check_window("window.y", window.y, "window.picture_height", window.picture_height, height);
}

// Without what its batches bring.
rsh_scene scene_with_buffers(const rsh_frame_desc& desc) {
    rsh_scene scene = *desc.scene;
    if (desc.batches) scene.features &= ~(RSH_FEATURE_SMOOTH_NORMAL | RSH_FEATURE_TEXTURE);
    return scene;
}

void check_batches(const rsh_frame_desc& desc) {
    const rsh_scene& scene = *desc.scene;
    const cl_uint attributes = desc.batches->attributes;
    check_source(*desc.batches, scene.geometry);
    refuse(scene.normals, "scene.normals", "batches");
    refuse(scene.texcoords, "scene.texcoords", "batches");
    refuse(scene.material_ids, "scene.material_ids", "batches");
    refuse(desc.bounds, "bounds", "batches");
    require(!desc.audit_rays, "audit_rays", desc.audit_rays, "0 with batches");
    if (scene.features & RSH_FEATURE_SMOOTH_NORMAL)
        require(attributes & RSH_BATCH_NORMALS, "batches.attributes", attributes,
                "with RSH_BATCH_NORMALS for RSH_FEATURE_SMOOTH_NORMAL");
    if (scene.features & RSH_FEATURE_TEXTURE)
        require(attributes & RSH_BATCH_TEXCOORDS, "batches.attributes", attributes,
                "with RSH_BATCH_TEXCOORDS for RSH_FEATURE_TEXTURE");
}

}  // namespace

void check_shape(const rsh_rasterize_desc& desc) {
    check_shape(desc.geometry);
    check_camera(desc.camera);
    check_side("width", desc.width);
    check_side("height", desc.height);
    check_window(desc.window, desc.width, desc.height);
}

void check_buffers(const Context& context, const rsh_rasterize_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, desc.geometry);
    const cl_ulong pixels = cl_ulong{desc.width} * desc.height;
    buffers.out("rays", desc.rays, pixels * sizeof(rsh_ray));
    buffers.out("hits", desc.hits, pixels * sizeof(rsh_hit));
    buffers.scratch(desc.scratch, rasterize_scratch(context, desc).bytes());
}

void check_shape(const rsh_frame_desc& desc) {
    check_shape(*desc.scene);
    check_camera(desc.camera);
    check_side("width", desc.width);
    check_side("height", desc.height);
    check_window(desc.window, desc.width, desc.height);
    require(desc.bounces <= RSH_MAX_LEVELS, "bounces", desc.bounces, "at most ",
            RSH_MAX_LEVELS);
    check_min_weight(desc.min_weight);
    check_node_shape(find_engine(desc.engine), desc.shape);
    find_strategy(desc.strategy);
    require(desc.mode <= RSH_BOUND_QUALITY, "mode", desc.mode, "an RSH_BOUND_... value");
    require(desc.tolerance >= 0 && std::isfinite(desc.tolerance), "tolerance", desc.tolerance,
            "finite, not negative");
    if (desc.batches) check_batches(desc);
}

void check_buffers(const Context& context, const rsh_frame_desc& desc) {
    Buffers buffers(context);
    check_buffers(buffers, scene_with_buffers(desc));
    buffers.out("colour", desc.colour, cl_ulong{desc.width} * desc.height * 16);
    require(!desc.mode || desc.bounds, "mode", desc.mode, "0 without bounds");
    buffers.optional_out("bounds", desc.bounds,
                         bounds_for(desc.shape).bytes(desc.scene->geometry));
    if (desc.audit_rays) buffers.out("audit", desc.audit, sizeof(rsh_audit_report));
    buffers.scratch(desc.scratch, frame_scratch(context, desc).bytes());
}

}  // namespace rsh
