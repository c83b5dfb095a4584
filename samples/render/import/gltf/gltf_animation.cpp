// gltf_animation.cpp - GltfScene and a time -> model.
#include "import/gltf/gltf_animation.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "import/gltf/gltf_pose.hpp"

namespace render {
namespace {

glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 otherwise) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : otherwise;
}

class GltfAnimation : public Animation {
public:
    explicit GltfAnimation(GltfScene scene);

    bool moves() const override { return !scene_.curves.empty(); }
    double start() const override { return start_; }
    double end() const override { return end_; }
    int frames() const override { return frames_; }
    Model at(double time) const override;
    std::vector<VertexRange> moving_vertices() const override;

private:
    void make_rest();
    void set_times();
    std::vector<bool> moving_nodes() const;
    bool moves(const GltfPlacement& placement, const std::vector<bool>& nodes) const;
    void wind_triangles(const GltfPlacement& placement, const GltfPose& pose, Mesh& mesh) const;
    void place_lights_and_camera(const GltfPose& pose, Model& model) const;

    GltfScene scene_;
    Model rest_;  // at the start
    std::vector<GltfPlacement> moving_;
    double start_ = 0.0, end_ = 0.0;
    int frames_ = 1;  // different times of keys
};

GltfAnimation::GltfAnimation(GltfScene scene) : scene_(std::move(scene)) {
    set_times();
    make_rest();
    const GltfPose pose = pose_at(scene_, start_);
    const std::vector<bool> nodes = moving_nodes();
    for (const GltfPlacement& placement : scene_.placements) {
        place_vertices(scene_, placement, pose, rest_.mesh);
        wind_triangles(placement, pose, rest_.mesh);
        if (moves(placement, nodes)) moving_.push_back(placement);
    }
}

void GltfAnimation::set_times() {
    std::set<float> times;
    for (const GltfCurve& curve : scene_.curves)
        times.insert(curve.times.begin(), curve.times.end());
    if (times.empty()) return;
    start_ = *times.begin();
    end_ = *times.rbegin();
    frames_ = static_cast<int>(times.size());
}

// Everything that no time changes, and room for the rest.
void GltfAnimation::make_rest() {
    const auto& primitives = scene_.primitives;
    const auto has = [&](auto member) {
        return std::any_of(primitives.begin(), primitives.end(),
                           [&](const GltfPrimitive& p) { return !(p.*member).empty(); });
    };
    const bool has_normals = has(&GltfPrimitive::normals);
    const bool has_texcoords = has(&GltfPrimitive::texcoords);
    Mesh& mesh = rest_.mesh;
    for (const GltfPlacement& placement : scene_.placements) {
        const GltfPrimitive& p = primitives[placement.primitive];
        const size_t vertices = placement.first_vertex + p.positions.size();
        mesh.positions.resize(vertices);
        if (has_normals) mesh.normals.resize(vertices, glm::vec3(0.0f));
        if (has_texcoords) {
            mesh.texcoords.insert(mesh.texcoords.end(), p.texcoords.begin(), p.texcoords.end());
            mesh.texcoords.resize(vertices, glm::vec2(0.0f));
        }
        mesh.triangles.resize(placement.first_triangle + p.triangles.size());
        mesh.material_ids.resize(mesh.triangles.size(), p.material);
    }
    rest_.materials = scene_.materials;
    rest_.warnings = scene_.warnings;
}

// Those with a curve, and all below them.
std::vector<bool> GltfAnimation::moving_nodes() const {
    std::vector<bool> moves(scene_.nodes.size());
    for (const GltfCurve& curve : scene_.curves) moves[curve.node] = true;
    for (const uint32_t node : scene_.order) {
        const uint32_t parent = scene_.nodes[node].parent;
        if (parent != kNoGltfNode && moves[parent]) moves[node] = true;
    }
    return moves;
}

bool GltfAnimation::moves(const GltfPlacement& placement,
                          const std::vector<bool>& nodes) const {
    if (nodes[placement.node]) return true;
    if (placement.skin == kNoGltfSkin) return false;
    const std::vector<uint32_t>& joints = scene_.skins[placement.skin].joints;
    return std::any_of(joints.begin(), joints.end(),
                       [&](uint32_t joint) { return nodes[joint]; });
}

void GltfAnimation::wind_triangles(const GltfPlacement& placement, const GltfPose& pose,
                                   Mesh& mesh) const {
    const GltfPrimitive& p = scene_.primitives[placement.primitive];
    const glm::uvec3 offset(static_cast<uint32_t>(placement.first_vertex));
    const bool turns = is_mirrored(placement, pose);
    for (size_t i = 0; i < p.triangles.size(); ++i) {
        glm::uvec3 triangle = p.triangles[i] + offset;
        if (turns) std::swap(triangle.y, triangle.z);
        mesh.triangles[placement.first_triangle + i] = triangle;
    }
}

void GltfAnimation::place_lights_and_camera(const GltfPose& pose, Model& model) const {
    for (const GltfLight& light : scene_.lights) {
        const glm::dmat4& matrix = pose.matrices[light.node];
        model.lights.push_back(light.light);
        model.lights.back().position = glm::dvec3(matrix[3]);
        model.lights.back().direction = unit_or(-glm::dvec3(matrix[2]), light.light.direction);
    }
    if (!scene_.camera) return;
    const glm::dmat4& matrix = pose.matrices[scene_.camera->node];
    model.camera = scene_.camera->camera;
    const glm::dvec3 eye(matrix[3]);
    model.camera->eye = eye;
    model.camera->at = eye + unit_or(-glm::dvec3(matrix[2]), {0.0, 0.0, -1.0});
    model.camera->up = unit_or(glm::dvec3(matrix[1]), {0.0, 1.0, 0.0});
}

std::vector<VertexRange> GltfAnimation::moving_vertices() const {
    std::vector<bool> moves(rest_.mesh.positions.size());
    for (const GltfPlacement& placement : moving_)
        for (size_t i = 0; i < scene_.primitives[placement.primitive].positions.size(); ++i)
            moves[placement.first_vertex + i] = true;
    return ranges_of(moves);
}

Model GltfAnimation::at(double time) const {
    Model model = rest_;
    const GltfPose pose = pose_at(scene_, time);
    for (const GltfPlacement& placement : moving_) {
        place_vertices(scene_, placement, pose, model.mesh);
        wind_triangles(placement, pose, model.mesh);
    }
    place_lights_and_camera(pose, model);
    return model;
}

}  // namespace

std::unique_ptr<Animation> load_gltf(const std::string& path, const std::string& clip) {
    return std::make_unique<GltfAnimation>(read_gltf(path, clip));
}

}  // namespace render
