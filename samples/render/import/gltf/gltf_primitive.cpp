// gltf_primitive.cpp - a primitive's accessors, which must be of one length and of the right kind.
#include "import/gltf/gltf_primitive.hpp"

#include <fmt/format.h>

#include <cfloat>

#include "import/gltf/gltf_material.hpp"

namespace render {
namespace {

using Attributes = std::map<std::string, int>;

class PrimitiveReader {
public:
    PrimitiveReader(const GltfDocument& document, const tinygltf::Primitive& primitive,
                    const std::string& where)
        : document_(document),
          accessors_(document),
          primitive_(primitive),
          where_(where),
          vertices_(accessors_.count(primitive.attributes.at("POSITION"))) {}

    GltfPrimitive read(GltfLeftOut& left_out) const {
        GltfPrimitive p;
        p.positions = vectors(primitive_.attributes, "POSITION", "attributes");
        for (const glm::vec3& v : p.positions)
            left_out.infinite +=
                !(glm::all(glm::lessThanEqual(glm::abs(v), glm::vec3(FLT_MAX))));
        p.normals = vectors(primitive_.attributes, "NORMAL", "attributes");
        p.texcoords = texcoords();
        p.triangles = triangles();
        for (size_t i = 0; i < primitive_.targets.size(); ++i) {
            const std::string place = fmt::format("targets[{}]", i);
            p.targets.push_back({vectors(primitive_.targets[i], "POSITION", place),
                                 vectors(primitive_.targets[i], "NORMAL", place)});
        }
        read_joints(p, left_out);
        p.material = static_cast<uint32_t>(primitive_.material >= 0
                                               ? static_cast<size_t>(primitive_.material)
                                               : document_.model.materials.size());
        return p;
    }

private:
    std::string place(const std::string& member, const std::string& name) const {
        return fmt::format("{}.{}.{}", where_, member, name);
    }

    // -1: there is none; else an accessor with an element for each vertex.
    int accessor(const Attributes& attributes, const std::string& name,
                 const std::string& member) const {
        const auto found = attributes.find(name);
        if (found == attributes.end()) return -1;
        if (const size_t count = accessors_.count(found->second); count != vertices_)
            accessors_.fail(
                place(member, name),
                fmt::format("accessors[{}] has {} elements, must have {} as POSITION",
                            found->second, count, vertices_));
        return found->second;
    }

    std::vector<glm::vec3> vectors(const Attributes& attributes, const char* name,
                                   const std::string& member) const {
        const int index = accessor(attributes, name, member);
        if (index < 0) return {};
        const auto numbers = accessors_.floats(index, TINYGLTF_TYPE_VEC3, GltfNumbers::floats,
                                               place(member, name));
        std::vector<glm::vec3> vectors(vertices_);
        for (size_t i = 0; i < vertices_; ++i)
            vectors[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
        return vectors;
    }

    // glTF's begin at the top of the picture, the renderer's at its bottom.
    std::vector<glm::vec2> texcoords() const {
        const std::string name = gltf_texcoord_name(document_.model, primitive_.material);
        const int index = accessor(primitive_.attributes, name, "attributes");
        if (index < 0) return {};
        const auto numbers =
            accessors_.floats(index, TINYGLTF_TYPE_VEC2, GltfNumbers::floats_or_normalized,
                              place("attributes", name));
        std::vector<glm::vec2> texcoords(vertices_);
        for (size_t i = 0; i < vertices_; ++i)
            texcoords[i] = {numbers[2 * i], 1.0f - numbers[2 * i + 1]};
        return texcoords;
    }

    std::vector<uint32_t> corners() const {
        const std::string where = where_ + ".indices";
        std::vector<uint32_t> corners;
        if (primitive_.indices < 0)
            for (size_t i = 0; i < vertices_; ++i) corners.push_back(static_cast<uint32_t>(i));
        else
            corners = accessors_.integers(primitive_.indices, TINYGLTF_TYPE_SCALAR,
                                          GltfNumbers::unsigned_integers, where);
        for (size_t i = 0; i < corners.size(); ++i)
            if (corners[i] >= vertices_)
                accessors_.fail(where, fmt::format("element {} is {}, must be below {}, the "
                                                   "vertices of POSITION",
                                                   i, corners[i], vertices_));
        return corners;
    }

    std::vector<glm::uvec3> triangles() const {
        const std::vector<uint32_t> c = corners();
        std::vector<glm::uvec3> triangles;
        const bool is_list = primitive_.mode == TINYGLTF_MODE_TRIANGLES;
        if (is_list ? c.size() % 3 != 0 : c.size() < 3)
            accessors_.fail(where_, fmt::format("has {} corners, must have {}", c.size(),
                                                is_list ? "a multiple of 3" : "at least 3"));
        for (size_t i = 0; i + 2 < c.size(); i += is_list ? 3 : 1)
            if (primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN)
                triangles.emplace_back(c[i + 1], c[i + 2], c[0]);
            else if (is_list || i % 2 == 0)
                triangles.emplace_back(c[i], c[i + 1], c[i + 2]);
            else
                triangles.emplace_back(c[i], c[i + 2], c[i + 1]);
        return triangles;
    }

    // Up to two sets of four joints.
    void read_joints(GltfPrimitive& p, GltfLeftOut& left_out) const {
        std::vector<std::vector<uint32_t>> joints;
        std::vector<std::vector<float>> weights;
        for (const char* set : {"0", "1"}) {
            const std::string of_joints = std::string("JOINTS_") + set,
                              of_weights = std::string("WEIGHTS_") + set;
            const int j = accessor(primitive_.attributes, of_joints, "attributes");
            const int w = accessor(primitive_.attributes, of_weights, "attributes");
            if ((j < 0) != (w < 0))
                accessors_.fail(place("attributes", j < 0 ? of_joints : of_weights),
                                fmt::format("is missing, must be there beside {}",
                                            j < 0 ? of_weights : of_joints));
            if (j < 0) break;
            joints.push_back(accessors_.integers(j, TINYGLTF_TYPE_VEC4,
                                                 GltfNumbers::unsigned_bytes_or_shorts,
                                                 place("attributes", of_joints)));
            weights.push_back(accessors_.floats(w, TINYGLTF_TYPE_VEC4,
                                                GltfNumbers::floats_or_normalized,
                                                place("attributes", of_weights)));
        }
        p.influences = 4 * joints.size();
        for (size_t vertex = 0; p.influences > 0 && vertex < vertices_; ++vertex) {
            for (size_t set = 0; set < joints.size(); ++set)
                for (size_t i = 4 * vertex; i < 4 * vertex + 4; ++i) {
                    p.joints.push_back(joints[set][i]);
                    p.joint_weights.push_back(weights[set][i]);
                }
            left_out.without_weight += !normalize(p, vertex);
        }
    }

    // The sum is 1 but for rounding, above all of normalized bytes. Without any, the first joint has
    // all of it.
    static bool normalize(GltfPrimitive& p, size_t vertex) {
        float* weights = &p.joint_weights[vertex * p.influences];
        double sum = 0.0;
        for (size_t i = 0; i < p.influences; ++i) sum += weights[i];
        if (!(sum > 0.0)) {
            std::fill(weights, weights + p.influences, 0.0f);
            weights[0] = 1.0f;
            return false;
        }
        for (size_t i = 0; i < p.influences; ++i)
            weights[i] = static_cast<float>(weights[i] / sum);
        return true;
    }

    const GltfDocument& document_;
    GltfAccessors accessors_;
    const tinygltf::Primitive& primitive_;
    const std::string& where_;
    size_t vertices_;
};

}  // namespace

std::optional<GltfPrimitive> read_primitive(const GltfDocument& document,
                                            const tinygltf::Primitive& primitive,
                                            const std::string& where, GltfLeftOut& left_out) {
    const bool has_positions = primitive.attributes.count("POSITION") > 0;
    const bool is_surface = primitive.mode >= TINYGLTF_MODE_TRIANGLES;
    left_out.lines_or_points += !is_surface;
    left_out.without_positions += is_surface && !has_positions;
    left_out.colours += primitive.attributes.count("COLOR_0");
    if (!is_surface || !has_positions) return std::nullopt;
    return PrimitiveReader(document, primitive, where).read(left_out);
}

}  // namespace render
