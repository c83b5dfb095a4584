// off_header.cpp - takes the letters off from the left.
#include "import/off_header.hpp"

#include <algorithm>

#include "files/text_scan.hpp"

namespace render {

OffKeyword read_off_keyword(std::string_view word, const std::string& name) {
    OffKeyword result;
    const size_t digits = word.find_last_not_of("0123456789") + 1;
    result.glued = word.substr(digits);
    std::string_view left = word.substr(0, digits);
    const auto take = [&](std::string_view letters) {
        const bool is_there = lower_case(left.substr(0, letters.size())) == letters;
        if (is_there) left.remove_prefix(letters.size());
        return is_there;
    };
    result.has_texcoords = take("st");
    result.has_colours = take("c");
    // A small n before capitals stands for any number of coordinates.
    const bool is_any = left == "nOFF" || left == "4nOFF";
    result.has_normals = !is_any && take("n");
    if (is_any || lower_case(left.substr(0, 1)) == "4")
        throw LoadError(name + ": starts with '" + std::string(word) +
                        "', whose points have not 3 coordinates; needs OFF");
    if (lower_case(left) != "off")
        throw LoadError(name + ": starts with '" + std::string(word) +
                        "', but needs OFF, possibly after ST, C and N in this order");
    return result;
}

}  // namespace render
