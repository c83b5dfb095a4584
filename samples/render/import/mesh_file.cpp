// mesh_file.cpp - bytes -> plain form -> OpenMesh -> soup -> model, checked against what the
// file promised. See plain_mesh.hpp for why OpenMesh is not given the files as they are.
#include "import/mesh_file.hpp"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <algorithm>
#include <map>
#include <sstream>

#include "files/asset.hpp"
#include "files/text_scan.hpp"
#include "import/mtl_file.hpp"
#include "import/plain_mesh.hpp"
#include "import/soup_importer.hpp"
#include "import/stl_file.hpp"

namespace render {
namespace {

namespace io = OpenMesh::IO;

// OpenMesh writes to stderr; a loader reports by what it returns.
class SilencedOpenMesh {
public:
    SilencedOpenMesh() : was_enabled_(omerr().is_enabled()) { omerr().disable(); }
    ~SilencedOpenMesh() {
        if (was_enabled_) omerr().enable();
    }

private:
    bool was_enabled_;
};

void check_text(const std::string& bytes, const std::string& location) {
    const bool has_mark =
        bytes.compare(0, 2, "\xfe\xff") == 0 || bytes.compare(0, 2, "\xff\xfe") == 0;
    if (has_mark || bytes.find('\0') != std::string::npos)
        throw LoadError(location +
                        ": is not text of single bytes (UTF-16?); needs ASCII or UTF-8");
}

// For a file without a known extension.
std::string guess_format(const std::string& bytes, const std::string& location) {
    std::string_view text = bytes;
    const std::string word = lower_case(take_token(text));
    if (word == "ply" || word == "off") return word;
    if (word == "solid") return "stl";
    throw LoadError(location + ": is neither OBJ, PLY, OFF nor STL by its name or first word");
}

std::string format_of(const Asset& asset) {
    const std::string extension = inner_extension(asset.location);
    for (const char* known : {"obj", "ply", "off", "stl"})
        if (extension == known) return extension;
    return guess_format(asset.bytes, asset.location);
}

PlainMesh plain_mesh(const std::string& format, const Asset& asset) {
    if (format == "ply") return plain_ply(asset.bytes, asset.location);
    check_text(asset.bytes, asset.location);
    return format == "off" ? plain_off(asset.bytes, asset.location)
                           : plain_obj(asset.bytes, asset.location);
}

void check_count(const char* what, size_t actual, size_t promised,
                 const std::string& location) {
    if (actual != promised)
        throw LoadError(location + ": the file promises " + std::to_string(promised) + " " +
                        what + ", but " + std::to_string(actual) + " were read");
}

void warn_of_left_out(const SoupImporter& importer, const std::string& location,
                      std::vector<std::string>& warnings) {
    const auto warn = [&](size_t count, const char* what) {
        if (count > 0) warnings.push_back(location + ": " + std::to_string(count) + " " + what);
    };
    warn(importer.faces_out_of_range(), "faces with an index out of range were left out");
    warn(importer.faces_too_short(), "faces with fewer than 3 corners were left out");
}

Soup read_through_openmesh(PlainMesh& plain, const std::string& location) {
    using Attributes = SoupImporter::Attributes;
    SoupImporter importer(plain.format == "obj" ? Attributes::per_corner
                                                : Attributes::per_vertex);
    io::Options options;
    if (plain.has_normals) options += io::Options::VertexNormal;
    if (plain.has_texcoords) options += io::Options::VertexTexCoord;
    std::istringstream stream(std::move(plain.text));
    const SilencedOpenMesh silence;
    if (!io::IOManager().read(stream, plain.format, importer, options))
        throw LoadError(location + ": OpenMesh cannot read it as " + plain.format);
    check_count("vertices", importer.n_vertices(), plain.vertices, location);
    check_count("faces", importer.offered_faces(), plain.faces, location);
    for (const auto& [index, position] : plain.special_positions)
        importer.set_point(OpenMesh::VertexHandle(static_cast<int>(index)),
                           {position.x, position.y, position.z});
    warn_of_left_out(importer, location, plain.warnings);
    return importer.take_soup();
}

std::map<std::string, Material> read_material_files(const PlainMesh& plain,
                                                    const std::string& location,
                                                    std::vector<std::string>& warnings) {
    std::map<std::string, Material> materials;
    for (const std::string& file : plain.material_files) try {
            const Asset asset = read_asset(sibling_path(location, file));
            read_mtl(asset.bytes, asset.location, materials, warnings);
        } catch (const LoadError& error) {
            warnings.push_back(error.what());
        }
    return materials;
}

Material default_material() {
    Material material;
    material.name = "default";
    return material;
}

// The materials that the faces use, in the order of their first use; faces without one get the
// default material behind them.
void add_materials(const PlainMesh& plain, const std::string& location, Model& model,
                   Soup& soup) {
    const auto known = read_material_files(plain, location, model.warnings);
    for (const std::string& name : plain.material_names) {
        const auto found = known.find(name);
        if (found == known.end())
            model.warnings.push_back(location + ": material '" + name +
                                     "' is in no material file; the default is used");
        model.materials.push_back(found == known.end() ? default_material() : found->second);
        model.materials.back().name = name;
    }
    soup.materials = plain.face_materials;
    const auto last = static_cast<uint32_t>(model.materials.size());
    bool uses_default = soup.materials.empty();
    for (uint32_t& material : soup.materials)
        if (material == kNoMaterial) material = last, uses_default = true;
    if (uses_default) model.materials.push_back(default_material());
    if (!plain.texture.empty())
        model.materials[0].texture = sibling_path(location, plain.texture);
}

Soup read_soup(const Asset& asset, Model& model) {
    const std::string format = format_of(asset);
    if (format == "stl") {
        model.materials.push_back(default_material());
        return read_stl(asset.bytes, asset.location);
    }
    PlainMesh plain = plain_mesh(format, asset);
    Soup soup = read_through_openmesh(plain, asset.location);
    model.warnings = plain.warnings;
    add_materials(plain, asset.location, model, soup);
    return soup;
}

}  // namespace

NumberedModel load_numbered_mesh(const std::string& path) {
    const Asset asset = read_asset(path);
    NumberedModel result;
    const Soup soup = read_soup(asset, result.model);
    if (soup.positions.empty()) throw LoadError(asset.location + ": holds no vertex");
    if (soup.ends.empty())
        result.model.warnings.push_back(asset.location + ": holds no face, only " +
                                        std::to_string(soup.positions.size()) + " vertices");
    IndexedMesh indexed = build_mesh(soup);
    result.model.mesh = std::move(indexed.mesh);
    result.source = std::move(indexed.source);
    result.file_vertices = soup.positions.size();
    return result;
}

Model load_mesh(const std::string& path) {
    return load_numbered_mesh(path).model;
}

}  // namespace render
