// warnings.cpp - lines below a message.
#include "model/warnings.hpp"

#include <algorithm>

namespace render {

std::string with_warnings(const std::string& message,
                          const std::vector<std::string>& warnings) {
    constexpr size_t kMost = 20;
    std::string text = message;
    for (size_t i = 0; i < std::min(warnings.size(), kMost); ++i)
        text += "\nwarning: " + warnings[i];
    if (warnings.size() > kMost)
        text += "\nand " + std::to_string(warnings.size() - kMost) + " warnings more";
    return text;
}

}  // namespace render
