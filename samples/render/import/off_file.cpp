// off_file.cpp - words -> polygons. Lines count only at their ends: what is left of a face's line
// is a colour.
#include "import/mesh_formats.hpp"

#include <algorithm>

#include "files/text_scan.hpp"

namespace render {
namespace {

class OffReader {
public:
    OffReader(const std::string& bytes, const std::string& name)
        : bytes_(bytes.size()), rest_(without_mark(bytes)), name_(name) {}

    ParsedMesh read() {
        read_header();
        parsed_.soup.positions.reserve(vertices_);
        parsed_.soup.ends.reserve(faces_);
        for (size_t i = 0; i < vertices_; ++i) read_vertex(i);
        for (size_t i = 0; i < faces_; ++i) read_face(i);
        drop_bad_polygons(parsed_.soup, name_, parsed_.warnings);
        return std::move(parsed_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw LoadError(name_ + ": " + what);
    }

    // The next word that is in no comment; a comment goes to the end of its line.
    std::string_view take_word() {
        for (;;) {
            const std::string_view word = take_token(rest_);
            const size_t hash = word.find('#');
            if (hash == std::string_view::npos) return word;
            rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size()));
            if (hash > 0) return word.substr(0, hash);
        }
    }

    // The keyword may be absent: then the file starts with its counts.
    void read_header() {
        const std::string_view start = rest_;
        const std::string_view keyword = take_word();
        if (parse_integer(keyword))
            rest_ = start;
        else
            read_keyword(keyword);
        vertices_ = read_count("vertices");
        faces_ = read_count("faces");
        take_line(rest_);  // the count of edges, which some writers leave out
        // A vertex takes 6 characters ("0 0 0" and a line end), a face 2 ("0" and a line end).
        const size_t possible = (bytes_ + 1) / 2;
        if (vertices_ > possible / 3 || faces_ > possible || 3 * vertices_ + faces_ > possible)
            fail("the header promises " + std::to_string(vertices_) + " vertices and " +
                 std::to_string(faces_) + " faces, which " + std::to_string(bytes_) +
                 " bytes cannot hold");
    }

    void read_keyword(std::string_view keyword) {
        const bool is_off = keyword.size() >= 3 && keyword.substr(keyword.size() - 3) == "OFF";
        const std::string prefix(is_off ? keyword.substr(0, keyword.size() - 3) : keyword);
        size_t at = 0;
        if (prefix.compare(at, 2, "ST") == 0) at += 2, extra_words_ += 2;
        if (prefix.compare(at, 1, "C") == 0) at += 1, has_colours_ = true;
        if (prefix.compare(at, 1, "N") == 0) at += 1, extra_words_ += 3;
        if (!is_off || at != prefix.size())
            fail("starts with '" + std::string(keyword) +
                 "', but needs OFF, possibly after ST, C and N in this order");
        if (at > 0)
            parsed_.warnings.push_back(name_ + ": only the positions of " +
                                       std::string(keyword) + " are used");
    }

    size_t read_count(const char* what) {
        const std::string_view word = take_word();
        const auto count = parse_integer(word);
        if (!count || *count < 0)
            fail(std::string("the header needs a number of ") + what + ", but has '" +
                 std::string(word) + "'");
        return static_cast<size_t>(*count);
    }

    void read_vertex(size_t index) {
        glm::dvec3 position;
        for (int i = 0; i < 3; ++i) {
            const std::string_view word = take_word();
            if (word.empty())
                fail("ends after " + std::to_string(index) + " of " +
                     std::to_string(vertices_) + " vertices");
            const auto value = parse_number(word);
            if (!value)
                fail("vertex " + std::to_string(index) + ": needs 3 numbers, but coordinate " +
                     std::to_string(i) + " is '" + std::string(word) + "'");
            position[i] = *value;
        }
        parsed_.soup.positions.emplace_back(position);
        if (has_colours_)
            take_line(rest_);  // their number is not fixed
        else
            for (int i = 0; i < extra_words_; ++i) take_word();
    }

    void read_face(size_t face) {
        Soup& soup = parsed_.soup;
        const auto corners = parse_integer(take_word());
        for (long long i = 0; corners && i < *corners; ++i) {
            const std::string_view word = take_word();
            const auto index = parse_integer(word);
            if (!index) fail_at_face(face, word);
            const bool fits = *index >= 0 && *index < kNoVertex;
            soup.corners.push_back({fits ? static_cast<uint32_t>(*index) : kNoVertex, {}, {}});
        }
        if (!corners || *corners < 0) fail_at_face(face, "");
        soup.ends.push_back(soup.corners.size());
        take_line(rest_);
    }

    [[noreturn]] void fail_at_face(size_t face, std::string_view word) const {
        if (trimmed(rest_).empty() && word.empty())
            fail("ends after " + std::to_string(face) + " of " + std::to_string(faces_) +
                 " faces");
        fail("face " + std::to_string(face) +
             " needs its number of corners and as many indices, but has '" + std::string(word) +
             "'");
    }

    const size_t bytes_;
    std::string_view rest_;
    const std::string name_;
    size_t vertices_ = 0, faces_ = 0;
    int extra_words_ = 0;
    bool has_colours_ = false;
    ParsedMesh parsed_;
};

}  // namespace

ParsedMesh read_off(const std::string& bytes, const std::string& name) {
    return OffReader(bytes, name).read();
}

}  // namespace render
