// mesh_file.cpp - chooses the reader, and joins polygons and materials to a model.
#include "import/mesh_file.hpp"

#include <algorithm>
#include <cfloat>
#include <map>
#include <set>

#include "files/asset.hpp"
#include "files/references.hpp"
#include "files/text_scan.hpp"
#include "import/mesh_formats.hpp"
#include "import/mtl_file.hpp"
#include "model/warnings.hpp"

namespace render {
namespace {

// For a file without a known extension.
std::string guess_format(const std::string& bytes, const std::string& location) {
    std::string_view text = without_mark(bytes);
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

void parse(const Asset& asset, ParsedMesh& parsed) {
    const std::string format = format_of(asset);
    const auto read = format == "stl"   ? read_stl
                      : format == "ply" ? read_ply
                      : format == "off" ? read_off
                                        : read_obj;
    try {
        read(asset.bytes, asset.location, parsed);
    } catch (const LoadError& error) {
        throw LoadError(with_warnings(error.what(), parsed.warnings));
    }
}

std::map<std::string, Material> read_material_files(const ParsedMesh& parsed,
                                                    const std::string& location,
                                                    std::vector<std::string>& warnings) {
    std::map<std::string, Material> materials;
    std::set<std::string> known;
    for (const std::string& line : parsed.material_files)
        for (const std::string& path : find_references(location, line, ".mtl")) try {
                if (!known.insert(path).second) continue;
                const Asset asset = read_asset(path);
                require_text(asset.bytes, asset.location);
                read_mtl(asset.bytes, asset.location, materials, warnings);
            } catch (const LoadError& error) {
                warnings.push_back(location + ": mtllib: " + error.what());
            }
    return materials;
}

Material default_material() {
    Material material;
    material.name = "default";
    return material;
}

// The materials that the file names, in the order of their first use; faces without one get the
// default material behind them.
void add_materials(ParsedMesh& parsed, const std::string& location, Model& model) {
    const auto known = read_material_files(parsed, location, model.warnings);
    for (const std::string& name : parsed.material_names) {
        const auto found = known.find(name);
        if (found == known.end())
            model.warnings.push_back(location + ": material '" + name +
                                     "' is in no material file; the default is used");
        model.materials.push_back(found == known.end() ? default_material() : found->second);
        model.materials.back().name = name;
    }
    const auto last = static_cast<uint32_t>(model.materials.size());
    std::vector<uint32_t>& of_faces = parsed.soup.materials;
    const bool uses_default =
        of_faces.empty() || std::count(of_faces.begin(), of_faces.end(), kNoMaterial) > 0;
    std::replace(of_faces.begin(), of_faces.end(), kNoMaterial, last);
    if (uses_default) model.materials.push_back(default_material());
    if (!parsed.texture.empty())
        model.materials[0].texture = find_reference(location, parsed.texture);
}

// Materials may want other texture coordinates than their faces have; corners that share a vertex
// then differ, and become two.
void map_texcoords(const std::vector<Material>& materials, Soup& soup) {
    if (!soup.corners_have_texcoords || soup.materials.empty()) return;
    size_t corner = 0;
    for (size_t i = 0; i < soup.ends.size(); ++i) {
        const Material& m = materials[soup.materials[i]];
        const bool is_mapped =
            m.texture_scale != glm::vec2(1.0f) || m.texture_shift != glm::vec2(0.0f);
        for (; corner < soup.ends[i]; ++corner) {
            glm::vec2& uv = soup.corners[corner].texcoord;
            if (is_mapped) uv = m.texture_scale * uv + m.texture_shift;
        }
    }
}

// Their triangles are kept, but no ray hits them.
void warn_of_infinite(const Soup& soup, const std::string& location,
                      std::vector<std::string>& warnings) {
    size_t count = 0;
    for (const glm::dvec3& p : soup.positions)
        count += !(glm::all(glm::lessThanEqual(glm::abs(p), glm::dvec3(FLT_MAX))));
    if (count > 0)
        warnings.push_back(location + ": " + std::to_string(count) +
                           " vertices have a coordinate that is no number or beyond floats");
}

}  // namespace

NumberedModel load_numbered_mesh(const std::string& path) {
    const Asset asset = read_asset(path);
    ParsedMesh parsed;
    parse(asset, parsed);
    NumberedModel result;
    result.model.warnings = parsed.warnings;
    add_materials(parsed, asset.location, result.model);
    map_texcoords(result.model.materials, parsed.soup);
    const Soup& soup = parsed.soup;
    warn_of_infinite(soup, asset.location, result.model.warnings);
    if (soup.positions.empty())
        throw LoadError(
            with_warnings(asset.location + ": holds no vertex", result.model.warnings));
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
