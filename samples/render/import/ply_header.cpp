// ply_header.cpp - bytes -> elements, properties, values. Gives names no meaning.
#include "import/ply_header.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iomanip>
#include <sstream>

#include "files/text_scan.hpp"

namespace render {
namespace {

template <typename T>
double value_at(const char* bytes, bool swap) {
    char ordered[sizeof(T)];
    std::memcpy(ordered, bytes, sizeof(T));
    if (swap) std::reverse(ordered, ordered + sizeof(T));
    T value;
    std::memcpy(&value, ordered, sizeof(T));
    return static_cast<double>(value);
}

constexpr PlyType kTypes[] = {
    {"char", "int8", 1, value_at<int8_t>},    {"uchar", "uint8", 1, value_at<uint8_t>},
    {"short", "int16", 2, value_at<int16_t>}, {"ushort", "uint16", 2, value_at<uint16_t>},
    {"int", "int32", 4, value_at<int32_t>},   {"uint", "uint32", 4, value_at<uint32_t>},
    {"float", "float32", 4, value_at<float>}, {"double", "float64", 8, value_at<double>}};

const PlyType* type_named(std::string_view name, const std::string& file) {
    for (const PlyType& type : kTypes)
        if (type.name == name || type.other_name == name) return &type;
    throw LoadError(file + ": unknown PLY type '" + std::string(name) + "'");
}

PlyHeader::Format format_named(std::string_view name, const std::string& file) {
    if (name == "ascii") return PlyHeader::Format::ascii;
    if (name == "binary_little_endian") return PlyHeader::Format::little_endian;
    if (name == "binary_big_endian") return PlyHeader::Format::big_endian;
    throw LoadError(file + ": unknown PLY format '" + std::string(name) + "'");
}

PlyElement read_element(std::string_view line, const std::string& file) {
    PlyElement element;
    element.name = std::string(take_token(line));
    const std::string_view word = take_token(line);
    const auto count = parse_integer(word);
    if (!count || *count < 0)
        throw LoadError(file + ": element " + element.name + " has the count '" +
                        std::string(word) + "', which must be a whole number from 0");
    element.count = static_cast<size_t>(*count);
    return element;
}

PlyProperty read_property(std::string_view line, const std::string& file) {
    PlyProperty property;
    std::string_view type = take_token(line);
    if (type == "list") {
        property.count_type = type_named(take_token(line), file);
        type = take_token(line);
    }
    property.type = type_named(type, file);
    property.name = std::string(take_token(line));
    return property;
}

void read_header_line(std::string_view line, PlyHeader& header, const std::string& file) {
    const std::string_view keyword = take_token(line);
    if (keyword == "format") header.format = format_named(take_token(line), file);
    if (keyword == "element") header.elements.push_back(read_element(line, file));
    if (keyword == "property") {
        if (header.elements.empty())
            throw LoadError(file + ": a PLY property before the first element");
        header.elements.back().properties.push_back(read_property(line, file));
    }
    if (keyword == "comment" && take_token(line) == "TextureFile")
        header.texture = std::string(trimmed(line));
}

// In text, a value takes a character and a blank; a list at least its count.
size_t least_bytes(const PlyElement& element, PlyHeader::Format format) {
    size_t bytes = 0;
    for (const PlyProperty& p : element.properties)
        bytes += format == PlyHeader::Format::ascii
                     ? 2
                     : (p.count_type ? p.count_type : p.type)->bytes;
    return bytes;
}

void check_promises(const PlyHeader& header, size_t file_bytes, const std::string& file) {
    // The last value of a text needs no blank behind it.
    size_t left =
        file_bytes - header.bytes + (header.format == PlyHeader::Format::ascii ? 1 : 0);
    for (const PlyElement& element : header.elements) {
        const size_t each = least_bytes(element, header.format);
        if (each > 0 && element.count > left / each)
            throw LoadError(file + ": the header promises " + std::to_string(element.count) +
                            " of element " + element.name + ", but the file has room for " +
                            std::to_string(left / each));
        left -= element.count * each;
    }
}

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
    for (const PlyProperty& p : properties)
        if (p.name == property) return &p;
    return nullptr;
}

namespace {

// A header whose first line ends with CR alone is followed by values, not by an LF of the last line.
std::string_view take_header_line(std::string_view& text, bool ends_with_cr) {
    if (!ends_with_cr) return take_line(text);
    const size_t end = std::min(text.find('\r'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

}  // namespace

PlyHeader read_ply_header(std::string_view file, const std::string& name) {
    std::string_view rest = without_mark(file);
    require_text(rest.substr(0, 3), name);
    const size_t end = rest.find_first_of("\r\n");
    const bool ends_with_cr =
        end != rest.npos && rest.substr(end, 2) != "\r\n" && rest[end] == '\r';
    const std::string_view first = trimmed(take_header_line(rest, ends_with_cr));
    if (lower_case(first) != "ply")
        throw LoadError(name + ": starts with '" + std::string(first.substr(0, 20)) +
                        "', but needs 'ply'");
    PlyHeader header;
    for (;;) {
        if (rest.empty()) throw LoadError(name + ": the PLY header has no end_header");
        const std::string_view line = trimmed(take_header_line(rest, ends_with_cr));
        if (line == "end_header") break;
        read_header_line(line, header, name);
    }
    header.bytes = file.size() - rest.size();
    check_promises(header, file.size(), name);
    return header;
}

PlyValues::PlyValues(std::string_view file, const PlyHeader& header, std::string name)
    : rest_(file.substr(header.bytes)), format_(header.format), name_(std::move(name)) {}

void PlyValues::fail(const std::string& what) const {
    const std::string row = element_ ? ": " + element_->name + " " + std::to_string(row_) : "";
    throw LoadError(name_ + row + what);
}

double PlyValues::next(const PlyType& type) {
    if (format_ == PlyHeader::Format::ascii) {
        const std::string_view token = take_token(rest_);
        const auto value = parse_number(token);
        if (token.empty()) fail(": the file ends before the values that its header promises");
        if (!value) fail(": needs a number, but has '" + std::string(token) + "'");
        return *value;
    }
    if (rest_.size() < type.bytes)
        fail(": the file ends before the values that its header promises");
    const double value = type.read(rest_.data(), format_ == PlyHeader::Format::big_endian);
    rest_.remove_prefix(type.bytes);
    return value;
}

size_t PlyValues::next_count(const PlyProperty& list) {
    const double count = next(*list.count_type);
    // In text, a value takes a blank and a character.
    const size_t each = format_ == PlyHeader::Format::ascii ? 2 : list.type->bytes;
    const size_t room = rest_.size() / each;
    if (!(count >= 0.0 && count <= static_cast<double>(room)) || count != std::floor(count)) {
        std::ostringstream text;
        text << ": list " << list.name << " promises " << std::setprecision(17) << count
             << " values, but needs a whole number up to " << room << ", for the "
             << rest_.size() << " bytes that are left";
        fail(text.str());
    }
    return static_cast<size_t>(count);
}

void PlyValues::skip(const PlyProperty& property) {
    const size_t count = property.count_type ? next_count(property) : 1;
    for (size_t i = 0; i < count; ++i) next(*property.type);
}

void PlyValues::skip(const PlyElement& element) {
    if (element.properties.empty()) return;  // of any number of them
    for (size_t i = 0; i < element.count; ++i) {
        start_row(element, i);
        for (const PlyProperty& p : element.properties) skip(p);
    }
}

}  // namespace render
