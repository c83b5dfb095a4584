// json_text.hpp - text of a file -> JSON, within bounds that a file cannot lie about. Knows no keys.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace render {

// What is nested deeper overflows the stack of whoever walks it; scenes need a tenth of that.
constexpr int kMaxJsonDepth = 100;

// Comments are allowed, and so is the mark of UTF-8 before it. Throws LoadError, which begins with
// `file`.
nlohmann::json parse_json(const std::string& text, const std::string& file);

}  // namespace render
