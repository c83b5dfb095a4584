// aff_animation.cpp - AffScene and a time -> model.
#include "import/bart/aff_animation.hpp"

#include <algorithm>
#include <utility>

#include "import/bart/aff_scene.hpp"

namespace render {
namespace {

// `normal` under the inverse transpose of `matrix`, unit; zero (flat) stays zero, and so does
// the normal of what a scale of 0 has squashed.
glm::vec3 transform_normal(const glm::dmat4& matrix, glm::dvec3 normal) {
    const glm::dmat3 m(matrix);
    // The cofactor matrix is the inverse transpose times the determinant, whose sign counts.
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    const glm::dvec3 moved = cofactors * normal * (glm::determinant(m) < 0.0 ? -1.0 : 1.0);
    const double length = glm::length(moved);
    return length > 0.0 ? glm::vec3(moved / length) : glm::vec3(0.0f);
}

glm::vec3 transform_point(const glm::dmat4& matrix, glm::dvec3 point) {
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

bool mirrors(const glm::dmat4& matrix) {
    return glm::determinant(glm::dmat3(matrix)) < 0.0;
}

struct MorphCorners {
    glm::dvec3 values[6];
};

MorphCorners corners_at(const AffMorph& morph, double time) {
    const size_t last = morph.times.size() - 1;
    time = std::clamp(time, morph.times[0], morph.times[last]);
    size_t i = 0;
    while (i + 1 < last && time >= morph.times[i + 1]) ++i;
    const size_t j = std::min(i + 1, last);
    const double length = morph.times[j] - morph.times[i];
    const double u = length > 0.0 ? (time - morph.times[i]) / length : 1.0;
    MorphCorners corners;
    for (size_t k = 0; k < 6; ++k)
        corners.values[k] =
            glm::mix(glm::dvec3(morph.keys[i][k]), glm::dvec3(morph.keys[j][k]), u);
    return corners;
}

class AffAnimation : public Animation {
public:
    explicit AffAnimation(AffScene scene);

    double start() const override { return scene_.start; }
    double end() const override { return scene_.end; }
    int frames() const override { return scene_.frames; }
    // The materials hold the file's global ambient light: their ambient is meant for 1.
    Model at(double time) const override;
    std::vector<VertexRange> moving_vertices() const override;

private:
    // The nodes at one time.
    struct Pose {
        std::vector<glm::dmat4> matrices;
        std::vector<bool> visible;
    };
    Pose pose(double time) const;
    const Track* track(const std::string& name) const;
    void place(uint32_t vertex, const Pose& pose, Mesh& mesh) const;
    void wind_triangles(const Pose& pose, Mesh& mesh) const;
    void place_lights(double time, const Pose& pose, Model& model) const;
    void place_camera(double time, Model& model) const;

    AffScene scene_;
    Model rest_;                    // everything that stands still
    std::vector<uint32_t> moving_;  // vertices under an animated transform
};

AffAnimation::AffAnimation(AffScene scene) : scene_(std::move(scene)) {
    rest_.mesh = scene_.mesh;
    rest_.materials = scene_.materials;
    for (Material& material : rest_.materials) material.ambient *= scene_.ambient;
    rest_.background = scene_.background;
    rest_.warnings = scene_.warnings;
    std::vector<bool> moves(scene_.nodes.size());
    for (size_t i = 1; i < moves.size(); ++i)
        moves[i] = moves[scene_.nodes[i].parent] || track(scene_.nodes[i].track);
    const Pose at_start = pose(scene_.start);
    wind_triangles(at_start, rest_.mesh);
    for (uint32_t v = 0; v < scene_.vertex_nodes.size(); ++v) {
        place(v, at_start, rest_.mesh);
        if (moves[scene_.vertex_nodes[v]]) moving_.push_back(v);
    }
}

const Track* AffAnimation::track(const std::string& name) const {
    const auto found = scene_.tracks.find(name);
    return name.empty() || found == scene_.tracks.end() ? nullptr : &found->second;
}

AffAnimation::Pose AffAnimation::pose(double time) const {
    Pose result;
    for (size_t i = 0; i < scene_.nodes.size(); ++i) {
        const AffNode& node = scene_.nodes[i];
        const Track* keys = track(node.track);
        const glm::dmat4 own = keys ? keys->matrix(time) : node.matrix;
        result.matrices.push_back(i == 0 ? own : result.matrices[node.parent] * own);
        result.visible.push_back((i == 0 || result.visible[node.parent]) &&
                                 (!keys || keys->is_visible(time)));
    }
    return result;
}

void AffAnimation::place(uint32_t vertex, const Pose& pose, Mesh& mesh) const {
    const size_t node = scene_.vertex_nodes[vertex];
    const glm::dmat4& matrix = pose.matrices[node];
    mesh.positions[vertex] =
        transform_point(matrix, pose.visible[node] ? glm::dvec3(scene_.mesh.positions[vertex])
                                                   : glm::dvec3(0.0));
    mesh.normals[vertex] = transform_normal(matrix, scene_.mesh.normals[vertex]);
}

// The outside stays outside in a mirror: there, the corners run the other way round.
void AffAnimation::wind_triangles(const Pose& pose, Mesh& mesh) const {
    std::vector<bool> turns;
    for (const glm::dmat4& matrix : pose.matrices) turns.push_back(mirrors(matrix));
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        mesh.triangles[i] = scene_.mesh.triangles[i];
        if (turns[scene_.vertex_nodes[mesh.triangles[i].x]])
            std::swap(mesh.triangles[i].y, mesh.triangles[i].z);
    }
}

void AffAnimation::place_lights(double time, const Pose& pose, Model& model) const {
    for (const AffLight& light : scene_.lights) {
        glm::dmat4 matrix = pose.matrices[light.node];
        if (const Track* keys = track(light.track)) matrix = matrix * keys->matrix(time);
        model.lights.push_back(light.light);
        model.lights.back().position = transform_point(matrix, light.light.position);
    }
}

// It stands where its keys translate to and looks along -z of their rotation.
void AffAnimation::place_camera(double time, Model& model) const {
    model.camera = scene_.camera;
    const Track* keys = track(kCameraKeys);
    if (!keys) return;
    if (!model.camera) model.camera.emplace();
    const glm::dmat4 matrix = keys->matrix(time);
    model.camera->eye = transform_point(matrix, glm::dvec3(0.0));
    model.camera->at = transform_point(matrix, glm::dvec3(0.0, 0.0, -1.0));
    model.camera->up = glm::dvec3(matrix[1]);
}

std::vector<VertexRange> AffAnimation::moving_vertices() const {
    std::vector<bool> moves(scene_.vertex_nodes.size());
    for (const uint32_t vertex : moving_) moves[vertex] = true;
    for (const AffMorph& morph : scene_.morphs)
        for (uint32_t i = 0; i < 3; ++i) moves[morph.first_vertex + i] = true;
    return ranges_of(moves);
}

Model AffAnimation::at(double time) const {
    Model model = rest_;
    const Pose now = pose(time);
    wind_triangles(now, model.mesh);
    for (const uint32_t vertex : moving_) place(vertex, now, model.mesh);
    for (const AffMorph& morph : scene_.morphs) {
        const size_t node = scene_.vertex_nodes[morph.first_vertex];
        if (!now.visible[node]) continue;
        const MorphCorners corners = corners_at(morph, time);
        for (uint32_t i = 0; i < 3; ++i) {
            const uint32_t vertex = morph.first_vertex + i;
            model.mesh.positions[vertex] =
                transform_point(now.matrices[node], corners.values[2 * i]);
            model.mesh.normals[vertex] =
                transform_normal(now.matrices[node], corners.values[2 * i + 1]);
        }
    }
    place_lights(time, now, model);
    place_camera(time, model);
    return model;
}

}  // namespace

std::unique_ptr<Animation> load_aff(const std::string& path) {
    return std::make_unique<AffAnimation>(parse_aff(path));
}

}  // namespace render
