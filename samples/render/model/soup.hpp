// soup.hpp - polygons as a file lists them, which every reader fills; they become the renderer's
// triangle mesh. No half-edges: nothing is duplicated, merged or refused where the surface is not
// a manifold.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include "model/model.hpp"

namespace render {

constexpr uint32_t kNoMaterial = 0xffffffffu;  // of a polygon that names none
constexpr uint32_t kNoVertex = 0xffffffffu;    // an index that no file can have

// One corner of a polygon. Normal and texture coordinate count only if the soup has them.
struct Corner {
    uint32_t vertex = 0;
    glm::vec3 normal{0.0f};
    glm::vec2 texcoord{0.0f};
};

struct Soup {
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;    // empty, or one per position
    std::vector<glm::vec2> texcoords;  // empty, or one per position
    std::vector<Corner> corners;       // of all polygons, one polygon after the other
    std::vector<size_t> ends;          // polygon i ends before corner ends[i]
    std::vector<uint32_t> materials;   // empty (all 0), or one per polygon
    bool corners_have_normals = false;
    bool corners_have_texcoords = false;
};

// Leaves out polygons with a vertex that is not there or with fewer than three corners, and adds
// a warning for each kind. `name` starts it.
void drop_bad_polygons(Soup& soup, const std::string& name, std::vector<std::string>& warnings);

struct IndexedMesh {
    Mesh mesh;
    // The file's number of each vertex. The identity unless corners differ in more than
    // position.
    std::vector<uint32_t> source;
};

IndexedMesh build_mesh(const Soup& soup);

}  // namespace render
