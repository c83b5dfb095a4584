// scene_file.cpp - whole scene files: syntax, plain meshes, and several files as one scene.
#include "scene/scene_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>

#include "files/asset.hpp"
#include "files/file_search.hpp"
#include "files/json_text.hpp"
#include "files/json_value.hpp"
#include "scene/scene_schema.hpp"

namespace render {
namespace {

namespace fs = std::filesystem;

SceneDescription plain_mesh(const std::string& path) {
    MeshEntry entry;
    entry.where = path;
    entry.file = path;
    SceneDescription scene;
    scene.meshes.push_back(entry);
    return scene;
}

SceneDescription read_one(const std::string& name) {
    const std::string path = find_file(name, search_folders("."), "SCENE");
    if (fs::path(path).extension() != ".json") return plain_mesh(path);
    return parse_scene(read_asset(path).bytes, path);
}

template <typename T>
void keep_first(std::optional<T>& merged, std::optional<T>& next) {
    if (!merged) merged = std::move(next);
}

void merge(SceneDescription& merged, SceneDescription&& next) {
    std::move(next.meshes.begin(), next.meshes.end(), std::back_inserter(merged.meshes));
    if (merged.lights && next.lights)
        merged.lights->insert(merged.lights->end(), next.lights->begin(), next.lights->end());
    else
        keep_first(merged.lights, next.lights);
    keep_first(merged.camera, next.camera);
    keep_first(merged.ambient, next.ambient);
    keep_first(merged.environment, next.environment);
    keep_first(merged.settings.size, next.settings.size);
    keep_first(merged.settings.bounces, next.settings.bounces);
    keep_first(merged.settings.min_weight, next.settings.min_weight);
    keep_first(merged.settings.cut, next.settings.cut);
    keep_first(merged.settings.frames, next.settings.frames);
    keep_first(merged.settings.time, next.settings.time);
    keep_first(merged.settings.still, next.settings.still);
}

}  // namespace

SceneDescription parse_scene(const std::string& text, const std::string& file) {
    const nlohmann::json document = parse_json(text, file);
    const std::string folder = fs::path(file).parent_path().string();
    return SceneSchema(search_folders(folder)).scene(JsonValue(document, file, ""));
}

SceneDescription read_scenes(const std::vector<std::string>& files) {
    SceneDescription merged;
    for (const std::string& file : files) merge(merged, read_one(file));
    return merged;
}

}  // namespace render
