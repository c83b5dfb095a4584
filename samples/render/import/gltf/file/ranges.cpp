// ranges.cpp - buffers hold views, views hold accessors.
#include "import/gltf/file/ranges.hpp"

#include <fmt/format.h>

#include <climits>

namespace render {
namespace {

constexpr int64_t kMost = INT32_MAX;  // bytes and elements: tinygltf counts in int

// Without a view, all elements are 0: any number of them takes no byte of the file.
constexpr int64_t kMostZeros = 1 << 24;

struct View {
    size_t bytes = 0, stride = 0;
};

class Ranges {
public:
    Ranges(const JsonValue& document, const GltfIndices& indices) : indices_(indices) {
        for (const JsonValue& buffer : items(document, "buffers"))
            buffers_.push_back(static_cast<size_t>(
                whole_number(buffer.member("byteLength"), 1, int64_t{UINT32_MAX})));
        for (const JsonValue& view : items(document, "bufferViews"))
            views_.push_back(this->view(view));
        for (const JsonValue& accessor : items(document, "accessors")) check_accessor(accessor);
    }

    static std::vector<JsonValue> items(const JsonValue& document, const char* array) {
        const auto found = document.find(array);
        return found ? found->items() : std::vector<JsonValue>();
    }

private:
    View view(const JsonValue& value) const;
    void check_accessor(const JsonValue& value) const;
    void check_sparse(const JsonValue& accessor, size_t element, int64_t count) const;
    void require_in_view(const JsonValue& value, size_t element, int64_t count,
                         bool is_packed) const;

    const GltfIndices& indices_;
    std::vector<size_t> buffers_;
    std::vector<View> views_;
};

View Ranges::view(const JsonValue& value) const {
    const size_t buffer = indices_.index(value.member("buffer"), "buffers");
    const int64_t offset = whole_number(value, "byteOffset", 0, kMost, 0);
    const int64_t length = whole_number(value.member("byteLength"), 1, kMost);
    const int64_t stride = whole_number(value, "byteStride", 4, 252, 0);
    if (stride % 4 != 0) value.member("byteStride").fail("a multiple of 4 from 4 to 252");
    if (static_cast<size_t>(offset + length) > buffers_[buffer])
        value.fail(
            fmt::format("at most the {} bytes of buffers[{}]; byteOffset and byteLength "
                        "reach to byte {}",
                        buffers_[buffer], buffer, offset + length));
    return {static_cast<size_t>(length), static_cast<size_t>(stride)};
}

size_t component_bytes(int64_t type) {
    return type <= 5121 ? 1 : type <= 5123 ? 2 : 4;
}

size_t component_count(const std::string& type) {
    return type == "SCALAR"                   ? 1
           : type == "VEC2"                   ? 2
           : type == "VEC3"                   ? 3
           : type == "VEC4" || type == "MAT2" ? 4
           : type == "MAT3"                   ? 9
                                              : 16;
}

int64_t component_type(const JsonValue& value) {
    const int64_t type = whole_number(value, 5120, 5126);
    if (type == 5124) value.fail("5120, 5121, 5122, 5123, 5125 or 5126");
    return type;
}

// `value` has bufferView and byteOffset.
void Ranges::require_in_view(const JsonValue& value, size_t element, int64_t count,
                             bool is_packed) const {
    const size_t index = indices_.index(value.member("bufferView"), "bufferViews");
    const View& view = views_[index];
    const auto offset = static_cast<size_t>(whole_number(value, "byteOffset", 0, kMost, 0));
    const size_t stride = is_packed || view.stride == 0 ? element : view.stride;
    if (stride < element)
        value.fail(
            fmt::format("elements of at most {} bytes, the byteStride of "
                        "bufferViews[{}]; one takes {}",
                        stride, index, element));
    const size_t end = offset + stride * (static_cast<size_t>(count) - 1) + element;
    if (end > view.bytes)
        value.fail(
            fmt::format("at most the {} bytes of bufferViews[{}]; {} elements reach to "
                        "byte {}",
                        view.bytes, index, count, end));
}

void Ranges::check_accessor(const JsonValue& value) const {
    const int64_t type = component_type(value.member("componentType"));
    const size_t element = component_bytes(type) *
                           component_count(value.member("type").one_of(
                               {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"}));
    if (auto v = value.find("normalized")) v->boolean();
    const bool has_view = value.has("bufferView");
    const int64_t count = whole_number(value.member("count"), 1, has_view ? kMost : kMostZeros);
    if (has_view) require_in_view(value, element, count, false);
    check_sparse(value, element, count);
}

void Ranges::check_sparse(const JsonValue& accessor, size_t element, int64_t count) const {
    const auto sparse = accessor.find("sparse");
    if (!sparse) return;
    const int64_t some = whole_number(sparse->member("count"), 1, count);
    const JsonValue places = sparse->member("indices");
    const JsonValue type = places.member("componentType");
    const int64_t word = component_type(type);
    if (word != 5121 && word != 5123 && word != 5125) type.fail("5121, 5123 or 5125");
    require_in_view(places, component_bytes(word), some, true);
    require_in_view(sparse->member("values"), element, some, true);
}

// Where the bytes of a buffer without an "uri" are.
void check_binary_chunk(const JsonValue& document, size_t binary_bytes) {
    for (const JsonValue& buffer : Ranges::items(document, "buffers")) {
        const JsonValue length = buffer.member("byteLength");
        if (buffer.has("uri")) {
            buffer.member("uri").text();
        } else if (length.number() > static_cast<double>(binary_bytes)) {
            length.fail(
                binary_bytes == 0
                    ? "a buffer with an \"uri\": the file has no chunk BIN"
                    : fmt::format("at most {}, the bytes of the chunk BIN", binary_bytes));
        }
    }
}

}  // namespace

void check_ranges(const JsonValue& document, const GltfIndices& indices, size_t binary_bytes) {
    const Ranges ranges(document, indices);
    check_binary_chunk(document, binary_bytes);
}

}  // namespace render
