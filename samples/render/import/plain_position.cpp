// plain_position.cpp - three tokens of a vertex -> text that std::istream reads back to the
// same floats, or a special position.
#include <cfloat>
#include <cmath>

#include "files/text_scan.hpp"
#include "import/plain_mesh.hpp"

namespace render {
bool is_special(double value) {
    const double magnitude = std::abs(value);
    return !(magnitude <= FLT_MAX) || (magnitude != 0.0 && magnitude < FLT_MIN);
}

void append_position(PlainMesh& plain, uint32_t index, const std::string_view (&tokens)[3],
                     const std::string& where) {
    glm::vec3 position;
    bool special = false;
    for (int i = 0; i < 3; ++i) {
        const auto value = parse_number(tokens[i]);
        if (!value)
            throw LoadError(where + ": a vertex needs 3 numbers, but coordinate " +
                            std::to_string(i) + " is '" + std::string(tokens[i]) + "'");
        position[i] = static_cast<float>(*value);
        special = special || is_special(*value);
    }
    if (special) plain.special_positions.emplace_back(index, position);
    for (int i = 0; i < 3; ++i) {
        plain.text += special ? std::string_view("0") : tokens[i];
        plain.text += i < 2 ? ' ' : '\n';
    }
}

}  // namespace render
