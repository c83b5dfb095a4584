// part.cpp - loading, material changes, placing.
#include "scene/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>
#include <utility>

#include "files/asset.hpp"
#include "files/json_value.hpp"
#include "import/bart/aff_animation.hpp"
#include "import/gltf/gltf_animation.hpp"
#include "import/mesh_file.hpp"
#include "import/vertex_frames.hpp"
#include "model/creases.hpp"
#include "model/normals.hpp"

namespace render {
namespace {

std::unique_ptr<Animation> load_animation(const MeshEntry& entry) {
    if (!entry.vertex_frames.empty())
        return load_vertex_frames(entry.file, entry.vertex_frames);
    const std::string extension = inner_extension(entry.file);
    const bool is_gltf = extension == "gltf" || extension == "glb";
    if (!entry.clip.empty() && !is_gltf)
        throw std::runtime_error(fmt::format(
            "clip: found \"{}\", allowed: none but for a .gltf or .glb file", entry.clip));
    if (is_gltf) return load_gltf(entry.file, entry.clip);
    if (extension == "aff") return load_aff(entry.file);
    return nullptr;
}

template <typename T>
void change_to(T& member, const std::optional<T>& changed) {
    if (changed) member = *changed;
}

void change(Material& material, const MaterialChange& c) {
    change_to(material.ambient, c.ambient);
    change_to(material.diffuse, c.diffuse);
    change_to(material.specular, c.specular);
    change_to(material.shininess, c.shininess);
    change_to(material.reflection, c.reflection);
    change_to(material.transmission, c.transmission);
    change_to(material.ior, c.ior);
    change_to(material.emission, c.emission);
    change_to(material.texture, c.texture);
    if (c.texture) material.texture_bytes = nullptr;
    if (c.diffuse && !c.ambient) material.ambient = *c.diffuse;
}

// Most mesh files say nothing about ambient light; black objects in shadow are not what they
// mean.
void default_ambient(std::vector<Material>& materials) {
    for (Material& material : materials)
        if (material.ambient == glm::vec3(0.0f)) material.ambient = material.diffuse;
}

void change_named(std::vector<Material>& materials, const std::string& name,
                  const MaterialChange& c, const std::string& where) {
    bool is_known = false;
    std::vector<std::string> names;
    for (Material& material : materials) {
        names.push_back(material.name);
        if (material.name != name) continue;
        change(material, c);
        is_known = true;
    }
    if (!is_known)
        throw std::runtime_error(
            fmt::format("{}.materials: found \"{}\", which the mesh does not have; nearest: "
                        "\"{}\", allowed: "
                        "{}",
                        where, name, nearest_word(name, names), fmt::join(names, ", ")));
}

void change_materials(const MeshEntry& entry, std::vector<Material>& materials) {
    default_ambient(materials);
    for (Material& material : materials) change(material, entry.material);
    for (const auto& [name, c] : entry.materials) change_named(materials, name, c, entry.where);
}

// Of what the mesh holds: its positions less its origin.
glm::dmat4 static_transform(const MeshEntry& entry, const Mesh& mesh) {
    const glm::dmat4 placed = glm::translate(entry.transform, mesh.origin);
    if (!entry.stand) return placed;
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const glm::vec3& position : mesh.positions) {
        const glm::dvec3 p(placed * glm::dvec4(position, 1.0));
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return standing_at(low, high, entry.stand->at, entry.stand->height) * placed;
}

glm::vec3 point(const glm::mat4& matrix, glm::vec3 p) {
    return matrix * glm::vec4(p, 1.0f);
}

glm::vec3 unit_or_zero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f);
}

// In double: the determinant of a small scale is no float.
glm::dmat3 linear_part(const glm::mat4& matrix) {
    return glm::dmat3(glm::mat3(matrix));
}

bool mirrors(const glm::mat4& matrix) {
    return glm::determinant(linear_part(matrix)) < 0.0;
}

void place_mesh(const glm::mat4& matrix, const Mesh& rest,
                const std::vector<VertexRange>& vertices, Mesh& placed) {
    const glm::dmat3 for_normals = glm::transpose(glm::inverse(linear_part(matrix)));
    for (const VertexRange& range : vertices)
        for (size_t i = range.first; i < range.first + range.count; ++i) {
            placed.positions[i] = point(matrix, rest.positions[i]);
            if (!rest.normals.empty())
                placed.normals[i] = unit_or_zero(for_normals * glm::dvec3(rest.normals[i]));
        }
}

void place_camera_and_lights(const glm::mat4& matrix, const Model& rest, Model& placed) {
    const glm::mat3 turn(matrix);
    placed.lights = rest.lights;
    for (Light& light : placed.lights) {
        light.position = point(matrix, light.position);
        light.direction = turn * light.direction;
    }
    placed.camera = rest.camera;
    if (!placed.camera) return;
    placed.camera->eye = point(matrix, rest.camera->eye);
    placed.camera->at = point(matrix, rest.camera->at);
    placed.camera->up = turn * rest.camera->up;
}

// The largest distance from the mesh's origin, along an axis.
double half_size(const Mesh& mesh) {
    float largest = 0.0f;
    for (const glm::vec3& p : mesh.positions)
        for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(p[i]));
    return largest;
}

// Its origin keeps a mesh fine until it is placed; in the world, positions are floats.
std::optional<std::string> coarseness(const glm::dmat4& matrix, const MeshEntry& entry,
                                      const Mesh& mesh) {
    if (mesh.origin == glm::dvec3(0.0)) return std::nullopt;
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(matrix))));
    const double now = glm::length(glm::dvec3(matrix[3]));
    if (!(now > kFarAgainstSize * scale * half_size(mesh))) return std::nullopt;
    return fmt::format(
        "{}: lies {:.3g} from the world's origin, where floats round by up to {:.2g}, too "
        "much for its size; \"transform\" can move it nearer",
        entry.file, now, now * 0x1p-24);
}

}  // namespace

Part::Part(MeshEntry entry) : entry_(std::move(entry)) {
    try {
        if (!entry_.file.empty()) animation_ = load_animation(entry_);
        if (animation_)
            rest_ = animation_->at(animation_->start());
        else
            rest_ = entry_.file.empty() ? make_room(entry_.room) : load_mesh(entry_.file);
        if (animation_ && !animation_->moves()) animation_.reset();
        if (animation_) animated_triangles_ = rest_.mesh.triangles;
        if (entry_.is_smooth) smooth();
        transform_ = static_transform(entry_, rest_.mesh);
        if (const auto warning = coarseness(transform_, entry_, rest_.mesh))
            rest_.warnings.push_back(*warning);
    } catch (const std::exception& error) {
        // A mesh on the command line is its own place, which its loader has named already.
        const std::string message = error.what();
        if (message.rfind(entry_.where, 0) == 0) throw;
        throw std::runtime_error(fmt::format("{}: {}", entry_.where, message));
    }
    change_materials(entry_, rest_.materials);
    placed_ = rest_;
    placed_.mesh.origin = glm::dvec3(0.0);
    place_triangles();
    place(0.0, {{0, rest_.mesh.positions.size()}});
    find_moving_vertices();
}

// Keys move all; and normals that are made of triangles may change beside what moves.
void Part::find_moving_vertices() {
    if (!moves() || rest_.mesh.positions.empty()) return;
    if (entry_.keys.empty() && !entry_.is_smooth)
        moving_ = animation_->moving_vertices();
    else
        moving_ = {{0, rest_.mesh.positions.size()}};
}

// The outside stays outside in a mirror: there, the corners run the other way round.
void Part::place_triangles() {
    placed_.mesh.triangles = rest_.mesh.triangles;
    if (!mirrors(transform_)) return;  // keys only scale by positive numbers
    for (glm::uvec3& triangle : placed_.mesh.triangles) std::swap(triangle.y, triangle.z);
}

void Part::turn_triangles(const std::vector<glm::uvec3>& now) {
    has_turned_triangles_ = false;
    for (size_t i = 0; i < now.size(); ++i) {
        if (now[i] == animated_triangles_[i]) continue;
        std::swap(rest_.mesh.triangles[i].y, rest_.mesh.triangles[i].z);
        has_turned_triangles_ = true;
    }
    if (!has_turned_triangles_) return;
    animated_triangles_ = now;
    place_triangles();
}

// Creases are those at the start: a moving mesh keeps its vertices.
void Part::smooth() {
    if (entry_.crease_degrees < 180.0f) {
        CreasedMesh creased = split_at_creases(rest_.mesh, entry_.crease_degrees);
        rest_.mesh = std::move(creased.mesh);
        uncut_ = std::move(creased.source);
    }
    rest_.mesh.normals = smooth_normals(rest_.mesh);
}

std::optional<Interval> Part::time_span() const {
    if (animation_) return Interval{animation_->start(), animation_->end()};
    if (entry_.keys.empty()) return std::nullopt;
    return Interval{entry_.keys.front().time, entry_.keys.back().time};
}

int Part::frames() const {
    return animation_ ? animation_->frames() : 1;
}

double Part::animation_time(double time) const {
    const double start = animation_->start();
    const double length = animation_->end() - start;
    if (!(length > 0.0)) return time;
    if (!entry_.repeats) return std::clamp(time, start, animation_->end());
    const double passed = std::fmod(time - start, length);
    return start + (passed < 0.0 ? passed + length : passed);
}

void Part::place(double time, const std::vector<VertexRange>& vertices) {
    const glm::vec3 pivot = entry_.stand ? entry_.stand->at : glm::vec3(0.0f);
    const glm::mat4 matrix = motion_at(entry_.keys, time, pivot) * transform_;  // rounded once
    place_mesh(matrix, rest_.mesh, vertices, placed_.mesh);
    place_camera_and_lights(matrix, rest_, placed_);
}

const Model& Part::at(double time) {
    if (!moves()) return placed_;
    if (animation_) {
        Model now = animation_->at(animation_time(time));
        turn_triangles(now.mesh.triangles);
        for (size_t i = 0; i < uncut_.size(); ++i)
            rest_.mesh.positions[i] = now.mesh.positions[uncut_[i]];
        if (uncut_.empty()) rest_.mesh.positions = std::move(now.mesh.positions);
        rest_.mesh.normals = entry_.is_smooth ? smooth_normals(rest_.mesh) : now.mesh.normals;
        rest_.lights = std::move(now.lights);
        rest_.camera = now.camera;
    }
    place(time, moving_);
    return placed_;
}

}  // namespace render
