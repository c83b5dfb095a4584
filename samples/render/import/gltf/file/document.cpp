// document.cpp - checks, then tinygltf.
#include "import/gltf/file/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "files/asset.hpp"
#include "files/json_text.hpp"
#include "files/references.hpp"
#include "files/text_scan.hpp"
#include "import/gltf/file/container.hpp"
#include "import/gltf/file/ranges.hpp"
#include "import/gltf/file/schema.hpp"

namespace render {
namespace {

constexpr const char* kKnownExtensions[] = {"KHR_lights_punctual", "KHR_materials_ior",
                                            "KHR_materials_transmission"};

std::vector<std::string> unknown_extensions(const JsonValue& document, const char* key) {
    std::vector<std::string> unknown;
    const auto list = document.find(key);
    if (!list) return unknown;
    for (const JsonValue& item : list->items()) {
        const std::string name = item.text();
        const auto* end = std::end(kKnownExtensions);
        if (std::find(std::begin(kKnownExtensions), end, name) == end) unknown.push_back(name);
    }
    return unknown;
}

void check_extensions(const JsonValue& document, std::vector<std::string>& warnings) {
    const auto required = unknown_extensions(document, "extensionsRequired");
    if (!required.empty())
        throw LoadError(fmt::format("{}: extensionsRequired: found {}, known are {}",
                                    document.where(), fmt::join(required, ", "),
                                    fmt::join(kKnownExtensions, ", ")));
    const auto used = unknown_extensions(document, "extensionsUsed");
    if (!used.empty())
        warnings.push_back(fmt::format("{}: extensions {} are ignored", document.where(),
                                       fmt::join(used, ", ")));
}

void check_version(const JsonValue& document) {
    const JsonValue asset = document.member("asset");
    if (const auto least = asset.find("minVersion")) {
        if (least->text() != "2.0") least->fail("\"2.0\"");
        return;
    }
    if (asset.member("version").text().rfind("2.", 0) != 0)
        asset.member("version").fail("\"2.0\", or a later one that begins with 2");
}

// What tinygltf reads without asking, or refuses without naming the member.
void check(const GltfContainer& container, const std::string& location,
           std::vector<std::string>& warnings) {
    const nlohmann::json json = parse_json(container.json, location);
    const JsonValue document(json, location, "");
    if (!document.is_object()) document.fail("an object");
    check_version(document);
    check_extensions(document, warnings);
    const GltfIndices indices(document);
    check_ranges(document, indices, container.binary_bytes);
    check_schema(document, indices);
}

// tinygltf's calls for the files that buffers name, here as in asset.hpp.
bool file_may_exist(const std::string&, void*) {
    return true;
}

std::string unchanged(const std::string& path, void*) {
    return path;
}

bool read_file(std::vector<unsigned char>* bytes, std::string* error, const std::string& name,
               void* location) try {
    const Asset asset = read_asset(find_reference(*static_cast<std::string*>(location), name));
    bytes->assign(asset.bytes.begin(), asset.bytes.end());
    return true;
} catch (const std::exception& failure) {
    *error = failure.what();
    return false;
}

bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
    image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

void load(const Asset& asset, bool is_binary, GltfDocument& document) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_encoded, nullptr);
    loader.SetFsCallbacks({file_may_exist, unchanged, read_file, nullptr, &document.location});
    std::string error, warning;
    const auto size = static_cast<unsigned>(asset.bytes.size());
    const bool is_read =
        is_binary ? loader.LoadBinaryFromMemory(
                        &document.model, &error, &warning,
                        reinterpret_cast<const unsigned char*>(asset.bytes.data()), size)
                  : loader.LoadASCIIFromString(&document.model, &error, &warning,
                                               asset.bytes.data(), size, "");
    if (!is_read)
        throw LoadError(document.location + ": " + std::string(trimmed(error + warning)));
}

}  // namespace

GltfDocument read_gltf_document(const std::string& path) {
    const Asset asset = read_asset(path);
    GltfDocument document;
    document.location = asset.location;
    const GltfContainer container = open_container(asset.bytes, asset.location);
    check(container, asset.location, document.warnings);
    load(asset, container.is_binary, document);
    return document;
}

}  // namespace render
