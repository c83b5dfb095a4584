// creases.cpp - walks around each vertex over OpenMesh's half-edges, from crease to crease.
#include "model/creases.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

namespace render {
namespace {

using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;
using HalfEdge = OpenMesh::SmartHalfedgeHandle;

constexpr uint32_t kNone = 0xffffffffu;

class CreaseCutter {
public:
    CreaseCutter(const Mesh& mesh, float degrees) : result_{mesh, {}} {
        for (uint32_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::vec3& p = mesh.positions[v];
            half_edges_.add_vertex({p.x, p.y, p.z});
            result_.source.push_back(v);
        }
        omerr().disable();  // it would print each triangle that it refuses
        for (const glm::uvec3& t : mesh.triangles) faces_.push_back(add_face(t));
        omerr().enable();
        half_edges_.request_edge_status();
        half_edges_.find_feature_edges(glm::radians(double{degrees}));
        is_taken_.resize(mesh.positions.size());
        vertices_.resize(half_edges_.n_halfedges(), kNone);
    }

    CreasedMesh cut() {
        for (size_t i = 0; i < faces_.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                uint32_t& corner = result_.mesh.triangles[i][k];
                corner = faces_[i].is_valid() ? vertex_at(i, corner) : new_vertex(corner);
            }
        return std::move(result_);
    }

private:
    OpenMesh::SmartFaceHandle add_face(const glm::uvec3& t) {
        if (t.x == t.y || t.y == t.z || t.z == t.x) return OpenMesh::SmartFaceHandle();
        const auto handle = [](uint32_t v) {
            return OpenMesh::VertexHandle(static_cast<int>(v));
        };
        return half_edges_.add_face(handle(t.x), handle(t.y), handle(t.z));
    }

    bool is_sharp(HalfEdge h) const {
        return h.edge().is_boundary() || half_edges_.status(h.edge()).feature();
    }

    // The first use of a vertex keeps its number.
    uint32_t new_vertex(uint32_t source) {
        if (!is_taken_[source]) {
            is_taken_[source] = true;
            return source;
        }
        Mesh& mesh = result_.mesh;
        mesh.positions.push_back(glm::vec3(mesh.positions[source]));
        if (!mesh.normals.empty()) mesh.normals.push_back(glm::vec3(mesh.normals[source]));
        if (!mesh.texcoords.empty())
            mesh.texcoords.push_back(glm::vec2(mesh.texcoords[source]));
        result_.source.push_back(source);
        return static_cast<uint32_t>(result_.source.size() - 1);
    }

    // The vertex of a face's corner: that of all half-edges to `source` between two creases.
    uint32_t vertex_at(size_t face, uint32_t source) {
        HalfEdge h = faces_[face].halfedge();
        while (static_cast<uint32_t>(h.to().idx()) != source) h = h.next();
        if (vertices_[index(h)] == kNone) {
            const uint32_t vertex = new_vertex(source);
            const HalfEdge start = h;
            while (!is_sharp(h) && h.opp().prev() != start) h = h.opp().prev();
            for (; vertices_[index(h)] == kNone; h = h.next().opp()) {
                vertices_[index(h)] = vertex;
                if (is_sharp(h.next())) break;
            }
            h = start;
        }
        return vertices_[index(h)];
    }

    static size_t index(HalfEdge h) { return static_cast<size_t>(h.idx()); }

    HalfEdges half_edges_;
    std::vector<OpenMesh::SmartFaceHandle> faces_;  // of each triangle; invalid: refused
    std::vector<uint32_t> vertices_;                // that each half-edge points to, once known
    std::vector<bool> is_taken_;
    CreasedMesh result_;
};

}  // namespace

CreasedMesh split_at_creases(const Mesh& mesh, float degrees) {
    return CreaseCutter(mesh, degrees).cut();
}

}  // namespace render
