// soup_importer.cpp - calls of OpenMesh's readers -> soup. Faces with an index out of range or
// with fewer than three corners are counted and left out.
#include "import/soup_importer.hpp"

#include <algorithm>

namespace render {
namespace {

glm::vec3 to_glm(const OpenMesh::Vec3f& v) {
    return {v[0], v[1], v[2]};
}

}  // namespace

bool SoupImporter::is_in_range(Vertex vertex) const {
    return vertex.idx() >= 0 && static_cast<size_t>(vertex.idx()) < soup_.positions.size();
}

SoupImporter::Vertex SoupImporter::add_vertex(const Vec3f& point) {
    soup_.positions.push_back(to_glm(point));
    return Vertex(static_cast<int>(soup_.positions.size()) - 1);
}

void SoupImporter::set_point(Vertex vertex, const Vec3f& point) {
    if (is_in_range(vertex)) soup_.positions[static_cast<size_t>(vertex.idx())] = to_glm(point);
}

Corner& SoupImporter::pending(Vertex vertex) {
    const auto index = static_cast<uint32_t>(vertex.idx());
    if (pending_.empty() || pending_.back().vertex != index)
        pending_.push_back({index, {}, {}});
    return pending_.back();
}

void SoupImporter::set_normal(Vertex vertex, const Vec3f& normal) {
    if (attributes_ == Attributes::per_corner) {
        pending(vertex).normal = to_glm(normal);
        soup_.corners_have_normals = true;
    } else if (is_in_range(vertex)) {
        soup_.normals.resize(soup_.positions.size(), glm::vec3(0.0f));
        soup_.normals[static_cast<size_t>(vertex.idx())] = to_glm(normal);
    }
}

void SoupImporter::set_texcoord(Vertex vertex, const Vec2f& texcoord) {
    const glm::vec2 uv(texcoord[0], texcoord[1]);
    if (attributes_ == Attributes::per_corner) {
        pending(vertex).texcoord = uv;
        soup_.corners_have_texcoords = true;
    } else if (is_in_range(vertex)) {
        soup_.texcoords.resize(soup_.positions.size(), glm::vec2(0.0f));
        soup_.texcoords[static_cast<size_t>(vertex.idx())] = uv;
    }
}

Corner SoupImporter::corner_of(Vertex vertex) const {
    const auto index = static_cast<uint32_t>(vertex.idx());
    const auto found = std::find_if(pending_.begin(), pending_.end(),
                                    [&](const Corner& c) { return c.vertex == index; });
    return found == pending_.end() ? Corner{index, {}, {}} : *found;
}

SoupImporter::Face SoupImporter::add_face(const VHandles& vertices) {
    ++offered_;
    bool is_good = vertices.size() >= 3;
    if (!is_good) ++too_short_;
    if (!std::all_of(vertices.begin(), vertices.end(),
                     [&](Vertex v) { return is_in_range(v); })) {
        if (is_good) ++out_of_range_;
        is_good = false;
    }
    if (is_good) {
        for (const Vertex vertex : vertices) soup_.corners.push_back(corner_of(vertex));
        soup_.ends.push_back(soup_.corners.size());
    }
    pending_.clear();
    return is_good ? Face(static_cast<int>(soup_.ends.size()) - 1) : Face();
}

}  // namespace render
