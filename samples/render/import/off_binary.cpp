// off_binary.cpp - counts, vertices of a fixed size, faces with their own count and colour.
#include "import/off_binary.hpp"

#include <cstring>

#include "files/text_scan.hpp"

namespace render {
namespace {

class BinaryOffReader {
public:
    BinaryOffReader(std::string_view body, const OffKeyword& keyword, const std::string& name)
        : rest_(body), name_(name) {
        if (keyword.has_normals) extra_words_ += 3;
        if (keyword.has_colours) extra_words_ += 4;
        if (keyword.has_texcoords) extra_words_ += 2;
    }

    Soup read() {
        const uint32_t vertices = word(), faces = word();
        word();  // the count of edges
        require(vertices, 3 + extra_words_, "vertices");
        for (uint32_t i = 0; i < vertices; ++i) read_vertex();
        require(faces, 2, "faces");
        for (uint32_t i = 0; i < faces; ++i) read_face(i);
        return std::move(soup_);
    }

private:
    void require(uint32_t count, size_t words, const std::string& what) const {
        if (count > rest_.size() / 4 / words)
            throw LoadError(name_ + ": promises " + std::to_string(count) + " " + what +
                            ", but has only " + std::to_string(rest_.size()) + " bytes left");
    }

    uint32_t word() {
        if (rest_.size() < 4) throw LoadError(name_ + ": ends before its last face");
        uint32_t value = 0;
        for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(rest_[i]);
        rest_.remove_prefix(4);
        return value;
    }

    float number() {
        const uint32_t bits = word();
        float value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }

    void read_vertex() {
        const float x = number(), y = number(), z = number();
        soup_.positions.emplace_back(x, y, z);
        rest_.remove_prefix(4 * extra_words_);
    }

    void read_face(uint32_t face) {
        const std::string of_face = " of face " + std::to_string(face);
        const uint32_t corners = word();
        require(corners, 1, "corners" + of_face);
        for (uint32_t i = 0; i < corners; ++i) soup_.corners.push_back({word(), {}, {}});
        soup_.ends.push_back(soup_.corners.size());
        const uint32_t colours = word();
        require(colours, 1, "colours" + of_face);
        rest_.remove_prefix(size_t{4} * colours);
    }

    std::string_view rest_;
    const std::string name_;
    size_t extra_words_ = 0;  // of a vertex
    Soup soup_;
};

}  // namespace

Soup read_off_binary(std::string_view body, const OffKeyword& keyword,
                     const std::string& name) {
    return BinaryOffReader(body, keyword, name).read();
}

}  // namespace render
