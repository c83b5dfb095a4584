// json_value.cpp - typed access to JSON with messages that say where, what and what instead.
#include "files/json_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace render {
namespace {

// Levenshtein's distance, one row of the table at a time.
size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (const char letter : a) {
        size_t diagonal = row[0]++;
        for (size_t j = 0; j < b.size(); ++j) {
            const size_t replaced = diagonal + (letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row[b.size()];
}

std::string shortened(const nlohmann::json& value) {
    constexpr size_t kLongest = 60;
    // Strings may hold bytes that are not UTF-8; replace them rather than throw again.
    std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    return fmt::format("{} ({})", text, value.type_name());
}

bool is_float(const nlohmann::json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= FLT_MAX;
}

std::string child_path(const std::string& parent, std::string_view key) {
    return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
    const auto nearer = [&](const std::string& a, const std::string& b) {
        return edit_distance(word, a) < edit_distance(word, b);
    };
    const auto best = std::min_element(candidates.begin(), candidates.end(), nearer);
    return best == candidates.end() ? std::string() : *best;
}

std::string JsonValue::where() const {
    return path_.empty() ? file_ : fmt::format("{}: {}", file_, path_);
}

void JsonValue::fail(std::string_view allowed) const {
    throw std::runtime_error(
        fmt::format("{}: found {}, allowed: {}", where(), shortened(*value_), allowed));
}

void JsonValue::allow_keys(std::initializer_list<std::string_view> keys) const {
    const std::vector<std::string> allowed(keys.begin(), keys.end());
    if (!value_->is_object())
        fail(fmt::format("an object with the keys {}", fmt::join(allowed, ", ")));
    for (const auto& [key, unused] : value_->items()) {
        if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
        throw std::runtime_error(fmt::format(
            "{}: {}: found an unknown key; did you mean \"{}\"? allowed: {}", file_,
            child_path(path_, key), nearest_word(key, allowed), fmt::join(allowed, ", ")));
    }
}

JsonValue JsonValue::member(std::string_view key) const {
    if (auto found = find(key)) return *found;
    throw std::runtime_error(
        fmt::format("{}: found no key \"{}\", which is required", where(), key));
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
    const auto at = value_->find(key);
    if (at == value_->end()) return std::nullopt;
    return JsonValue(*at, file_, child_path(path_, key));
}

std::vector<std::string> JsonValue::keys() const {
    if (!value_->is_object()) fail("an object");
    std::vector<std::string> names;
    for (const auto& [key, unused] : value_->items()) names.push_back(key);
    return names;
}

std::vector<JsonValue> JsonValue::items() const {
    if (!value_->is_array()) fail("an array");
    std::vector<JsonValue> values;
    for (size_t i = 0; i < value_->size(); ++i)
        values.emplace_back((*value_)[i], file_, fmt::format("{}[{}]", path_, i));
    return values;
}

bool JsonValue::boolean() const {
    if (!value_->is_boolean()) fail("true or false");
    return value_->get<bool>();
}

std::string JsonValue::text() const {
    if (!value_->is_string()) fail("a string");
    return value_->get<std::string>();
}

std::string JsonValue::one_of(std::initializer_list<std::string_view> choices) const {
    const std::vector<std::string> words(choices.begin(), choices.end());
    const std::string word = value_->is_string() ? value_->get<std::string>() : std::string();
    if (std::find(words.begin(), words.end(), word) == words.end())
        fail(fmt::format("{}; nearest: \"{}\"", fmt::join(words, ", "),
                         nearest_word(word, words)));
    return word;
}

double JsonValue::number() const {
    if (!value_->is_number()) fail("a number");
    return value_->get<double>();
}

double JsonValue::number_in(double low, double high) const {
    const auto allowed = [&] { return fmt::format("a number from {} to {}", low, high); };
    if (!value_->is_number()) fail(allowed());
    const double number = value_->get<double>();
    if (!(number >= low && number <= high)) fail(allowed());
    return number;
}

int64_t JsonValue::integer_in(int64_t low, int64_t high) const {
    const auto allowed = [&] { return fmt::format("a whole number from {} to {}", low, high); };
    // A double cannot tell whole numbers of more bits apart, and JSON has no other kind.
    constexpr double kLargestWhole = 9007199254740992.0;
    if (!value_->is_number()) fail(allowed());
    const double number = value_->get<double>();
    const bool is_whole = std::abs(number) <= kLargestWhole && number == std::floor(number);
    if (!is_whole || number < static_cast<double>(low) || number > static_cast<double>(high))
        fail(allowed());
    return static_cast<int64_t>(number);
}

std::vector<double> JsonValue::numbers(size_t count) const {
    if (!value_->is_array() || value_->size() != count ||
        !std::all_of(value_->begin(), value_->end(), is_float))
        fail(fmt::format("an array of {} numbers from {} to {}", count, -FLT_MAX, FLT_MAX));
    return value_->get<std::vector<double>>();
}

bool has_length(glm::vec3 v) {
    const float square = glm::dot(v, v);
    return square > 0.0f && std::isfinite(square);
}

glm::dvec3 JsonValue::dvec3() const {
    const auto n = numbers(3);
    return {n[0], n[1], n[2]};
}

glm::vec3 JsonValue::direction() const {
    const glm::vec3 v = vec3();
    if (!has_length(v)) fail("three numbers, a vector of a length from 1e-18 to 1e18");
    return v;
}

glm::vec3 JsonValue::colour() const {
    constexpr auto kAllowed =
        "one number or an array of 3 numbers (linear r, g, b), none negative or beyond a float";
    const bool three = value_->is_array() && value_->size() == 3 &&
                       std::all_of(value_->begin(), value_->end(), is_float);
    if (!three && !is_float(*value_)) fail(kAllowed);
    const glm::vec3 rgb = three ? vec3() : glm::vec3(value_->get<float>());
    if (!(rgb.r >= 0.0f && rgb.g >= 0.0f && rgb.b >= 0.0f)) fail(kAllowed);
    return rgb;
}

}  // namespace render
