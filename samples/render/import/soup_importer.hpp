// soup_importer.hpp - what OpenMesh's readers fill instead of a half-edge mesh. A half-edge
// mesh duplicates non-manifold vertices (the Stanford dragon's res4 gains 64 % of them),
// refuses non-manifold faces and adds some quads twice; a soup takes each face once, as it
// stands.
#pragma once

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

#include "import/soup.hpp"

namespace render {

class SoupImporter : public OpenMesh::IO::BaseImporter {
public:
    // The OBJ reader names normals and texture coordinates corner by corner before it adds the
    // face, the others once per vertex.
    enum class Attributes { per_vertex, per_corner };
    explicit SoupImporter(Attributes attributes) : attributes_(attributes) {}

    const Soup& soup() const { return soup_; }
    Soup take_soup() { return std::move(soup_); }
    size_t offered_faces() const { return offered_; }
    size_t faces_out_of_range() const { return out_of_range_; }
    size_t faces_too_short() const { return too_short_; }

    using Vec2f = OpenMesh::Vec2f;
    using Vec3f = OpenMesh::Vec3f;
    using Vec3d = OpenMesh::Vec3d;
    using Vertex = OpenMesh::VertexHandle;
    using Face = OpenMesh::FaceHandle;
    using Edge = OpenMesh::EdgeHandle;
    using Halfedge = OpenMesh::HalfedgeHandle;
    using Status = OpenMesh::Attributes::StatusInfo;

    Vertex add_vertex(const Vec3f& point) override;
    Vertex add_vertex() override { return add_vertex(Vec3f(0.0f)); }
    void set_point(Vertex vertex, const Vec3f& point) override;
    Face add_face(const VHandles& vertices) override;
    void set_normal(Vertex vertex, const Vec3f& normal) override;
    void set_normal(Vertex v, const Vec3d& n) override { set_normal(v, Vec3f(n)); }
    void set_texcoord(Vertex vertex, const Vec2f& texcoord) override;
    size_t n_vertices() const override { return soup_.positions.size(); }
    size_t n_faces() const override { return soup_.ends.size(); }

    // The rest of the interface carries what a renderer does not need.
    size_t n_edges() const override { return 0; }
    Halfedge add_edge(Vertex, Vertex) override { return Halfedge(); }
    Face add_face(Halfedge) override { return Face(); }
    void add_face_texcoords(Face, Vertex, const std::vector<Vec2f>&) override {}
    void add_face_texcoords(Face, Vertex, const std::vector<Vec3f>&) override {}
    void set_face_texindex(Face, int) override {}
    void set_halfedge(Vertex, Halfedge) override {}
    void set_color(Vertex, const OpenMesh::Vec3uc&) override {}
    void set_color(Vertex, const OpenMesh::Vec4uc&) override {}
    void set_color(Vertex, const Vec3f&) override {}
    void set_color(Vertex, const OpenMesh::Vec4f&) override {}
    void set_status(Vertex, const Status&) override {}
    void set_next(Halfedge, Halfedge) override {}
    void set_face(Halfedge, Face) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(Halfedge, const Vec2f&) override {}
    void set_texcoord(Vertex, const Vec3f&) override {}
    void set_texcoord(Halfedge, const Vec3f&) override {}
    void set_status(Halfedge, const Status&) override {}
    void set_color(Edge, const OpenMesh::Vec3uc&) override {}
    void set_color(Edge, const OpenMesh::Vec4uc&) override {}
    void set_color(Edge, const Vec3f&) override {}
    void set_color(Edge, const OpenMesh::Vec4f&) override {}
    void set_status(Edge, const Status&) override {}
    void set_normal(Face, const Vec3f&) override {}
    void set_normal(Face, const Vec3d&) override {}
    void set_color(Face, const OpenMesh::Vec3uc&) override {}
    void set_color(Face, const OpenMesh::Vec4uc&) override {}
    void set_color(Face, const Vec3f&) override {}
    void set_color(Face, const OpenMesh::Vec4f&) override {}
    void set_status(Face, const Status&) override {}
    void add_texture_information(int, std::string) override {}

private:
    Corner& pending(Vertex vertex);
    Corner corner_of(Vertex vertex) const;
    bool is_in_range(Vertex vertex) const;

    Attributes attributes_;
    Soup soup_;
    std::vector<Corner> pending_;  // corners named since the last face
    size_t offered_ = 0;
    size_t out_of_range_ = 0;
    size_t too_short_ = 0;
};

}  // namespace render
