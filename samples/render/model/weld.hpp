// weld.hpp - joins positions that are equal bit for bit, so that a NaN is equal to itself and to
// nothing else.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace render {

class Weld {
public:
    // The index of `position` in positions().
    uint32_t operator()(glm::vec3 position) {
        const std::string bits(reinterpret_cast<const char*>(&position), sizeof position);
        const auto next = static_cast<uint32_t>(positions_.size());
        const auto [entry, is_new] = indices_.emplace(bits, next);
        if (is_new) positions_.push_back(position);
        return entry->second;
    }
    const std::vector<glm::vec3>& positions() const { return positions_; }

private:
    std::unordered_map<std::string, uint32_t> indices_;
    std::vector<glm::vec3> positions_;
};

}  // namespace render
