// accessor.hpp - the elements of a glTF accessor as numbers: sparse ones filled in, normalized
// integers as what they stand for. What kind of accessor a place may name is asked here.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "import/gltf/file/document.hpp"

namespace render {

enum class GltfNumbers {
    floats,
    floats_or_normalized,         // of unsigned integers
    floats_or_signed_normalized,  // of any integers
    unsigned_bytes_or_shorts,     // not normalized
    unsigned_integers
};

// `where`: of the member that names the accessor, such as "meshes[0].primitives[1].indices"; errors
// begin with the file and it.
class GltfAccessors {
public:
    explicit GltfAccessors(const GltfDocument& document) : document_(document) {}

    size_t count(int accessor) const { return of(accessor).count; }
    // All components of all elements; `type`: TINYGLTF_TYPE_...
    std::vector<float> floats(int accessor, int type, GltfNumbers kind,
                              const std::string& where) const;
    std::vector<uint32_t> integers(int accessor, int type, GltfNumbers kind,
                                   const std::string& where) const;

    [[noreturn]] void fail(const std::string& where, const std::string& message) const;

private:
    const tinygltf::Accessor& of(int accessor) const {
        return document_.model.accessors[static_cast<size_t>(accessor)];
    }
    void require_kind(int accessor, int type, GltfNumbers kind, const std::string& where) const;
    std::vector<unsigned char> bytes(int accessor, const std::string& where) const;
    void fill_in(const tinygltf::Accessor& accessor, std::vector<unsigned char>& packed,
                 const std::string& where) const;
    const unsigned char* view_bytes(int view, size_t offset) const;

    const GltfDocument& document_;
};

}  // namespace render
