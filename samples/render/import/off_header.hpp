// off_header.hpp - the first word of an OFF file: [ST][C][N][4][n]OFF, in any case.
#pragma once

#include <string>
#include <string_view>

namespace render {

struct OffKeyword {
    bool has_texcoords = false, has_colours = false, has_normals = false;
    std::string_view glued;  // digits that follow without a blank: the first count
    bool has_attributes() const { return has_texcoords || has_colours || has_normals; }
};

// Throws LoadError for any other word, and for points that have not three coordinates.
OffKeyword read_off_keyword(std::string_view word, const std::string& name);

}  // namespace render
