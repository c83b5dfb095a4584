// ply_header.cpp - bytes -> elements, properties, values. Gives names no meaning.
#include "import/ply_header.hpp"

#include <algorithm>
#include <cstring>

#include "files/text_scan.hpp"

namespace render {
namespace {

struct TypeName {
    std::string_view name;
    char type;
};

constexpr TypeName kTypes[] = {
    {"char", 'b'},  {"int8", 'b'},    {"uchar", 'B'},  {"uint8", 'B'},
    {"short", 'h'}, {"int16", 'h'},   {"ushort", 'H'}, {"uint16", 'H'},
    {"int", 'i'},   {"int32", 'i'},   {"uint", 'I'},   {"uint32", 'I'},
    {"float", 'f'}, {"float32", 'f'}, {"double", 'd'}, {"float64", 'd'}};

char type_named(std::string_view name, const std::string& file) {
    for (const TypeName& type : kTypes)
        if (type.name == name) return type.type;
    throw LoadError(file + ": unknown PLY type '" + std::string(name) + "'");
}

template <typename T>
double value_at(const char* bytes, bool swap) {
    char ordered[sizeof(T)];
    std::memcpy(ordered, bytes, sizeof(T));
    if (swap) std::reverse(ordered, ordered + sizeof(T));
    T value;
    std::memcpy(&value, ordered, sizeof(T));
    return static_cast<double>(value);
}

double value_of_type(char type, const char* bytes, bool swap) {
    switch (type) {
        case 'b':
            return value_at<int8_t>(bytes, swap);
        case 'B':
            return value_at<uint8_t>(bytes, swap);
        case 'h':
            return value_at<int16_t>(bytes, swap);
        case 'H':
            return value_at<uint16_t>(bytes, swap);
        case 'i':
            return value_at<int32_t>(bytes, swap);
        case 'I':
            return value_at<uint32_t>(bytes, swap);
        case 'f':
            return value_at<float>(bytes, swap);
        default:
            return value_at<double>(bytes, swap);
    }
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
    const auto count = parse_integer(take_token(line));
    if (!count || *count < 0)
        throw LoadError(file + ": element " + element.name + " has no valid count");
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

size_t ply_type_bytes(char type) {
    switch (type) {
        case 'b':
        case 'B':
            return 1;
        case 'h':
        case 'H':
            return 2;
        case 'd':
            return 8;
        default:
            return 4;
    }
}

// In text, a value takes a character and a blank; a list at least its count.
size_t least_bytes(const PlyElement& element, PlyHeader::Format format) {
    size_t bytes = 0;
    for (const PlyProperty& p : element.properties)
        bytes += format == PlyHeader::Format::ascii
                     ? 2
                     : ply_type_bytes(p.count_type != '\0' ? p.count_type : p.type);
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

PlyHeader read_ply_header(std::string_view file, const std::string& name) {
    std::string_view rest = file;
    if (trimmed(take_line(rest)) != "ply")
        throw LoadError(name + ": does not start with 'ply'");
    PlyHeader header;
    for (;;) {
        if (rest.empty()) throw LoadError(name + ": the PLY header has no end_header");
        const std::string_view line = trimmed(take_line(rest));
        if (line == "end_header") break;
        read_header_line(line, header, name);
    }
    header.bytes = file.size() - rest.size();
    check_promises(header, file.size(), name);
    return header;
}

PlyValues::PlyValues(std::string_view file, const PlyHeader& header, std::string name)
    : rest_(file.substr(header.bytes)), format_(header.format), name_(std::move(name)) {}

double PlyValues::next(char type) {
    if (format_ == PlyHeader::Format::ascii) {
        const std::string_view token = take_token(rest_);
        const auto value = parse_number(token);
        if (token.empty())
            throw LoadError(name_ + ": ends before the values its header promises");
        if (!value)
            throw LoadError(name_ + ": needs a number, but has '" + std::string(token) + "'");
        return *value;
    }
    const size_t bytes = ply_type_bytes(type);
    if (rest_.size() < bytes)
        throw LoadError(name_ + ": ends before the values its header promises");
    const double value =
        value_of_type(type, rest_.data(), format_ == PlyHeader::Format::big_endian);
    rest_.remove_prefix(bytes);
    return value;
}

size_t PlyValues::next_count(char type) {
    const double count = next(type);
    if (!(count >= 0.0 && count <= static_cast<double>(rest_.size())))
        throw LoadError(name_ + ": a list promises " + std::to_string(count) +
                        " values, but the file has " + std::to_string(rest_.size()) +
                        " bytes left");
    return static_cast<size_t>(count);
}

void PlyValues::skip(const PlyProperty& property) {
    const size_t count = property.count_type == '\0' ? 1 : next_count(property.count_type);
    for (size_t i = 0; i < count; ++i) next(property.type);
}

}  // namespace render
