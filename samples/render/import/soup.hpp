// soup.hpp - polygons as a file lists them: no half-edges, so nothing is duplicated, merged or
// refused where the surface is not a manifold. Becomes the renderer's triangle mesh.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace render {

// One corner of a polygon. Normal and texture coordinate count only if the soup has them.
struct Corner {
    uint32_t vertex = 0;
    glm::vec3 normal{0.0f};
    glm::vec2 texcoord{0.0f};
};

struct Soup {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;    // empty, or one per position
    std::vector<glm::vec2> texcoords;  // empty, or one per position
    std::vector<Corner> corners;       // of all polygons, one polygon after the other
    std::vector<size_t> ends;          // polygon i ends before corner ends[i]
    std::vector<uint32_t> materials;   // empty (all 0), or one per polygon
    bool corners_have_normals = false;
    bool corners_have_texcoords = false;
};

struct IndexedMesh {
    Mesh mesh;
    // The file's number of each vertex. The identity unless corners differ in more than
    // position.
    std::vector<uint32_t> source;
};

IndexedMesh build_mesh(const Soup& soup);

}  // namespace render
