// schema.cpp - a function for each kind of object.
#include "import/gltf/file/schema.hpp"

#include <fmt/format.h>

#include <cmath>

namespace render {
namespace {

constexpr double kPi = 3.14159265358979323846, kHuge = 1e30;

class Schema {
public:
    Schema(const JsonValue& document, const GltfIndices& indices)
        : document_(document), indices_(indices) {}

    void check() const;

private:
    template <typename Check>
    void for_each(const char* array, const Check& check) const {
        const auto found = document_.find(array);
        if (!found) return;
        for (const JsonValue& item : found->items()) {
            if (!item.is_object()) item.fail("an object");
            check(item);
        }
    }
    void indices_of(const JsonValue& object, const char* key, const char* array) const;
    void check_attributes(const JsonValue& attributes) const;
    void check_mesh(const JsonValue& mesh) const;
    void check_node(const JsonValue& node) const;
    void check_texture_info(const JsonValue& object, const char* key) const;
    void check_material(const JsonValue& material) const;
    void check_animation(const JsonValue& animation) const;
    void check_channel(const JsonValue& channel, size_t samplers) const;
    void check_skin(const JsonValue& skin) const;
    void check_image(const JsonValue& image) const;
    void check_textures() const;

    const JsonValue& document_;
    const GltfIndices& indices_;
};

std::optional<JsonValue> extension(const JsonValue& object, const char* name) {
    const auto extensions = object.find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

void number_if_any(const JsonValue& object, const char* key, double low, double high) {
    if (const auto value = object.find(key)) value->number_in(low, high);
}

void numbers_if_any(const JsonValue& object, const char* key, size_t count) {
    if (const auto value = object.find(key)) value->numbers(count);
}

void text_if_any(const JsonValue& object, const char* key) {
    if (const auto value = object.find(key)) value->text();
}

// Each from 0 to `most`.
void factors_if_any(const JsonValue& object, const char* key, size_t count, double most) {
    const auto value = object.find(key);
    if (!value) return;
    for (const double factor : value->numbers(count))
        if (!(factor >= 0.0 && factor <= most))
            value->fail(fmt::format("an array of {} numbers from 0 to {}", count, most));
}

void Schema::indices_of(const JsonValue& object, const char* key, const char* array) const {
    if (const auto list = object.find(key))
        for (const JsonValue& item : list->items()) indices_.index(item, array);
}

void Schema::check_attributes(const JsonValue& attributes) const {
    for (const std::string& name : attributes.keys())
        indices_.index(attributes.member(name), "accessors");
}

void Schema::check_mesh(const JsonValue& mesh) const {
    const auto primitives = mesh.member("primitives").items();
    if (primitives.empty()) mesh.member("primitives").fail("an array of at least one");
    for (const JsonValue& primitive : primitives) {
        check_attributes(primitive.member("attributes"));
        indices_.index_if_any(primitive, "indices", "accessors");
        indices_.index_if_any(primitive, "material", "materials");
        whole_number(primitive, "mode", 0, 6, 4);
        if (const auto targets = primitive.find("targets"))
            for (const JsonValue& target : targets->items()) check_attributes(target);
    }
    if (const auto weights = mesh.find("weights")) weights->numbers(weights->items().size());
}

void Schema::check_node(const JsonValue& node) const {
    indices_.index_if_any(node, "mesh", "meshes");
    indices_.index_if_any(node, "skin", "skins");
    indices_.index_if_any(node, "camera", "cameras");
    indices_of(node, "children", "nodes");
    numbers_if_any(node, "translation", 3);
    numbers_if_any(node, "scale", 3);
    numbers_if_any(node, "matrix", 16);
    if (const auto rotation = node.find("rotation")) {
        double square = 0.0;
        for (const double x : rotation->numbers(4)) square += x * x;
        if (!(square > 0.0)) rotation->fail("a quaternion [x, y, z, w] that is not 0");
    }
    if (const auto weights = node.find("weights")) weights->numbers(weights->items().size());
    if (const auto light = extension(node, "KHR_lights_punctual"))
        indices_.index(light->member("light"), "lights");
}

void Schema::check_texture_info(const JsonValue& object, const char* key) const {
    const auto info = object.find(key);
    if (!info) return;
    indices_.index(info->member("index"), "textures");
    whole_number(*info, "texCoord", 0, 15, 0);
}

void Schema::check_material(const JsonValue& material) const {
    text_if_any(material, "name");
    if (const auto pbr = material.find("pbrMetallicRoughness")) {
        factors_if_any(*pbr, "baseColorFactor", 4, 1.0);
        number_if_any(*pbr, "metallicFactor", 0.0, 1.0);
        number_if_any(*pbr, "roughnessFactor", 0.0, 1.0);
        check_texture_info(*pbr, "baseColorTexture");
        check_texture_info(*pbr, "metallicRoughnessTexture");
    }
    factors_if_any(material, "emissiveFactor", 3, 1.0);
    for (const char* key : {"normalTexture", "occlusionTexture", "emissiveTexture"})
        check_texture_info(material, key);
    if (const auto mode = material.find("alphaMode")) mode->one_of({"OPAQUE", "MASK", "BLEND"});
    if (const auto glass = extension(material, "KHR_materials_transmission")) {
        number_if_any(*glass, "transmissionFactor", 0.0, 1.0);
        check_texture_info(*glass, "transmissionTexture");
    }
    if (const auto glass = extension(material, "KHR_materials_ior"))
        if (const auto ior = glass->find("ior"); ior && ior->number() != 0.0)
            ior->number_in(1.0, 100.0);
}

void Schema::check_channel(const JsonValue& channel, size_t samplers) const {
    const JsonValue sampler = channel.member("sampler");
    if (samplers == 0) sampler.fail("no index: the animation has no samplers");
    whole_number(sampler, 0, static_cast<int64_t>(samplers) - 1);
    const JsonValue target = channel.member("target");
    indices_.index_if_any(target, "node", "nodes");
    target.member("path").one_of({"translation", "rotation", "scale", "weights"});
}

void Schema::check_animation(const JsonValue& animation) const {
    text_if_any(animation, "name");
    const auto samplers = animation.member("samplers").items();
    for (const JsonValue& sampler : samplers) {
        indices_.index(sampler.member("input"), "accessors");
        indices_.index(sampler.member("output"), "accessors");
        if (const auto way = sampler.find("interpolation"))
            way->one_of({"LINEAR", "STEP", "CUBICSPLINE"});
    }
    for (const JsonValue& channel : animation.member("channels").items())
        check_channel(channel, samplers.size());
}

void Schema::check_skin(const JsonValue& skin) const {
    indices_.index_if_any(skin, "inverseBindMatrices", "accessors");
    const JsonValue joints = skin.member("joints");
    if (joints.items().empty()) joints.fail("an array of at least one node");
    indices_of(skin, "joints", "nodes");
}

void Schema::check_image(const JsonValue& image) const {
    if (image.has("uri") == image.has("bufferView"))
        image.fail("either an \"uri\" or a \"bufferView\"");
    text_if_any(image, "uri");
    indices_.index_if_any(image, "bufferView", "bufferViews");
}

void Schema::check_textures() const {
    for_each("images", [&](const JsonValue& image) { check_image(image); });
    for_each("textures", [&](const JsonValue& texture) {
        indices_.index_if_any(texture, "source", "images");
        indices_.index_if_any(texture, "sampler", "samplers");
    });
    for_each("samplers", [&](const JsonValue& sampler) {
        for (const char* key : {"wrapS", "wrapT"}) {
            const int64_t wrap = whole_number(sampler, key, 0, 65535, 10497);
            if (wrap != 10497 && wrap != 33071 && wrap != 33648)
                sampler.member(key).fail("10497 (repeat), 33071 (clamp), 33648 (mirror)");
        }
    });
}

void check_camera(const JsonValue& camera) {
    if (camera.member("type").one_of({"perspective", "orthographic"}) == "orthographic") return;
    const JsonValue perspective = camera.member("perspective");
    perspective.member("yfov").number_in(1e-4, kPi - 1e-2);
    perspective.member("znear").number_in(0.0, kHuge);
}

void check_light(const JsonValue& light) {
    const std::string type = light.member("type").one_of({"point", "directional", "spot"});
    factors_if_any(light, "color", 3, kHuge);
    number_if_any(light, "intensity", 0.0, kHuge);
    number_if_any(light, "range", 0.0, kHuge);
    if (type != "spot") return;
    const JsonValue spot = light.member("spot");
    double outer = kPi / 4.0;
    if (const auto angle = spot.find("outerConeAngle"))
        outer = angle->number_in(1e-4, kPi / 2.0 + 1e-6);
    number_if_any(spot, "innerConeAngle", 0.0, outer);
}

void Schema::check() const {
    if (const auto scene = document_.find("scene")) indices_.index(*scene, "scenes");
    for_each("scenes", [&](const JsonValue& scene) { indices_of(scene, "nodes", "nodes"); });
    for_each("meshes", [&](const JsonValue& mesh) { check_mesh(mesh); });
    for_each("nodes", [&](const JsonValue& node) { check_node(node); });
    for_each("materials", [&](const JsonValue& material) { check_material(material); });
    for_each("animations", [&](const JsonValue& animation) { check_animation(animation); });
    for_each("skins", [&](const JsonValue& skin) { check_skin(skin); });
    for_each("cameras", check_camera);
    check_textures();
    if (const auto lights = extension(document_, "KHR_lights_punctual"))
        for (const JsonValue& light : lights->member("lights").items()) check_light(light);
}

}  // namespace

void check_schema(const JsonValue& document, const GltfIndices& indices) {
    Schema(document, indices).check();
}

}  // namespace render
