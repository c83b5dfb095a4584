// ply_header.hpp - the header of a PLY file, and the values behind it one at a time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace render {

// A number as a PLY file stores it.
struct PlyType {
    std::string_view name, other_name;
    size_t bytes;
    double (*read)(const char* bytes, bool swap);
};

struct PlyProperty {
    std::string name;
    const PlyType* type = nullptr;
    const PlyType* count_type = nullptr;  // of a list; none: a scalar
};

struct PlyElement {
    std::string name;
    size_t count = 0;
    std::vector<PlyProperty> properties;
    const PlyProperty* find(std::string_view property) const;
};

struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian } format = Format::ascii;
    std::vector<PlyElement> elements;
    std::string texture;  // from "comment TextureFile", a widespread convention
    size_t bytes = 0;     // up to and with the line end behind end_header
};

// Throws LoadError for what is no PLY header, and for one that promises more than `file` holds.
PlyHeader read_ply_header(std::string_view file, const std::string& name);

// The values behind the header, in order; every call throws LoadError at the end of the file.
class PlyValues {
public:
    PlyValues(std::string_view file, const PlyHeader& header, std::string name);
    // What the values that follow belong to: "face 3", for messages.
    void start_row(const PlyElement& element, size_t row) { element_ = &element, row_ = row; }
    double next(const PlyType& type);
    size_t next_count(const PlyProperty& list);
    void skip(const PlyProperty& property);
    void skip(const PlyElement& element);

private:
    [[noreturn]] void fail(const std::string& what) const;

    const PlyElement* element_ = nullptr;
    size_t row_ = 0;
    std::string_view rest_;
    PlyHeader::Format format_;
    std::string name_;
};

}  // namespace render
