// vertex_frames.cpp - a mesh, raw positions per frame and their description -> an animation.
#include "import/vertex_frames.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>

#include "files/asset.hpp"
#include "files/json_text.hpp"
#include "files/little_endian.hpp"
#include "files/text_scan.hpp"
#include "import/mesh_file.hpp"
#include "model/normals.hpp"

namespace render {
namespace {

struct Description {
    size_t frames = 0, vertices = 0, triangles = 0;
    double start = 0.0, end = 0.0;
};

template <typename T>
T member(const nlohmann::json& json, const char* name, const std::string& file) {
    if (!json.is_object() || !json.contains(name) || !json[name].is_number())
        throw LoadError(file + ": needs a number named " + name);
    if (std::is_unsigned_v<T> && !json[name].is_number_unsigned())
        throw LoadError(file + ": " + name + " is " + json[name].dump() +
                        ", but must be a whole number from 0");
    return json[name].get<T>();
}

Description read_description(const std::string& path) {
    const Asset asset = read_asset(path);
    const nlohmann::json json = parse_json(asset.bytes, asset.location);
    Description d;
    d.frames = member<size_t>(json, "frames", asset.location);
    d.vertices = member<size_t>(json, "vertices", asset.location);
    d.triangles = member<size_t>(json, "triangles", asset.location);
    d.start = member<double>(json, "time_start", asset.location);
    d.end = member<double>(json, "time_end", asset.location);
    if (d.frames == 0 || !(d.end >= d.start))
        throw LoadError(asset.location + ": needs frames >= 1 and time_start <= time_end");
    return d;
}

void check(const std::string& file, const char* what, size_t actual, size_t promised) {
    if (actual != promised)
        throw LoadError(file + ": holds " + std::to_string(actual) + " " + what +
                        ", but its description promises " + std::to_string(promised));
}

std::vector<glm::vec3> read_positions(const std::string& path, const Description& d) {
    const Asset asset = read_asset(path);
    // Divided, not multiplied: the product of two promises may overflow.
    check(asset.location, "bytes per frame and vertex",
          d.vertices == 0 ? 0 : asset.bytes.size() / d.frames / d.vertices, sizeof(glm::vec3));
    check(asset.location, "bytes", asset.bytes.size(),
          d.frames * d.vertices * sizeof(glm::vec3));
    std::vector<glm::vec3> positions(d.frames * d.vertices);
    for (size_t i = 0; i < 3 * positions.size(); ++i)
        positions[i / 3][static_cast<int>(i % 3)] =
            little_endian_float(asset.bytes.data() + 4 * i);
    return positions;
}

// Vertices that are one in the file and have the same normal there: they get one normal again.
std::vector<uint32_t> normal_groups(const NumberedModel& base) {
    std::map<std::tuple<uint32_t, float, float, float>, uint32_t> known;
    std::vector<uint32_t> groups;
    const std::vector<glm::vec3>& normals = base.model.mesh.normals;
    for (size_t i = 0; i < normals.size(); ++i) {
        const auto next = static_cast<uint32_t>(known.size());
        groups.push_back(
            known
                .emplace(std::tuple(base.source[i], normals[i].x, normals[i].y, normals[i].z),
                         next)
                .first->second);
    }
    return groups;
}

class VertexFrames : public Animation {
public:
    struct Span {
        double start = 0.0, end = 0.0;
        int frames = 1;  // the first at `start`, the last at `end`
    };
    VertexFrames(NumberedModel base, std::vector<glm::vec3> positions, Span span);

    double start() const override { return span_.start; }
    double end() const override { return span_.end; }
    int frames() const override { return span_.frames; }
    // Normals are computed anew if the mesh file has any.
    Model at(double time) const override;
    std::vector<VertexRange> moving_vertices() const override {
        return {{0, base_.model.mesh.positions.size()}};
    }

private:
    NumberedModel base_;
    std::vector<glm::vec3> positions_;
    Span span_;
    std::vector<uint32_t> normal_groups_;  // per vertex; empty without normals
};

VertexFrames::VertexFrames(NumberedModel base, std::vector<glm::vec3> positions, Span span)
    : base_(std::move(base)),
      positions_(std::move(positions)),
      span_(span),
      normal_groups_(normal_groups(base_)) {
    for (glm::vec3& p : positions_) p = glm::dvec3(p) - base_.model.mesh.origin;
}

Model VertexFrames::at(double time) const {
    Model model = base_.model;
    const double length = span_.end - span_.start;
    const double last = span_.frames - 1;
    const double place =
        length > 0.0 ? std::clamp((time - span_.start) / length, 0.0, 1.0) * last : 0.0;
    const auto frame =
        static_cast<size_t>(std::min(std::floor(place), std::max(last - 1.0, 0.0)));
    const size_t next = std::min(frame + 1, static_cast<size_t>(last));
    const auto u = static_cast<float>(place - static_cast<double>(frame));
    for (size_t i = 0; i < model.mesh.positions.size(); ++i) {
        const size_t vertex = base_.source[i];
        model.mesh.positions[i] = glm::mix(positions_[frame * base_.file_vertices + vertex],
                                           positions_[next * base_.file_vertices + vertex], u);
    }
    if (!model.mesh.normals.empty())
        model.mesh.normals = smooth_normals(model.mesh, normal_groups_);
    return model;
}

}  // namespace

std::unique_ptr<Animation> load_vertex_frames(const std::string& mesh,
                                              const std::string& frames,
                                              const std::string& json) {
    const std::string beside =
        std::filesystem::path(frames).replace_extension(".json").string();
    const Description d = read_description(json.empty() ? beside : json);
    NumberedModel base = load_numbered_mesh(mesh);
    check(mesh, "vertices", base.file_vertices, d.vertices);
    check(mesh, "triangles", base.model.mesh.triangles.size(), d.triangles);
    return std::make_unique<VertexFrames>(
        std::move(base), read_positions(frames, d),
        VertexFrames::Span{d.start, d.end, static_cast<int>(d.frames)});
}

}  // namespace render
