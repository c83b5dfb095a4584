// left_out.hpp - what a suite left out, as text: cases that differ by the contender alone, and have
// the same reason, in one line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace bench {

// `left_out`: objects with "name" and "why". Empty if there are none.
std::string left_out_text(const nlohmann::json& left_out);

}  // namespace bench
