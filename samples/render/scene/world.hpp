// world.hpp - all parts of a scene as one mesh with one table of materials, and what moves in
// it. Knows no device.
#pragma once

#include <string>
#include <vector>

#include "files/image_input.hpp"
#include "scene/part.hpp"
#include "scene/texture_set.hpp"

namespace render {

class World {
public:
    // Reads all files; throws std::runtime_error, with the warnings until then.
    explicit World(const SceneDescription& scene,
                   size_t max_texture_pixels = kMaxTexturePixels);

    // Moves everything to a moment; moved() then says which vertices that may concern, and
    // moved_normals() which of these have normals of their own.
    void move_to(double time);
    const std::vector<VertexRange>& moved() const { return moved_; }
    const std::vector<VertexRange>& moved_normals() const { return moved_normals_; }
    // Whether triangles of those that move changed with it; their number and order never do.
    bool has_turned_triangles() const { return has_turned_triangles_; }

    // Normals: none at all, or one per vertex. Triangles: those that stand still come first.
    const Mesh& mesh() const { return mesh_; }
    size_t still_triangles() const { return still_triangles_; }
    // Which triangle of all meshes, in their order, one of mesh() is.
    uint32_t triangle_number(size_t i) const {
        return triangle_numbers_.empty() ? static_cast<uint32_t>(i) : triangle_numbers_[i];
    }
    const std::vector<rsh_material>& materials() const { return materials_; }
    const std::vector<Light>& lights() const { return lights_; }
    const Camera& camera() const { return camera_; }
    const TextureSet& textures() const { return textures_; }
    glm::vec3 ambient() const { return ambient_; }
    glm::vec3 environment() const { return environment_; }
    uint32_t environment_texture() const { return environment_texture_; }  // 1 + index, or 0

    Interval time_span() const;  // from the first start to the last end of what moves
    int frames() const;          // of the animation with the most
    const std::vector<std::string>& warnings() const { return warnings_; }
    // One for each thing that moves, but neither at that time nor again and again.
    std::vector<std::string> warnings_at(double time) const;

private:
    void load();
    void warn(const std::vector<std::string>& warnings, const MeshEntry& entry);
    void append(const Model& model, const MeshEntry& entry);
    void append_materials(const Model& model, const MeshEntry& entry);
    std::vector<bool> moving_vertices() const;
    void put_still_triangles_first();
    void overwrite(size_t part);
    void overwrite_triangles(size_t part);
    void choose_environment(const SceneDescription& scene);
    void choose_lights_and_camera(double time);
    void place_lights(double time);  // those of the scene file

    SceneDescription scene_;
    std::vector<Part> parts_;
    std::vector<const Model*> models_;  // of the parts, as they are now
    std::vector<size_t> first_vertices_, first_triangles_;
    Mesh mesh_;
    size_t still_triangles_ = 0;
    std::vector<uint32_t> triangle_numbers_;  // empty: each is its own
    std::vector<rsh_material> materials_;
    std::vector<Light> lights_;
    Camera camera_;
    TextureSet textures_;
    glm::vec3 ambient_{0.0f};
    glm::vec3 environment_{0.0f};
    uint32_t environment_texture_ = 0;
    std::vector<VertexRange> moved_, moved_normals_;
    bool has_turned_triangles_ = false;
    std::vector<std::string> warnings_;
};

}  // namespace render
