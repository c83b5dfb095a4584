// aff_parser.cpp - AFF files -> AffScene, one function per command. Textures are named but not
// read: BART's were never part of the data that can be had, so their coordinates are skipped.
//
// Materials: "specular" is BART's word for both the highlight and the mirror, T for how much
// passes through; so reflection = specular and transmission = T in all channels, with ior.
#include <cfloat>
#include <cmath>
#include <set>

#include "files/text_scan.hpp"
#include "import/bart/aff_keys.hpp"
#include "import/bart/aff_scene.hpp"
#include "import/bart/aff_shapes.hpp"
#include "import/bart/aff_tokens.hpp"
#include "model/polygon.hpp"
#include "model/warnings.hpp"

namespace render {
namespace {

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
        for (const std::string& texture : textures_)
            scene_.warnings.push_back("texture " + texture + " is ignored");
        if (scene_.materials.empty()) scene_.materials.push_back({});
    }

    using Command = void (AffParser::*)();

    void run(const std::string& word) {
        static const std::map<std::string, Command> kCommands = {
            {"v", &AffParser::view},
            {"b", &AffParser::background},
            {"am", &AffParser::ambient},
            {"l", &AffParser::light},
            {"la", &AffParser::moving_light},
            {"f", &AffParser::plain_material},
            {"fm", &AffParser::material},
            {"p", &AffParser::polygon},
            {"pp", &AffParser::patch},
            {"tt", &AffParser::textured_triangle},
            {"ttp", &AffParser::textured_patch},
            {"tpa", &AffParser::moving_triangle},
            {"s", &AffParser::sphere},
            {"c", &AffParser::cone},
            {"m", &AffParser::mesh},
            {"xs", &AffParser::transform},
            {"x", &AffParser::moving_transform},
            {"}", &AffParser::close_transform},
            {"k", &AffParser::keys},
            {"a", &AffParser::timing},
            {"i", &AffParser::include},
            {"d", &AffParser::detail}};
        const auto command = kCommands.find(word);
        if (command == kCommands.end()) tokens_.fail("unknown command '" + word + "'");
        (this->*command->second)();
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
    void moving_light() { add_light(tokens_.word("the name of a light")); }

    void add_light(const std::string& track) {
        AffLight light;
        light.light.position = tokens_.vector("position of a light");
        if (has_number()) light.light.colour = tokens_.vector("colour of a light");
        light.node = node_;
        light.track = track;
        scene_.lights.push_back(light);
    }

    void plain_material() {
        Material m;
        const glm::vec3 colour = tokens_.vector("colour");
        m.diffuse = real("Kd") * colour;
        m.ambient = m.diffuse;
        m.specular = glm::vec3(real("Ks"));
        add_material(m);
    }

    void material() {
        Material m;
        m.ambient = tokens_.vector("ambient");
        m.diffuse = tokens_.vector("diffuse");
        m.specular = tokens_.vector("specular");
        add_material(m);
    }

    void add_material(Material m) {
        m.name = "aff" + std::to_string(scene_.materials.size());
        m.shininess = real("Shine");
        m.reflection = m.specular;
        m.transmission = glm::vec3(real("T"));
        const float ior = real("ior");
        m.ior = m.transmission.x > 0.0f && ior > 0.0f ? ior : 1.0f;
        scene_.materials.push_back(m);
    }

    uint32_t add_vertex(glm::vec3 position, glm::vec3 normal) {
        scene_.mesh.positions.push_back(position);
        scene_.mesh.normals.push_back(normal);
        scene_.vertex_nodes.push_back(node_);
        return static_cast<uint32_t>(scene_.mesh.positions.size()) - 1;
    }

    void add_triangle(glm::uvec3 triangle) {
        if (scene_.materials.empty()) scene_.materials.push_back({});
        scene_.mesh.triangles.push_back(triangle);
        scene_.mesh.material_ids.push_back(static_cast<uint32_t>(scene_.materials.size()) - 1);
    }

    void polygon() { read_polygon(tokens_.count("corners", 3), false, false); }
    void patch() { read_polygon(tokens_.count("corners", 6), true, false); }
    void textured_triangle() { ignore_texture(), read_polygon(3, false, true); }
    void textured_patch() { ignore_texture(), read_polygon(3, true, true); }
    void ignore_texture() { textures_.insert(tokens_.word("the name of a texture")); }

    void read_polygon(size_t corners, bool has_normals, bool has_texcoords) {
        std::vector<glm::vec3> points;
        const auto first = static_cast<uint32_t>(scene_.mesh.positions.size());
        for (size_t i = 0; i < corners; ++i) {
            points.push_back(tokens_.vector("corner"));
            const glm::vec3 normal = has_normals ? tokens_.vector("normal") : glm::dvec3(0.0);
            add_vertex(points.back(), normal);
            if (has_texcoords) tokens_.number("u"), tokens_.number("v");
        }
        for (const glm::uvec3 t : triangulate({points.begin(), points.end()}))
            add_triangle(first + t);
    }

    void moving_triangle() {
        AffMorph morph = keys_.morph();
        const auto& key = morph.keys[0];
        morph.first_vertex = add_vertex(key[0], key[1]);
        add_vertex(key[2], key[3]);
        add_vertex(key[4], key[5]);
        add_triangle(morph.first_vertex + glm::uvec3(0, 1, 2));
        scene_.morphs.push_back(std::move(morph));
    }

    void sphere() {
        const glm::dvec3 centre = tokens_.vector("centre");
        add_shape(make_sphere(centre, tokens_.number("radius")));
    }

    void cone() {
        const glm::dvec3 base = tokens_.vector("base");
        const double base_radius = tokens_.number("base radius");
        const glm::dvec3 apex = tokens_.vector("apex");
        add_shape(make_cone(base, base_radius, apex, tokens_.number("apex radius")));
    }

    void add_shape(const Shape& shape) {
        const auto first = static_cast<uint32_t>(scene_.mesh.positions.size());
        for (size_t i = 0; i < shape.positions.size(); ++i)
            add_vertex(shape.positions[i], shape.normals[i]);
        for (const glm::uvec3 t : shape.triangles) add_triangle(first + t);
    }

    std::vector<glm::vec3> vectors(const char* what) {
        std::vector<glm::vec3> result;
        for (size_t i = 0, n = tokens_.count(what, 3); i < n; ++i)
            result.push_back(tokens_.vector(what));
        return result;
    }

    void mesh() {
        tokens_.expect("vertices");
        const std::vector<glm::vec3> vertices = vectors("vertices");
        std::vector<glm::vec3> normals;
        if (tokens_.peek() == "normals") tokens_.next(), normals = vectors("normals");
        bool has_texcoords = false;
        while (tokens_.peek() == "texturecoords") skip_texcoords(), has_texcoords = true;
        tokens_.expect("triangles");
        std::map<std::pair<size_t, size_t>, uint32_t> known;  // by vertex and normal
        for (size_t i = 0, n = tokens_.count("triangles", 3); i < n; ++i) {
            size_t vertex[3], normal[3] = {0, 0, 0};
            for (size_t& v : vertex) v = index("vertex", vertices.size());
            if (!normals.empty())
                for (size_t& v : normal) v = index("normal", normals.size());
            if (has_texcoords)
                for (int k = 0; k < 3; ++k) tokens_.number("index of a texture coordinate");
            glm::uvec3 triangle;
            for (int k = 0; k < 3; ++k) {
                const auto [entry, is_new] = known.emplace(std::pair(vertex[k], normal[k]), 0u);
                if (is_new)
                    entry->second =
                        add_vertex(vertices[vertex[k]],
                                   normals.empty() ? glm::vec3(0.0f) : normals[normal[k]]);
                triangle[k] = entry->second;
            }
            add_triangle(triangle);
        }
    }

    size_t index(const char* what, size_t count) {
        const double value = tokens_.number(what);
        if (!(value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value)))
            tokens_.fail(std::string("the index of a ") + what + " is " +
                         std::to_string(value) + ", but must be whole, and there are " +
                         std::to_string(count));
        return static_cast<size_t>(value);
    }

    void skip_texcoords() {
        tokens_.expect("texturecoords");
        const size_t n = tokens_.count("texture coordinates", 2);
        ignore_texture();
        for (size_t i = 0; i < 2 * n; ++i) tokens_.number("texture coordinate");
    }

    void open_transform(AffNode node) {
        tokens_.expect("{");
        node.parent = node_;
        open_.push_back(node_);
        node_ = scene_.nodes.size();
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
        node.track = tokens_.word("the name of a transform");
        open_transform(std::move(node));
    }

    void close_transform() {
        if (open_.empty()) tokens_.fail("closes a transform, but none is open");
        node_ = open_.back();
        open_.pop_back();
    }

    void keys() {
        const std::string name = tokens_.word("the name of keys");
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
        if (level <= detail_) tokens_.include(name);
    }

    void detail() { detail_ = tokens_.number("level of detail"); }

    AffTokens tokens_;
    AffScene scene_;
    AffKeys keys_{tokens_, scene_.warnings};
    size_t node_ = 0;
    std::vector<size_t> open_;  // the nodes around the present one
    std::set<std::string> textures_;
    double detail_ = 0.0;
};

}  // namespace

AffScene parse_aff(const std::string& path) {
    return AffParser(path).parse();
}

}  // namespace render
