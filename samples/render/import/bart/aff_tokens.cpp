// aff_tokens.cpp - characters -> words. # and % start comments.
#include "import/bart/aff_tokens.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "files/asset.hpp"
#include "files/references.hpp"
#include "files/text_scan.hpp"

namespace render {
namespace {

// Deeper nesting can only be a file that includes itself.
constexpr size_t kMaxDepth = 64;
// Each of which may include the next one twice. BART's kitchen has fifty.
constexpr size_t kMaxFiles = 10000;
// Beside blanks. No word ends at a zero byte.
constexpr std::string_view kEndsOfWords = "#%{}";

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

AffTokens::AffTokens(const std::string& path) {
    open(path);
}

void AffTokens::open(const std::string& path) {
    if (++opened_ > kMaxFiles)
        fail("includes more than " + std::to_string(kMaxFiles) + " files");
    Asset asset = read_asset(path);
    const size_t start =
        asset.bytes.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;  // UTF-8's mark
    files_.push_back({std::move(asset.location), std::move(asset.bytes), start});
}

bool AffTokens::include(const std::string& name) {
    if (files_.size() == kMaxDepth)
        fail("includes are nested " + std::to_string(kMaxDepth) +
             " deep; does a file include itself?");
    const std::string path = find_reference(location(), name);
    if (!find_asset(path)) return false;
    open(path);
    return true;
}

bool AffTokens::find_word() {
    for (;;) {
        File& file = files_.back();
        while (file.at < file.text.size()) {
            const char c = file.text[file.at];
            if (c == '#' || c == '%')
                file.at = std::min(file.text.find('\n', file.at), file.text.size());
            else if (is_blank(c))
                ++file.at;
            else
                return true;
        }
        if (files_.size() == 1) return false;
        files_.pop_back();
    }
}

std::string AffTokens::next() {
    if (!find_word()) return {};
    File& file = files_.back();
    const size_t start = file.at;
    // A brace is a word of its own.
    if (file.text[start] == '{' || file.text[start] == '}') return {file.text[file.at++]};
    while (file.at < file.text.size() && !is_blank(file.text[file.at]) &&
           kEndsOfWords.find(file.text[file.at]) == std::string_view::npos)
        ++file.at;
    return file.text.substr(start, file.at - start);
}

std::string AffTokens::peek() {
    if (!find_word()) return {};
    const size_t at = files_.back().at;
    std::string word = next();
    files_.back().at = at;
    return word;
}

std::string AffTokens::word(const char* what) {
    std::string result = next();
    if (result.empty()) fail(std::string("ends where it needs ") + what);
    return result;
}

double AffTokens::number(const char* what) {
    const std::string text = word(what);
    const auto value = parse_number(text);
    if (!value) fail(std::string("needs a number for ") + what + ", but has '" + text + "'");
    return *value;
}

size_t AffTokens::count(const char* what, size_t numbers) {
    const double value = number(what);
    size_t rest = 1;  // the last number needs no blank behind it
    for (const File& file : files_) rest += file.text.size() - file.at;
    const size_t most = rest / (2 * numbers);
    if (!(value >= 0.0 && value <= static_cast<double>(most) && value == std::floor(value)))
        fail(std::string("the number of ") + what + " is " + std::to_string(value) +
             ", but must be whole and from 0 to " + std::to_string(most) +
             ", as many as the rest of the file can hold");
    return static_cast<size_t>(value);
}

glm::dvec3 AffTokens::vector(const char* what) {
    const double x = number(what), y = number(what), z = number(what);
    return {x, y, z};
}

void AffTokens::expect(const char* expected) {
    const std::string found = word(expected);
    if (found != expected)
        fail(std::string("needs '") + expected + "', but has '" + found + "'");
}

std::string AffTokens::where() {
    File& file = files_.back();
    const auto begin = file.text.begin();
    const auto from = begin + static_cast<std::ptrdiff_t>(file.lines_until);
    const auto to = begin + static_cast<std::ptrdiff_t>(file.at);
    if (from < to) file.line += static_cast<size_t>(std::count(from, to, '\n'));
    file.lines_until = std::max(file.lines_until, file.at);
    return file.location + ", line " + std::to_string(file.line);
}

void AffTokens::fail(const std::string& what) {
    throw LoadError(where() + ": " + what);
}

}  // namespace render
