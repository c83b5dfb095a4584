// accessor.cpp - bytes of views -> numbers. That they are there has been checked: ranges.hpp.
#include "import/gltf/file/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace render {
namespace {

size_t component_bytes(const tinygltf::Accessor& accessor) {
    return static_cast<size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType)));
}

size_t component_count(const tinygltf::Accessor& accessor) {
    return static_cast<size_t>(
        tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type)));
}

const char* type_name(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return "SCALAR";
        case TINYGLTF_TYPE_VEC2:
            return "VEC2";
        case TINYGLTF_TYPE_VEC3:
            return "VEC3";
        case TINYGLTF_TYPE_VEC4:
            return "VEC4";
        case TINYGLTF_TYPE_MAT4:
            return "MAT4";
        default:
            return "another matrix";
    }
}

const char* kind_name(GltfNumbers kind) {
    switch (kind) {
        case GltfNumbers::floats:
            return "5126 (float)";
        case GltfNumbers::floats_or_normalized:
            return "5126 (float), or 5121 or 5123 (unsigned) normalized";
        case GltfNumbers::floats_or_signed_normalized:
            return "5126 (float), or 5120 to 5123 normalized";
        case GltfNumbers::unsigned_bytes_or_shorts:
            return "5121 or 5123 (unsigned), not normalized";
        case GltfNumbers::unsigned_integers:
            return "5121, 5123 or 5125 (unsigned)";
    }
    return "";
}

bool is_of_kind(const tinygltf::Accessor& accessor, GltfNumbers kind) {
    const int type = accessor.componentType;
    const bool is_float = type == TINYGLTF_COMPONENT_TYPE_FLOAT;
    const bool is_short =
        type >= TINYGLTF_COMPONENT_TYPE_BYTE && type <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const bool is_unsigned_short = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                   type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    switch (kind) {
        case GltfNumbers::floats:
            return is_float;
        case GltfNumbers::floats_or_normalized:
            return is_float || (is_unsigned_short && accessor.normalized);
        case GltfNumbers::floats_or_signed_normalized:
            return is_float || (is_short && accessor.normalized);
        case GltfNumbers::unsigned_bytes_or_shorts:
            return is_unsigned_short && !accessor.normalized;
        case GltfNumbers::unsigned_integers:
            return is_unsigned_short || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    }
    return false;
}

template <typename T>
T load(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// Of an unsigned component.
uint32_t integer(const unsigned char* bytes, int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? *bytes
           : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? load<uint16_t>(bytes)
                                                            : load<uint32_t>(bytes);
}

// A float, or what a normalized integer stands for (glTF 2.0, 3.11).
float number(const unsigned char* bytes, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return std::max(static_cast<float>(load<int8_t>(bytes)) / 127.0f, -1.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return static_cast<float>(*bytes) / 255.0f;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return std::max(static_cast<float>(load<int16_t>(bytes)) / 32767.0f, -1.0f);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return static_cast<float>(load<uint16_t>(bytes)) / 65535.0f;
        default:
            return load<float>(bytes);
    }
}

// Of packed components, each as `convert` reads it.
template <class Number>
std::vector<Number> converted(const std::vector<unsigned char>& packed,
                              const tinygltf::Accessor& accessor,
                              Number (*convert)(const unsigned char*, int)) {
    const size_t width = component_bytes(accessor);
    std::vector<Number> numbers(packed.size() / width);
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = convert(&packed[i * width], accessor.componentType);
    return numbers;
}

}  // namespace

void GltfAccessors::fail(const std::string& where, const std::string& message) const {
    throw std::runtime_error(document_.location + ": " + where + ": " + message);
}

const unsigned char* GltfAccessors::view_bytes(int view, size_t offset) const {
    const auto& found = document_.model.bufferViews[static_cast<size_t>(view)];
    return document_.model.buffers[static_cast<size_t>(found.buffer)].data.data() +
           found.byteOffset + offset;
}

void GltfAccessors::require_kind(int accessor, int type, GltfNumbers kind,
                                 const std::string& where) const {
    const tinygltf::Accessor& found = of(accessor);
    if (found.type != type)
        fail(where, fmt::format("accessors[{}] is {}, must be {}", accessor,
                                type_name(found.type), type_name(type)));
    if (!is_of_kind(found, kind))
        fail(where, fmt::format("accessors[{}] has the componentType {}{}, must have {}",
                                accessor, found.componentType,
                                found.normalized ? " normalized" : "", kind_name(kind)));
}

std::vector<unsigned char> GltfAccessors::bytes(int accessor, const std::string& where) const {
    const tinygltf::Accessor& found = of(accessor);
    const size_t element = component_bytes(found) * component_count(found);
    std::vector<unsigned char> packed(element * found.count);
    if (found.bufferView >= 0) {
        const size_t own =
            document_.model.bufferViews[static_cast<size_t>(found.bufferView)].byteStride;
        const size_t stride = own == 0 ? element : own;
        const unsigned char* from = view_bytes(found.bufferView, found.byteOffset);
        for (size_t i = 0; i < found.count; ++i)
            std::memcpy(&packed[i * element], from + i * stride, element);
    }
    if (found.sparse.isSparse) fill_in(found, packed, where);
    return packed;
}

void GltfAccessors::fill_in(const tinygltf::Accessor& accessor,
                            std::vector<unsigned char>& packed,
                            const std::string& where) const {
    const size_t element = component_bytes(accessor) * component_count(accessor);
    const auto& sparse = accessor.sparse;
    const unsigned char* places =
        view_bytes(sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset));
    const unsigned char* values =
        view_bytes(sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset));
    const int type = sparse.indices.componentType;
    const auto width =
        static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(type)));
    for (size_t i = 0; i < static_cast<size_t>(sparse.count); ++i) {
        const uint32_t place = integer(places + i * width, type);
        if (place >= accessor.count)
            fail(where,
                 fmt::format("its accessor's sparse.indices[{}] is {}, must be below {}, "
                             "its count",
                             i, place, accessor.count));
        std::memcpy(&packed[place * element], values + i * element, element);
    }
}

std::vector<float> GltfAccessors::floats(int accessor, int type, GltfNumbers kind,
                                         const std::string& where) const {
    require_kind(accessor, type, kind, where);
    return converted(bytes(accessor, where), of(accessor), number);
}

std::vector<uint32_t> GltfAccessors::integers(int accessor, int type, GltfNumbers kind,
                                              const std::string& where) const {
    require_kind(accessor, type, kind, where);
    return converted(bytes(accessor, where), of(accessor), integer);
}

}  // namespace render
