// aff_geometry.cpp - numbers -> corners -> vertices and triangles.
#include "import/bart/aff_geometry.hpp"

#include <array>
#include <cmath>
#include <map>

#include "model/polygon.hpp"

namespace render {

// What the triangles of a mesh refer to by number.
struct AffGeometry::Lists {
    std::vector<glm::vec3> vertices, normals;
    std::vector<glm::vec2> texcoords;
    bool has_texcoords = false;
    uint32_t material = 0;

    // By its numbers in the three lists.
    Corner corner(const std::array<size_t, 3>& numbers) const {
        return {vertices[numbers[0]], normals.empty() ? glm::vec3(0.0f) : normals[numbers[1]],
                has_texcoords ? texcoords[numbers[2]] : glm::vec2(0.0f)};
    }
};

uint32_t AffGeometry::add_vertex(const Corner& corner) {
    scene_.mesh.positions.push_back(corner.position);
    scene_.mesh.normals.push_back(corner.normal);
    scene_.mesh.texcoords.push_back(corner.texcoord);
    scene_.vertex_nodes.push_back(node);
    return static_cast<uint32_t>(scene_.mesh.positions.size()) - 1;
}

void AffGeometry::add_triangle(glm::uvec3 triangle, uint32_t material) {
    scene_.mesh.triangles.push_back(triangle);
    scene_.mesh.material_ids.push_back(material);
}

void AffGeometry::add_polygon(const std::vector<Corner>& corners, uint32_t material) {
    const auto first = static_cast<uint32_t>(scene_.mesh.positions.size());
    std::vector<glm::dvec3> points;
    for (const Corner& corner : corners) {
        points.emplace_back(corner.position);
        add_vertex(corner);
    }
    for (const glm::uvec3 t : triangulate(points)) add_triangle(first + t, material);
}

void AffGeometry::read_polygon() {
    read_polygon(false);
}
void AffGeometry::read_patch() {
    read_polygon(true);
}

void AffGeometry::read_polygon(bool has_normals) {
    std::vector<Corner> corners(tokens_.count("corners", has_normals ? 6 : 3));
    for (Corner& corner : corners) {
        corner.position = tokens_.vector("corner");
        if (has_normals) corner.normal = tokens_.vector("normal");
    }
    add_polygon(corners, materials_.plain());
}

void AffGeometry::read_textured_triangle() {
    read_textured(false);
}
void AffGeometry::read_textured_patch() {
    read_textured(true);
}

void AffGeometry::read_textured(bool has_normals) {
    const uint32_t material = materials_.textured(tokens_.word("the name of a texture"));
    std::vector<Corner> corners(3);
    for (Corner& corner : corners) {
        corner.position = tokens_.vector("corner");
        if (has_normals) corner.normal = tokens_.vector("normal");
        corner.texcoord = texcoord();
    }
    add_polygon(corners, material);
}

// BART's v is 0 at the top of a picture, ours at its bottom.
glm::vec2 AffGeometry::texcoord() {
    const double u = tokens_.number("u"), v = tokens_.number("v");
    return {u, 1.0 - v};
}

void AffGeometry::read_moving_triangle() {
    AffMorph morph = keys_.morph();
    const auto& key = morph.keys[0];
    morph.first_vertex = add_vertex({key[0], key[1]});
    add_vertex({key[2], key[3]});
    add_vertex({key[4], key[5]});
    add_triangle(morph.first_vertex + glm::uvec3(0, 1, 2), materials_.plain());
    scene_.morphs.push_back(std::move(morph));
}

void AffGeometry::read_sphere() {
    const glm::dvec3 centre = tokens_.vector("centre");
    add_shape(make_sphere(centre, tokens_.number("radius")));
}

void AffGeometry::read_cone() {
    const glm::dvec3 base = tokens_.vector("base");
    const double base_radius = tokens_.number("base radius");
    const glm::dvec3 apex = tokens_.vector("apex");
    add_shape(make_cone(base, base_radius, apex, tokens_.number("apex radius")));
}

void AffGeometry::add_shape(const Shape& shape) {
    const auto first = static_cast<uint32_t>(scene_.mesh.positions.size());
    const uint32_t material = materials_.plain();
    for (size_t i = 0; i < shape.positions.size(); ++i)
        add_vertex({shape.positions[i], shape.normals[i]});
    for (const glm::uvec3 t : shape.triangles) add_triangle(first + t, material);
}

void AffGeometry::read_mesh() {
    const Lists lists = read_lists();
    std::map<std::array<size_t, 3>, uint32_t> known;  // vertices, by their numbers as corners
    for (size_t i = 0, n = tokens_.count("triangles", 3); i < n; ++i) {
        std::array<std::array<size_t, 3>, 3> numbers{};
        for (auto& corner : numbers) corner[0] = index("vertex", lists.vertices.size());
        if (!lists.normals.empty())
            for (auto& corner : numbers) corner[1] = index("normal", lists.normals.size());
        if (lists.has_texcoords)
            for (auto& corner : numbers)
                corner[2] = index("texture coordinate", lists.texcoords.size());
        glm::uvec3 triangle;
        for (int k = 0; k < 3; ++k) {
            const auto [entry, is_new] = known.emplace(numbers[k], 0u);
            if (is_new) entry->second = add_vertex(lists.corner(numbers[k]));
            triangle[k] = entry->second;
        }
        add_triangle(triangle, lists.material);
    }
}

AffGeometry::Lists AffGeometry::read_lists() {
    Lists lists;
    lists.material = materials_.plain();
    tokens_.expect("vertices");
    lists.vertices = vectors("vertices");
    if (tokens_.peek() == "normals") tokens_.next(), lists.normals = vectors("normals");
    while (tokens_.peek() == "texturecoords") read_texcoords(lists);
    tokens_.expect("triangles");
    return lists;
}

// Of several lists the last one holds.
void AffGeometry::read_texcoords(Lists& lists) {
    tokens_.expect("texturecoords");
    const size_t count = tokens_.count("texture coordinates", 2);
    lists.has_texcoords = true;
    lists.material = materials_.textured(tokens_.word("the name of a texture"));
    lists.texcoords.clear();
    for (size_t i = 0; i < count; ++i) lists.texcoords.push_back(texcoord());
}

std::vector<glm::vec3> AffGeometry::vectors(const char* what) {
    std::vector<glm::vec3> result;
    for (size_t i = 0, n = tokens_.count(what, 3); i < n; ++i)
        result.push_back(tokens_.vector(what));
    return result;
}

size_t AffGeometry::index(const char* what, size_t count) {
    const double value = tokens_.number(what);
    if (!(value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value)))
        tokens_.fail(std::string("the index of a ") + what + " is " + std::to_string(value) +
                     ", but must be whole, and there are " + std::to_string(count));
    return static_cast<size_t>(value);
}

}  // namespace render
