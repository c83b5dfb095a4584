// plain_off.cpp - Geomview OFF -> the same without comments, colours and other attributes, one
// vertex and one face a line. Binary and higher-dimensional OFF are refused.
#include "files/text_scan.hpp"
#include "import/plain_mesh.hpp"

namespace render {
namespace {

std::string without_comments(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::string_view line = take_line(text);
        result.append(line.substr(0, line.find('#'))).push_back('\n');
    }
    return result;
}

class OffRewriter {
public:
    OffRewriter(const std::string& bytes, const std::string& name)
        : text_(without_comments(bytes)), rest_(text_), name_(name) {
        plain_.format = "off";
    }

    PlainMesh rewrite() {
        read_header();
        plain_.text = "OFF\n" + std::to_string(plain_.vertices) + " " +
                      std::to_string(plain_.faces) + " 0\n";
        for (size_t i = 0; i < plain_.vertices; ++i) read_vertex(i);
        for (size_t i = 0; i < plain_.faces; ++i) read_face(i);
        return std::move(plain_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw LoadError(name_ + ": " + what);
    }

    // The keyword may be absent: then the file starts with its counts.
    void read_header() {
        std::string_view peek = rest_;
        const std::string_view keyword = take_token(peek);
        if (!parse_integer(keyword)) {
            read_keyword(keyword);
            rest_ = peek;
        }
        plain_.vertices = read_count("vertices");
        plain_.faces = read_count("faces");
        skip_edge_count();
        // A vertex takes 6 characters ("0 0 0" and a line end), a face 2 ("0" and a line end).
        const size_t possible = (text_.size() + 1) / 2;
        if (plain_.vertices > possible / 3 || plain_.faces > possible ||
            3 * plain_.vertices + plain_.faces > possible)
            fail("the header promises " + std::to_string(plain_.vertices) + " vertices and " +
                 std::to_string(plain_.faces) + " faces, which " +
                 std::to_string(text_.size()) + " bytes cannot hold");
    }

    void read_keyword(std::string_view keyword) {
        const bool is_off = keyword.size() >= 3 && keyword.substr(keyword.size() - 3) == "OFF";
        const std::string prefix(is_off ? keyword.substr(0, keyword.size() - 3) : keyword);
        size_t at = 0;
        if (prefix.compare(at, 2, "ST") == 0) at += 2, extra_tokens_ += 2;
        if (prefix.compare(at, 1, "C") == 0) at += 1, has_colours_ = true;
        if (prefix.compare(at, 1, "N") == 0) at += 1, extra_tokens_ += 3;
        if (!is_off || at != prefix.size())
            fail("starts with '" + std::string(keyword) +
                 "', but needs OFF, possibly after ST, C and N in this order");
        if (at > 0)
            plain_.warnings.push_back(name_ + ": only the positions of " +
                                      std::string(keyword) + " are used");
    }

    size_t read_count(const char* what) {
        const std::string_view token = take_token(rest_);
        const auto count = parse_integer(token);
        if (!count || *count < 0)
            fail(std::string("the header needs a number of ") + what + ", but has '" +
                 std::string(token) + "'");
        return static_cast<size_t>(*count);
    }

    // Nobody needs it, and some writers leave it out.
    void skip_edge_count() { take_line(rest_); }

    void read_vertex(size_t index) {
        std::string_view tokens[3];
        for (std::string_view& token : tokens) token = take_token(rest_);
        if (tokens[2].empty())
            fail("ends after " + std::to_string(index) + " of " +
                 std::to_string(plain_.vertices) + " vertices");
        append_position(plain_, static_cast<uint32_t>(index), tokens,
                        name_ + ", vertex " + std::to_string(index));
        if (has_colours_)
            take_line(rest_);
        else
            for (int i = 0; i < extra_tokens_; ++i) take_token(rest_);
    }

    void read_face(size_t face) {
        const auto corners = parse_integer(take_token(rest_));
        std::string line = std::to_string(corners.value_or(0));
        for (long long i = 0; corners && i < *corners; ++i) {
            const std::string_view token = take_token(rest_);
            const auto index = parse_integer(token);
            if (token.empty() || !index) fail_at_face(face, token);
            // An index that no 32 bits hold becomes one that is out of range as well.
            line += ' ' + std::to_string(*index < 0 || *index > INT32_MAX ? INT32_MAX : *index);
        }
        if (!corners || *corners < 0) fail_at_face(face, "");
        plain_.text += line + '\n';
        take_line(rest_);  // what is left of it is a colour
    }

    [[noreturn]] void fail_at_face(size_t face, std::string_view token) const {
        if (trimmed(rest_).empty() && token.empty())
            fail("ends after " + std::to_string(face) + " of " + std::to_string(plain_.faces) +
                 " faces");
        fail("face " + std::to_string(face) +
             " needs its number of corners and as many indices, but has '" +
             std::string(token) + "'");
    }

    const std::string text_;
    std::string_view rest_;
    const std::string name_;
    PlainMesh plain_;
    int extra_tokens_ = 0;
    bool has_colours_ = false;
};

}  // namespace

PlainMesh plain_off(const std::string& bytes, const std::string& name) {
    return OffRewriter(bytes, name).rewrite();
}

}  // namespace render
