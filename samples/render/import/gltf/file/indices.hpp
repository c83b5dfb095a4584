// indices.hpp - the numbers in a glTF file's JSON that must be whole, and those that name an element
// of one of its arrays. All throw an error that says where, what was found and what is allowed.
#pragma once

#include <map>
#include <string>

#include "files/json_value.hpp"

namespace render {

// Also refuses 3.0, which tinygltf takes for a member that is not there.
int64_t whole_number(const JsonValue& value, int64_t low, int64_t high);

// The same of a member that may be missing.
int64_t whole_number(const JsonValue& object, const char* key, int64_t low, int64_t high,
                     int64_t otherwise);

class GltfIndices {
public:
    explicit GltfIndices(const JsonValue& document);

    size_t count(const std::string& array) const { return counts_.at(array); }
    // `value` names an element of the document's `array`.
    size_t index(const JsonValue& value, const char* array) const;
    // The same of a member that may be missing.
    void index_if_any(const JsonValue& object, const char* key, const char* array) const;

private:
    std::map<std::string, size_t> counts_;  // 0 of arrays that the document lacks
};

}  // namespace render
