// aff_geometry.hpp - what AFF files draw: polygons, triangles that are textured or move, meshes, spheres
// and cones, as triangles of one mesh. Applies no transform.
#pragma once

#include <string>
#include <vector>

#include "import/bart/aff_keys.hpp"
#include "import/bart/aff_materials.hpp"
#include "import/bart/aff_scene.hpp"
#include "import/bart/aff_shapes.hpp"
#include "import/bart/aff_tokens.hpp"

namespace render {

// Each function reads what follows one command and adds it to the scene, under the node `node`. They
// throw LoadError.
class AffGeometry {
public:
    AffGeometry(AffTokens& tokens, AffScene& scene, AffMaterials& materials, AffKeys& keys)
        : tokens_(tokens), scene_(scene), materials_(materials), keys_(keys) {}

    void read_polygon();            // "p"
    void read_patch();              // "pp": a polygon with normals
    void read_textured_triangle();  // "tt"
    void read_textured_patch();     // "ttp": a textured triangle with normals
    void read_moving_triangle();    // "tpa"
    void read_sphere();             // "s"
    void read_cone();               // "c"
    void read_mesh();               // "m"

    size_t node = 0;  // the innermost transform that is open; 0: the world

private:
    struct Corner {
        glm::vec3 position, normal{0.0f};
        glm::vec2 texcoord{0.0f};
    };
    struct Lists;  // of a mesh

    uint32_t add_vertex(const Corner& corner);
    void add_triangle(glm::uvec3 triangle, uint32_t material);
    void add_polygon(const std::vector<Corner>& corners, uint32_t material);
    void add_shape(const Shape& shape);
    void read_polygon(bool has_normals);
    void read_textured(bool has_normals);
    glm::vec2 texcoord();
    std::vector<glm::vec3> vectors(const char* what);
    void read_texcoords(Lists& lists);
    Lists read_lists();
    size_t index(const char* what, size_t count);

    AffTokens& tokens_;
    AffScene& scene_;
    AffMaterials& materials_;
    AffKeys& keys_;
};

}  // namespace render
