// aff_parser.cpp - AFF files -> AffScene: what each command means, and where transforms begin and end.
#include <algorithm>
#include <cfloat>
#include <set>

#include "files/text_scan.hpp"
#include "import/bart/aff_geometry.hpp"
#include "import/bart/aff_keys.hpp"
#include "import/bart/aff_materials.hpp"
#include "import/bart/aff_scene.hpp"
#include "import/bart/aff_tokens.hpp"
#include "model/warnings.hpp"

namespace render {
namespace {

// A file may be included more than once.
void keep_first_of_each(std::vector<std::string>& warnings) {
    std::set<std::string> seen;
    const auto is_known = [&](const std::string& text) { return !seen.insert(text).second; };
    warnings.erase(std::remove_if(warnings.begin(), warnings.end(), is_known), warnings.end());
}

class AffParser {
public:
    explicit AffParser(const std::string& path) : tokens_(path) {}

    AffScene parse() {
        try {
            read();
        } catch (const LoadError& error) {
            throw LoadError(with_warnings(error.what(), scene_.warnings));
        }
        return std::move(scene_);
    }

private:
    void read() {
        for (std::string word = tokens_.next(); !word.empty(); word = tokens_.next()) run(word);
        if (!open_.empty())
            tokens_.fail("ends with " + std::to_string(open_.size()) +
                         " transforms not closed");
        warn_of_names();
        keep_first_of_each(scene_.warnings);
        materials_.plain();  // there is at least one
        if (!materials_.has_textures()) scene_.mesh.texcoords.clear();
    }

    using Command = void (*)(AffParser&);

    void run(const std::string& word) {
        static const std::map<std::string, Command> kCommands = {
            {"v", [](AffParser& p) { p.view(); }},
            {"b", [](AffParser& p) { p.background(); }},
            {"am", [](AffParser& p) { p.ambient(); }},
            {"l", [](AffParser& p) { p.light(); }},
            {"la", [](AffParser& p) { p.moving_light(); }},
            {"f", [](AffParser& p) { p.materials_.read_plain_fill(); }},
            {"fm", [](AffParser& p) { p.materials_.read_fill(); }},
            {"p", [](AffParser& p) { p.geometry_.read_polygon(); }},
            {"pp", [](AffParser& p) { p.geometry_.read_patch(); }},
            {"tt", [](AffParser& p) { p.geometry_.read_textured_triangle(); }},
            {"ttp", [](AffParser& p) { p.geometry_.read_textured_patch(); }},
            {"tpa", [](AffParser& p) { p.geometry_.read_moving_triangle(); }},
            {"s", [](AffParser& p) { p.geometry_.read_sphere(); }},
            {"c", [](AffParser& p) { p.geometry_.read_cone(); }},
            {"m", [](AffParser& p) { p.geometry_.read_mesh(); }},
            {"xs", [](AffParser& p) { p.transform(); }},
            {"x", [](AffParser& p) { p.moving_transform(); }},
            {"}", [](AffParser& p) { p.close_transform(); }},
            {"k", [](AffParser& p) { p.keys(); }},
            {"a", [](AffParser& p) { p.timing(); }},
            {"i", [](AffParser& p) { p.include(); }},
            {"d", [](AffParser& p) { p.detail(); }}};
        const auto command = kCommands.find(word);
        if (command == kCommands.end()) tokens_.fail("unknown command '" + word + "'");
        command->second(*this);
    }

    // What moves by keys that are not there, and keys that move nothing.
    void warn_of_names() {
        for (const auto& [name, where] : moved_)
            if (scene_.tracks.find(name) == scene_.tracks.end())
                scene_.warnings.push_back(where + ": '" + name +
                                          "' has no keys, so it stands still");
        for (const auto& [name, where] : keys_at_)
            if (name != kCameraKeys && moved_.find(name) == moved_.end())
                scene_.warnings.push_back(where + ": the keys '" + name + "' move nothing");
    }

    bool has_number() { return parse_number(tokens_.peek()).has_value(); }

    float real(const char* what) { return static_cast<float>(tokens_.number(what)); }

    float real_in(const char* what, float low, float high) {
        const float value = real(what);
        if (!(value >= low && value <= high))
            tokens_.fail(std::string(what) + " is " + std::to_string(value) +
                         ", but must be from " + std::to_string(low) + " to " +
                         std::to_string(high));
        return value;
    }

    void view() {
        Camera camera;
        for (;;) {
            const std::string word = tokens_.peek();
            if (word == "from" || word == "at" || word == "up" || word == "angle" ||
                word == "hither" || word == "resolution")
                read_view_item(tokens_.next(), camera);
            else
                break;
        }
        scene_.camera = camera;
    }

    void read_view_item(const std::string& word, Camera& camera) {
        if (word == "from") camera.eye = tokens_.vector("from");
        if (word == "at") camera.at = tokens_.vector("at");
        if (word == "up") camera.up = tokens_.vector("up");
        if (word == "angle") camera.vertical_degrees = real_in("angle", 0.01f, 179.0f);
        if (word == "hither") camera.near = real_in("hither", 0.0f, FLT_MAX);
        if (word == "resolution") tokens_.number("width"), tokens_.number("height");
    }

    void background() { scene_.background = glm::vec3(tokens_.vector("background")); }
    void ambient() { scene_.ambient = tokens_.vector("ambient light"); }

    void light() { add_light({}); }
    void moving_light() { add_light(moved_name("the name of a light")); }

    std::string moved_name(const char* what) {
        std::string name = tokens_.word(what);
        moved_.emplace(name, tokens_.where());
        return name;
    }

    void add_light(const std::string& track) {
        AffLight light;
        light.light.position = tokens_.vector("position of a light");
        if (has_number()) light.light.colour = tokens_.vector("colour of a light");
        light.node = geometry_.node;
        light.track = track;
        scene_.lights.push_back(light);
    }

    void open_transform(AffNode node) {
        tokens_.expect("{");
        node.parent = geometry_.node;
        open_.push_back(geometry_.node);
        geometry_.node = scene_.nodes.size();
        scene_.nodes.push_back(std::move(node));
    }

    void transform() {
        const glm::dvec3 scale = tokens_.vector("scale");
        const glm::dvec3 axis = tokens_.vector("axis");
        const double degrees = tokens_.number("angle");
        const glm::dvec3 shift = tokens_.vector("translation");
        AffNode node;
        const glm::dmat4 rotation = glm::mat4_cast(rotation_about(axis, degrees));
        node.matrix = rotation;
        for (int i = 0; i < 3; ++i) node.matrix[i] *= scale[i];
        node.matrix[3] = glm::dvec4(shift, 1.0);
        open_transform(std::move(node));
    }

    void moving_transform() {
        AffNode node;
        node.track = moved_name("the name of a transform");
        open_transform(std::move(node));
    }

    void close_transform() {
        if (open_.empty()) tokens_.fail("closes a transform, but none is open");
        geometry_.node = open_.back();
        open_.pop_back();
    }

    void keys() {
        const std::string name = tokens_.word("the name of keys");
        keys_at_.emplace(name, tokens_.where());
        Track& track = scene_.tracks[name];
        tokens_.expect("{");
        for (std::string kind = tokens_.word("}"); kind != "}"; kind = tokens_.word("}")) {
            if (kind == "transl")
                track.translation = keys_.curve(kind, name);
            else if (kind == "scale")
                track.scale = keys_.curve(kind, name);
            else if (kind == "rot")
                track.rotation = keys_.curve(kind, name);
            else if (kind == "visibility")
                track.visibility = keys_.visibility(name);
            else
                tokens_.fail("unknown keys '" + kind + "'");
        }
    }

    void timing() {
        scene_.start = tokens_.number("start");
        scene_.end = tokens_.number("end");
        const double frames = tokens_.number("frames");
        if (!(frames >= 1.0 && frames <= 1e6) || !(scene_.end >= scene_.start))
            tokens_.fail("an animation needs start <= end and 1 to 1000000 frames");
        scene_.frames = static_cast<int>(frames);
    }

    void include() {
        const double level = tokens_.number("level of detail");
        const std::string name = tokens_.word("the name of a file");
        if (level > detail_ || tokens_.include(name)) return;
        scene_.warnings.push_back(tokens_.where() + ": includes " + name +
                                  ", which is not there and left out");
    }

    void detail() { detail_ = tokens_.number("level of detail"); }

    AffTokens tokens_;
    AffScene scene_;
    AffKeys keys_{tokens_, scene_.warnings};
    AffMaterials materials_{tokens_, scene_};
    AffGeometry geometry_{tokens_, scene_, materials_, keys_};
    std::vector<size_t> open_;  // the nodes around the present one
    // Names of what keys are to move, and of keys, with the place where they stand first.
    std::map<std::string, std::string> moved_, keys_at_;
    double detail_ = 0.0;
};

}  // namespace

AffScene parse_aff(const std::string& path) {
    return AffParser(path).parse();
}

}  // namespace render
