// members.hpp - members of JSON objects that may be absent or of another type: then a dash is shown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace bench {

// A text; `otherwise` where there is none.
std::string text_of(const nlohmann::json& object, const char* key,
                    const std::string& otherwise = "-");
double number_of(const nlohmann::json& object, const char* key);  // 0 where there is none
bool is_true(const nlohmann::json& object, const char* key);
// A number with so many decimals, or a dash.
std::string cell(const nlohmann::json& object, const char* key, int decimals = 0);

}  // namespace bench
