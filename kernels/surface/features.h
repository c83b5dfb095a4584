/* features.h - which features of scenes a program serves. It is told of each when it is compiled: 0,
 * left out; 1, every scene has it; RSH_BY_SCENE, as the scene at hand has it. The general program is
 * told nothing, which means that of all.
 */
#ifndef RSH_SURFACE_FEATURES_H
#define RSH_SURFACE_FEATURES_H

#include "mesh/types.h"

#define RSH_BY_SCENE 2

#ifndef RSH_SMOOTH_NORMAL
#define RSH_SMOOTH_NORMAL RSH_BY_SCENE /* normals are interpolated between the vertices */
#endif
#ifndef RSH_TEXTURE
#define RSH_TEXTURE RSH_BY_SCENE
#endif
#ifndef RSH_ENVIRONMENT_IMAGE
#define RSH_ENVIRONMENT_IMAGE RSH_BY_SCENE
#endif

/* Whether the scene has a feature; told: one of the above; features: of mesh_view. */
static bool has_feature(uint told, uint features, uint feature)
{
    return told == RSH_BY_SCENE ? (features & feature) != 0 : told != 0;
}

static bool has_smooth_normals(uint features)
{
    return has_feature(RSH_SMOOTH_NORMAL, features, RSH_IN_SCENE_SMOOTH_NORMAL);
}

/* Asked of the scene in every program: to leave it out saved no time, on GPUs no register. */
static bool has_transmission(uint features)
{
    return (features & RSH_IN_SCENE_REFRACTION) != 0;
}

static bool has_textures(uint features)
{
    return has_feature(RSH_TEXTURE, features, RSH_IN_SCENE_TEXTURE);
}

static bool has_environment_image(uint features)
{
    return has_feature(RSH_ENVIRONMENT_IMAGE, features, RSH_IN_SCENE_ENVIRONMENT_IMAGE);
}

#endif
