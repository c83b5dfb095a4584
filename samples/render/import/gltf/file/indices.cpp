// indices.cpp - whole numbers within their bounds.
#include "import/gltf/file/indices.hpp"

#include <fmt/format.h>

namespace render {
namespace {

constexpr const char* kArrays[] = {
    "accessors", "animations", "buffers",  "bufferViews", "cameras", "images",  "materials",
    "meshes",    "nodes",      "samplers", "scenes",      "skins",   "textures"};

}  // namespace

int64_t whole_number(const JsonValue& value, int64_t low, int64_t high) {
    if (value.is_number() && !value.is_integer())
        value.fail(fmt::format("a whole number from {} to {}, without a point", low, high));
    return value.integer_in(low, high);
}

int64_t whole_number(const JsonValue& object, const char* key, int64_t low, int64_t high,
                     int64_t otherwise) {
    const auto value = object.find(key);
    return value ? whole_number(*value, low, high) : otherwise;
}

GltfIndices::GltfIndices(const JsonValue& document) {
    for (const char* array : kArrays) {
        const auto value = document.find(array);
        counts_[array] = value ? value->items().size() : 0;
    }
    counts_["lights"] = 0;
    const auto extensions = document.find("extensions");
    const auto lights = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    if (lights) counts_["lights"] = lights->member("lights").items().size();
}

size_t GltfIndices::index(const JsonValue& value, const char* array) const {
    const size_t count = counts_.at(array);
    if (count == 0) value.fail(fmt::format("no index: the file has no {}", array));
    return static_cast<size_t>(whole_number(value, 0, static_cast<int64_t>(count) - 1));
}

void GltfIndices::index_if_any(const JsonValue& object, const char* key,
                               const char* array) const {
    if (const auto value = object.find(key)) index(*value, array);
}

}  // namespace render
