// gltf_reader.cpp - a glTF document -> a GltfScene: primitives once, and where nodes place them.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "import/gltf/gltf_clip.hpp"
#include "import/gltf/gltf_lights.hpp"
#include "import/gltf/gltf_material.hpp"
#include "import/gltf/gltf_nodes.hpp"
#include "import/gltf/gltf_primitive.hpp"
#include "model/warnings.hpp"

namespace render {
namespace {

// Of a file: what it names again and again takes no bytes of it.
constexpr size_t kMostCorners = size_t{1} << 27;

class Reader {
public:
    Reader(GltfDocument& document, const std::string& clip) : document_(document) {
        scene_.materials = gltf_materials(document);
        read_nodes(document, scene_);
        read_skins(document, scene_);
        const std::vector<bool> is_in_scene = nodes_of_scene(document, scene_);
        for (uint32_t node = 0; node < is_in_scene.size(); ++node)
            if (is_in_scene[node]) place_mesh(node);
        read_lights_and_camera(document, is_in_scene, scene_);
        if (const auto chosen = choose_clip(document, clip))
            scene_.curves = read_clip(document, *chosen, scene_, targets());
        warn();
        scene_.warnings = document.warnings;
    }

    GltfScene scene() && { return std::move(scene_); }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw std::runtime_error(document_.location + ": " + message);
    }

    // Their numbers in scene.primitives.
    const std::vector<size_t>& primitives(size_t mesh) {
        const auto [found, is_new] = primitives_.emplace(mesh, std::vector<size_t>());
        if (!is_new) return found->second;
        const auto& list = document_.model.meshes[mesh].primitives;
        for (size_t i = 0; i < list.size(); ++i) {
            const std::string where = fmt::format("meshes[{}].primitives[{}]", mesh, i);
            if (list[i].targets.size() != list[0].targets.size())
                fail(
                    fmt::format("{}: has {} morph targets, must have {} as the first primitive",
                                where, list[i].targets.size(), list[0].targets.size()));
            count(list[i], where);
            if (auto primitive = read_primitive(document_, list[i], where, left_out_)) {
                found->second.push_back(scene_.primitives.size());
                scene_.primitives.push_back(std::move(*primitive));
            }
        }
        return found->second;
    }

    void count(const tinygltf::Primitive& primitive, const std::string& where) {
        const auto elements = [&](int accessor) {
            return document_.model.accessors[static_cast<size_t>(accessor)].count;
        };
        for (const auto& [name, accessor] : primitive.attributes)
            corners_ += elements(accessor);
        for (const auto& target : primitive.targets)
            for (const auto& [name, accessor] : target) corners_ += elements(accessor);
        if (primitive.indices >= 0) corners_ += elements(primitive.indices);
        require_few_corners(where);
    }

    void require_few_corners(const std::string& where) const {
        if (corners_ > kMostCorners)
            fail(
                fmt::format("{}: the file's vertices and corners are {} up to here, must be at "
                            "most {}",
                            where, corners_, kMostCorners));
    }

    void place_mesh(uint32_t node) {
        const tinygltf::Node& n = document_.model.nodes[node];
        if (n.mesh < 0) return;
        set_weights(node);
        for (const size_t primitive : primitives(static_cast<size_t>(n.mesh))) {
            GltfPlacement placement;
            placement.primitive = primitive;
            placement.node = node;
            placement.first_vertex = vertices_;
            placement.first_triangle = triangles_;
            const GltfPrimitive& p = scene_.primitives[primitive];
            if (n.skin >= 0 && p.influences > 0) {
                placement.skin = static_cast<uint32_t>(n.skin);
                check_joints(p, node, placement.skin);
            }
            vertices_ += p.positions.size();
            triangles_ += p.triangles.size();
            corners_ += p.positions.size() + p.triangles.size();
            require_few_corners(fmt::format("nodes[{}].mesh", node));
            scene_.placements.push_back(placement);
        }
    }

    // The node's, else the mesh's, else 0.
    void set_weights(uint32_t node) {
        const auto& mesh =
            document_.model.meshes[static_cast<size_t>(document_.model.nodes[node].mesh)];
        std::vector<float>& weights = scene_.nodes[node].weights;
        const bool is_own = !weights.empty();
        if (!is_own) weights.assign(mesh.weights.begin(), mesh.weights.end());
        const size_t targets = mesh.primitives[0].targets.size();
        if (weights.empty()) weights.resize(targets);
        if (weights.size() != targets)
            fail(fmt::format(
                "{}: has {} numbers, must have one for each of {} morph targets",
                is_own ? fmt::format("nodes[{}].weights", node)
                       : fmt::format("meshes[{}].weights", document_.model.nodes[node].mesh),
                weights.size(), targets));
    }

    void check_joints(const GltfPrimitive& p, uint32_t node, uint32_t skin) const {
        const size_t joints = scene_.skins[skin].joints.size();
        for (size_t i = 0; i < p.joints.size(); ++i)
            if (p.joints[i] >= joints)
                fail(
                    fmt::format("nodes[{}].mesh: vertex {} names joint {}, must be below {}, "
                                "the joints of skins[{}]",
                                node, i / p.influences, p.joints[i], joints, skin));
    }

    std::vector<size_t> targets() const {
        std::vector<size_t> targets;
        for (const tinygltf::Node& node : document_.model.nodes)
            targets.push_back(
                node.mesh < 0
                    ? 0
                    : document_.model.meshes[size_t(node.mesh)].primitives[0].targets.size());
        return targets;
    }

    void warn() {
        const auto add = [&](size_t count, const char* what) {
            if (count > 0)
                document_.warnings.push_back(
                    fmt::format("{}: {} {}", document_.location, count, what));
        };
        add(left_out_.lines_or_points, "primitives of points or lines were left out");
        add(left_out_.without_positions, "primitives without POSITION were left out");
        add(left_out_.colours, "primitives have a COLOR_0, which is ignored");
        add(left_out_.infinite, "vertices have a coordinate that is no number or infinite");
        add(left_out_.without_weight,
            "vertices have no weight in WEIGHTS_0; their first joint moves them");
        if (triangles_ == 0)
            document_.warnings.push_back(document_.location +
                                         ": holds no triangle in its scene");
    }

    GltfDocument& document_;
    GltfScene scene_;
    GltfLeftOut left_out_;
    std::map<size_t, std::vector<size_t>> primitives_;  // of meshes that were read
    size_t vertices_ = 0, triangles_ = 0, corners_ = 0;
};

}  // namespace

GltfScene read_gltf(const std::string& path, const std::string& clip) {
    GltfDocument document = read_gltf_document(path);
    try {
        return Reader(document, clip).scene();
    } catch (const std::exception& error) {
        throw std::runtime_error(with_warnings(error.what(), document.warnings));
    }
}

}  // namespace render
