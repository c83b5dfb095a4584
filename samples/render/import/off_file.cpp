// off_file.cpp - words -> polygons. Lines count only at their ends: what is left of a face's line
// is a colour.
#include "import/mesh_formats.hpp"

#include <algorithm>

#include "files/text_scan.hpp"
#include "import/off_binary.hpp"

namespace render {
namespace {

class OffReader {
public:
    OffReader(const std::string& bytes, const std::string& name, ParsedMesh& parsed)
        : bytes_(bytes.size()), rest_(without_mark(bytes)), name_(name), parsed_(parsed) {}

    void read() {
        require_text(rest_.substr(0, 3), name_);
        if (read_header()) {
            parsed_.soup = read_off_binary(rest_, keyword_, name_);
        } else {
            require_text(rest_, name_);
            read_text();
        }
        drop_bad_polygons(parsed_.soup, name_, parsed_.warnings);
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

    // The words of the next line that has any.
    static std::vector<std::string_view> take_words(std::string_view& text) {
        std::vector<std::string_view> words;
        while (words.empty() && !text.empty()) {
            std::string_view line = take_line(text);
            line = line.substr(0, line.find('#'));
            for (auto word = take_token(line); !word.empty(); word = take_token(line))
                words.push_back(word);
        }
        return words;
    }

    // Is the rest binary? The keyword may be absent: then the file starts with its counts.
    bool read_header() {
        const std::string_view start = rest_;
        const std::string_view word = take_word();
        if (parse_integer(word)) {
            rest_ = start;
            return false;
        }
        keyword_ = read_off_keyword(word, name_);
        if (!keyword_.glued.empty())  // its digits are the end of the word
            rest_ = {keyword_.glued.data(),
                     static_cast<size_t>(start.data() + start.size() - keyword_.glued.data())};
        if (keyword_.has_attributes())
            parsed_.warnings.push_back(name_ + ": only the positions of " + std::string(word) +
                                       " are used");
        std::string_view behind = rest_;
        const bool is_binary = lower_case(take_token(behind)) == "binary";
        if (is_binary) {
            rest_ = behind;
            take_line(rest_);
        }
        return is_binary;
    }

    void read_text() {
        read_counts();
        has_lines_of_more_ = vertices_have_more_on_their_lines();
        parsed_.soup.positions.reserve(vertices_);
        parsed_.soup.ends.reserve(faces_);
        for (size_t i = 0; i < vertices_; ++i) read_vertex(i);
        for (size_t i = 0; i < faces_; ++i) read_face(i);
    }

    void read_counts() {
        vertices_ = read_count("vertices");
        faces_ = read_count("faces");
        skip_edge_count();
        // A vertex takes 6 characters ("0 0 0" and a line end), a face 2 ("0" and a line end).
        const size_t possible = (bytes_ + 1) / 2;
        if (vertices_ > possible / 3 || faces_ > possible || 3 * vertices_ + faces_ > possible)
            fail("the header promises " + std::to_string(vertices_) + " vertices and " +
                 std::to_string(faces_) + " faces, which " + std::to_string(bytes_) +
                 " bytes cannot hold");
    }

    // Some writers leave it out, some put it on a line of its own, where no vertex has one number.
    void skip_edge_count() {
        std::string_view line = take_line(rest_);
        const std::string_view word = take_token(line);
        if (!word.empty() && word[0] != '#') return;
        std::string_view behind = rest_;
        const auto words = take_words(behind);
        if (words.size() == 1 && parse_integer(words[0])) rest_ = behind;
    }

    // Colours or normals that the keyword does not promise.
    bool vertices_have_more_on_their_lines() const {
        std::string_view text = rest_;
        const size_t first = take_words(text).size();
        if (first <= 3 || vertices_ < 2 || take_words(text).size() != first) return false;
        size_t lines = 2;
        while (!take_words(text).empty()) ++lines;
        return lines >= vertices_ + faces_;
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
        if (keyword_.has_colours || has_lines_of_more_) {
            take_line(rest_);  // their number is not fixed
            return;
        }
        const int more = 3 * keyword_.has_normals + 2 * keyword_.has_texcoords;
        for (int i = 0; i < more; ++i) take_word();
    }

    void read_face(size_t face) {
        Soup& soup = parsed_.soup;
        const auto corners = parse_integer(take_word());
        if (corners && *corners > static_cast<long long>(rest_.size()))
            fail("face " + std::to_string(face) + " promises " + std::to_string(*corners) +
                 " corners, but only " + std::to_string(rest_.size()) + " bytes are left");
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
    OffKeyword keyword_;
    bool has_lines_of_more_ = false;
    ParsedMesh& parsed_;
};

}  // namespace

void read_off(const std::string& bytes, const std::string& name, ParsedMesh& parsed) {
    OffReader(bytes, name, parsed).read();
}

}  // namespace render
