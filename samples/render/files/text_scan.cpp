// text_scan.cpp - views in, views and numbers out. Copies nothing but what strtod needs.
#include "files/text_scan.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace render {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

// from_chars and strtod of the C locale accept no leading plus; files do.
std::string_view without_plus(std::string_view token) {
    if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
    return token;
}

}  // namespace

std::optional<double> parse_number(std::string_view token) {
    token = without_plus(token);
    double value = 0.0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (token.empty() || end != token.data() + token.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range)
        return std::strtod(std::string(token).c_str(), nullptr);
    if (error != std::errc()) return std::nullopt;
    return value;
}

std::optional<long long> parse_integer(std::string_view token) {
    token = without_plus(token);
    long long value = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
    if (token.empty() || error != std::errc() || end != token.data() + token.size())
        return std::nullopt;
    return value;
}

void require_text(std::string_view bytes, const std::string& name) {
    const std::string_view start = bytes.substr(0, 2);
    if (start == "\xfe\xff" || start == "\xff\xfe" || bytes.find('\0') != bytes.npos)
        throw LoadError(name + ": is not text of single bytes (UTF-16?); needs ASCII or UTF-8");
}

std::string_view without_mark(std::string_view text) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
        if (text.substr(0, kMark.size()) != kMark) return text;
        text.remove_prefix(kMark.size());
    }
}

std::string_view trimmed(std::string_view text) {
    const size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string_view take_token(std::string_view& text) {
    const size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) {
        text = {};
        return {};
    }
    const size_t end = std::min(text.find_first_of(kBlanks, first), text.size());
    const std::string_view token = text.substr(first, end - first);
    text.remove_prefix(end);
    return token;
}

std::string_view take_line(std::string_view& text) {
    const size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos) {
        const std::string_view line = text;
        text = {};
        return line;
    }
    const std::string_view line = text.substr(0, end);
    const bool two = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (two ? 2 : 1));
    return line;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

}  // namespace render
