// world.cpp - joins parts, and chooses camera and lights where the scene names none.
#include "scene/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "model/inspect.hpp"
#include "model/view_fit.hpp"
#include "model/warnings.hpp"
#include "scene/device_structs.hpp"

namespace render {
namespace {

constexpr glm::vec3 kDefaultAmbient(0.16f);
constexpr glm::vec3 kDefaultEnvironment(0.10f, 0.12f, 0.15f);

template <typename T>
void append_or_zero(std::vector<T>& all, const std::vector<T>& some, size_t before,
                    size_t count) {
    if (some.empty() && all.empty()) return;
    all.resize(before, T(0.0f));
    all.insert(all.end(), some.begin(), some.end());
    all.resize(before + count, T(0.0f));
}

template <typename T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<uint32_t>& numbers) {
    std::vector<T> some;
    some.reserve(numbers.size());
    for (const uint32_t number : numbers) some.push_back(all[number]);
    return some;
}

}  // namespace

World::World(const SceneDescription& scene, size_t max_texture_pixels)
    : scene_(scene), textures_(max_texture_pixels) {
    try {
        load();
    } catch (const std::exception& error) {
        throw std::runtime_error(with_warnings(error.what(), warnings_));
    }
}

void World::load() {
    parts_.reserve(scene_.meshes.size());  // models_ point into them
    for (const MeshEntry& entry : scene_.meshes) {
        Part& part = parts_.emplace_back(entry);
        first_vertices_.push_back(mesh_.positions.size());
        first_triangles_.push_back(mesh_.triangles.size());
        models_.push_back(&part.at(0.0));
        append(*models_.back(), part.entry());
    }
    if (mesh_.triangles.empty())
        throw std::runtime_error("the scene has no triangle; at least one is required");
    put_still_triangles_first();
    choose_environment(scene_);
    choose_lights_and_camera(0.0);
}

// A mesh on the command line is its own place, which its loader has named already.
void World::warn(const std::vector<std::string>& warnings, const MeshEntry& entry) {
    for (const std::string& warning : warnings)
        warnings_.push_back(warning.rfind(entry.where, 0) == 0
                                ? warning
                                : fmt::format("{}: {}", entry.where, warning));
}

void World::append(const Model& model, const MeshEntry& entry) {
    warn(model.warnings, entry);
    const size_t before = mesh_.positions.size();
    const size_t count = model.mesh.positions.size();
    if (before + count > UINT32_MAX)
        throw std::runtime_error(fmt::format("{}: found {} vertices in all, allowed: {}",
                                             entry.where, before + count, UINT32_MAX));
    const glm::uvec3 offset(static_cast<uint32_t>(before));
    const auto first_material = static_cast<uint32_t>(materials_.size());
    mesh_.positions.insert(mesh_.positions.end(), model.mesh.positions.begin(),
                           model.mesh.positions.end());
    append_or_zero(mesh_.normals, model.mesh.normals, before, count);
    append_or_zero(mesh_.texcoords, model.mesh.texcoords, before, count);
    for (const glm::uvec3& triangle : model.mesh.triangles)
        mesh_.triangles.push_back(triangle + offset);
    for (const uint32_t id : model.mesh.material_ids)
        mesh_.material_ids.push_back(id + first_material);
    append_materials(model, entry);
    warn(glass_warnings(model), entry);
}

std::vector<bool> World::moving_vertices() const {
    std::vector<bool> moves(mesh_.positions.size());
    for (size_t i = 0; i < parts_.size(); ++i)
        for (const VertexRange& range : parts_[i].moving_vertices())
            for (size_t v = 0; v < range.count; ++v)
                moves[first_vertices_[i] + range.first + v] = true;
    return moves;
}

// So that bounds of them can be kept.
void World::put_still_triangles_first() {
    const std::vector<bool> moves = moving_vertices();
    const std::vector<glm::uvec3>& triangles = mesh_.triangles;
    std::vector<uint32_t> numbers(triangles.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    const auto stands_still = [&](uint32_t i) {
        const glm::uvec3& t = triangles[i];
        return !moves[t.x] && !moves[t.y] && !moves[t.z];
    };
    const auto middle = std::stable_partition(numbers.begin(), numbers.end(), stands_still);
    still_triangles_ = static_cast<size_t>(middle - numbers.begin());
    if (std::is_sorted(numbers.begin(), numbers.end())) return;
    mesh_.triangles = picked(mesh_.triangles, numbers);
    mesh_.material_ids = picked(mesh_.material_ids, numbers);
    triangle_numbers_ = std::move(numbers);
}

// A texture that the scene file names must be readable; one that a mesh names may be missing.
void World::append_materials(const Model& model, const MeshEntry& entry) {
    for (const Material& material : model.materials) {
        const auto named = entry.materials.find(material.name);
        const bool is_required =
            entry.material.texture || (named != entry.materials.end() && named->second.texture);
        uint32_t texture = RSH_NO_TEXTURE;
        try {
            if (!material.texture.empty()) texture = textures_.add(material);
        } catch (const std::exception& error) {
            const std::string message = fmt::format("{}: material \"{}\": texture: {}",
                                                    entry.where, material.name, error.what());
            if (is_required) throw std::runtime_error(message);
            warnings_.push_back(message);
        }
        materials_.push_back(device_material(material, texture));
    }
}

void World::overwrite(size_t part) {
    const Mesh& mesh = models_[part]->mesh;
    const size_t first = first_vertices_[part];
    for (const VertexRange& range : parts_[part].moving_vertices()) {
        std::copy_n(&mesh.positions[range.first], range.count,
                    &mesh_.positions[first + range.first]);
        moved_.push_back({first + range.first, range.count});
        if (mesh.normals.empty()) continue;
        std::copy_n(&mesh.normals[range.first], range.count,
                    &mesh_.normals[first + range.first]);
        moved_normals_.push_back(moved_.back());
    }
    if (parts_[part].has_turned_triangles()) overwrite_triangles(part);
}

void World::overwrite_triangles(size_t part) {
    const std::vector<glm::uvec3>& triangles = models_[part]->mesh.triangles;
    const glm::uvec3 offset(static_cast<uint32_t>(first_vertices_[part]));
    has_turned_triangles_ = true;
    for (size_t i = still_triangles_; i < mesh_.triangles.size(); ++i) {
        const size_t number = triangle_number(i) - first_triangles_[part];  // wraps before it
        if (number < triangles.size()) mesh_.triangles[i] = triangles[number] + offset;
    }
}

void World::move_to(double time) {
    moved_.clear();
    moved_normals_.clear();
    has_turned_triangles_ = false;
    for (size_t i = 0; i < parts_.size(); ++i) {
        if (!parts_[i].moves()) continue;
        models_[i] = &parts_[i].at(time);
        overwrite(i);
    }
    choose_lights_and_camera(time);
}

void World::choose_environment(const SceneDescription& scene) {
    ambient_ = scene.ambient.value_or(kDefaultAmbient);
    environment_ = kDefaultEnvironment;
    for (auto model = models_.rbegin(); model != models_.rend(); ++model)
        environment_ = (*model)->background.value_or(environment_);
    if (!scene.environment) return;
    environment_ = scene.environment->colour;
    if (!scene.environment->image.empty())
        environment_texture_ = 1 + textures_.add(scene.environment->image);
}

void World::choose_lights_and_camera(double time) {
    std::optional<Camera> camera;
    if (scene_.camera) camera = camera_at(*scene_.camera, time);
    lights_.clear();
    for (const Model* model : models_) {
        if (!camera) camera = model->camera;
        lights_.insert(lights_.end(), model->lights.begin(), model->lights.end());
    }
    camera_ = camera ? *camera : camera_that_fits(mesh_);
    if (scene_.lights)
        place_lights(time);
    else if (lights_.empty())
        lights_.push_back(light_over_shoulder(camera_));
    if (lights_.size() > RSH_MAX_LIGHTS)
        throw std::runtime_error(fmt::format("found {} lights in all, allowed: at most {}",
                                             lights_.size(), RSH_MAX_LIGHTS));
}

void World::place_lights(double time) {
    lights_.clear();
    for (const SceneLight& light : *scene_.lights) lights_.push_back(light_at(light, time));
}

Interval World::time_span() const {
    std::optional<Interval> whole;
    const auto add = [&](double start, double end) {
        if (!whole) whole = Interval{start, end};
        whole->start = std::min(whole->start, start);
        whole->end = std::max(whole->end, end);
    };
    const auto add_keys = [&](const auto& keys) {
        if (!keys.empty()) add(keys.front().time, keys.back().time);
    };
    for (const Part& part : parts_)
        if (const auto span = part.time_span()) add(span->start, span->end);
    if (scene_.camera) add_keys(scene_.camera->keys);
    if (scene_.lights)
        for (const SceneLight& light : *scene_.lights) add_keys(light.keys);
    return whole.value_or(Interval{});
}

std::vector<std::string> World::warnings_at(double time) const {
    std::vector<std::string> warnings;
    const auto add = [&](const std::string& what, double start, double end) {
        if (!(end > start) || (time >= start && time <= end)) return;
        warnings.push_back(
            fmt::format("{}: moves from {} s to {} s; at {} s it stands as at its {}", what,
                        start, end, time, time < start ? "start" : "end"));
    };
    const auto add_keys = [&](const std::string& what, const auto& keys) {
        if (!keys.empty()) add(what, keys.front().time, keys.back().time);
    };
    for (const Part& part : parts_)
        if (const auto span = part.time_span(); span && !part.repeats())
            add(part.entry().where, span->start, span->end);
    if (scene_.camera) add_keys("camera", scene_.camera->keys);
    for (size_t i = 0; scene_.lights && i < scene_.lights->size(); ++i)
        add_keys(fmt::format("lights[{}]", i), (*scene_.lights)[i].keys);
    return warnings;
}

int World::frames() const {
    int most = 1;
    for (const Part& part : parts_) most = std::max(most, part.frames());
    return most;
}

}  // namespace render
