// model.hpp - what the loaders produce and the renderer consumes: one triangle mesh with the
// materials, textures, lights and camera that belong to it. Knows neither files nor OpenCL.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rsh/rsh_types.h>

namespace render {

// An image in memory, rows from top to bottom, four channels. `format` is RSH_TEXEL_...: bytes
// are sRGB, floats linear; exactly one of the two vectors is filled.
struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t format = RSH_TEXEL_SRGB8;
    std::vector<uint8_t> bytes;
    std::vector<float> floats;
};

struct Material {
    std::string name;
    glm::vec3 ambient{0.0f};
    glm::vec3 diffuse{0.8f};
    glm::vec3 specular{0.0f};
    float shininess = 1.0f;
    glm::vec3 reflection{0.0f};
    glm::vec3 transmission{0.0f};
    float ior = 1.0f;
    glm::vec3 emission{0.0f};
    std::string texture;  // path or archive member of the diffuse texture; empty: none
    // The image as the mesh's own file encodes it, which `texture` then only names; null: it does not.
    std::shared_ptr<const std::string> texture_bytes;
    bool clamps_texture = false;  // shows its edge outside of 0..1, instead of repeating
    // What a file wants done to texture coordinates: scale * uv + shift. Its loader has done it.
    glm::vec2 texture_scale{1.0f}, texture_shift{0.0f};
};

struct Light {
    uint32_t kind = RSH_LIGHT_POINT;
    glm::vec3 position{0.0f};
    glm::vec3 direction{0.0f, -1.0f, 0.0f};
    glm::vec3 colour{1.0f};
    glm::vec3 attenuation{0.0f};
    float inner_degrees = 20.0f;  // half-angles of a spot light
    float outer_degrees = 30.0f;
    bool casts_shadow = true;
};

struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 5.0f};
    glm::vec3 at{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
    float vertical_degrees = 45.0f;  // full vertical field of view
    float near = 1e-3f;
};

// A mesh is far from 0 at more than so many times half its size: there, floats may be too coarse.
constexpr double kFarAgainstSize = 8.0;

// Corners that differ in position, normal or texture coordinate are different vertices.
struct Mesh {
    // What to add to all positions, in double: coordinates of a map, say, are too large for floats
    // to tell one vertex from the next. 0 for most meshes.
    glm::dvec3 origin{0.0};
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;    // empty, or one per vertex; a zero vector means flat
    std::vector<glm::vec2> texcoords;  // empty, or one per vertex
    std::vector<glm::uvec3> triangles;
    std::vector<uint32_t> material_ids;  // one per triangle, indices into Model::materials
};

struct Model {
    Mesh mesh;
    std::vector<Material> materials;  // at least one
    std::vector<Light> lights;
    std::optional<Camera> camera;
    std::optional<glm::vec3> background;
    std::vector<std::string> warnings;  // what the file promised and the model lacks
};

struct VertexRange {
    size_t first = 0;
    size_t count = 0;
};

// Ranges of all vertices that are marked, in ascending order. Short gaps are filled: to copy a few
// vertices more is cheaper than to copy once more.
inline std::vector<VertexRange> ranges_of(const std::vector<bool>& is_marked) {
    constexpr size_t kShortGap = 256;
    std::vector<VertexRange> ranges;
    for (size_t i = 0; i < is_marked.size(); ++i) {
        if (!is_marked[i]) continue;
        const bool is_near =
            !ranges.empty() && i - (ranges.back().first + ranges.back().count) <= kShortGap;
        if (!is_near) ranges.push_back({i, 0});
        ranges.back().count = i + 1 - ranges.back().first;
    }
    return ranges;
}

// A model that changes with time, its topology fixed.
class Animation {
public:
    virtual ~Animation() = default;
    virtual bool moves() const { return true; }  // false: at() is the same at all times
    virtual double start() const = 0;
    virtual double end() const = 0;
    virtual int frames() const = 0;
    virtual Model at(double time) const = 0;
    // All others have their position and normal of the start at all times.
    virtual std::vector<VertexRange> moving_vertices() const = 0;
};

}  // namespace render
