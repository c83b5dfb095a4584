#include "frame/features.hpp"

namespace rsh {
namespace {

bool is_any_positive(const cl_float4& rgb) {
    return rgb.s[0] > 0.0f || rgb.s[1] > 0.0f || rgb.s[2] > 0.0f;
}

rsh_features needed_by(const rsh_material& material, const rsh_scene& scene) {
    rsh_features needed = 0;
    if (is_any_positive(material.reflection)) needed |= RSH_FEATURE_REFLECTION;
    // A surface that refracts also reflects: Fresnel's share.
    if (is_any_positive(material.transmission))
        needed |= RSH_FEATURE_REFLECTION | RSH_FEATURE_REFRACTION;
    if (material.texture < scene.texture_count) needed |= RSH_FEATURE_TEXTURE;
    return needed;
}

rsh_features provided_by_buffers(const rsh_scene& scene) {
    rsh_features provided =
        RSH_FEATURE_REFLECTION | RSH_FEATURE_REFRACTION | RSH_FEATURE_SHADOW;
    const bool has_images = scene.textures && scene.texels && scene.texture_count > 0;
    if (scene.normals) provided |= RSH_FEATURE_SMOOTH_NORMAL;
    if (has_images && scene.texcoords) provided |= RSH_FEATURE_TEXTURE;
    if (has_images && scene.environment_texture - 1u < scene.texture_count)
        provided |= RSH_FEATURE_ENVIRONMENT_IMAGE;
    return provided;
}

}  // namespace

void find_features(rsh_scene& scene, const rsh_material* materials, const rsh_light* lights) {
    scene.features = RSH_FEATURE_SMOOTH_NORMAL | RSH_FEATURE_ENVIRONMENT_IMAGE;
    for (cl_uint i = 0; i < scene.material_count; ++i)
        scene.features |= needed_by(materials[i], scene);
    scene.shadow_lights = 0;
    scene.positional_lights = 0;
    for (cl_uint k = 0; k < scene.light_count; ++k) {
        if (lights[k].casts_shadow) scene.shadow_lights |= 1u << k;
        if (lights[k].kind != RSH_LIGHT_DIRECTIONAL) scene.positional_lights |= 1u << k;
    }
    if (scene.shadow_lights != 0) scene.features |= RSH_FEATURE_SHADOW;
    scene.features &= provided_by_buffers(scene);
}

}  // namespace rsh
