// json_text.cpp - the parser with a limit.
#include "files/json_text.hpp"

#include <fmt/format.h>

#include "files/text_scan.hpp"

namespace render {

nlohmann::json parse_json(const std::string& text, const std::string& file) {
    const auto check_depth = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
        if (depth < kMaxJsonDepth) return true;
        throw LoadError(fmt::format("{}: found values nested {} deep, allowed: less than that",
                                    file, depth));
    };
    try {
        return nlohmann::json::parse(text, check_depth, true, /*ignore_comments=*/true);
    } catch (const nlohmann::json::exception& error) {
        // What was read last, which may be all of the file, ends the message.
        constexpr size_t kLongest = 300;
        std::string message = error.what();
        if (message.size() > kLongest) message = message.substr(0, kLongest) + "...";
        throw LoadError(fmt::format("{}: not JSON: {}", file, message));
    }
}

}  // namespace render
