// json_value.hpp - a JSON value that knows where it stands, so that every wrong one can be
// named: file, path (`meshes[2].material.diffuse`), what was found, what is allowed. Knows no
// scene.
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace render {

// A view: the document must outlive it.
class JsonValue {
public:
    JsonValue(const nlohmann::json& value, std::string file, std::string path)
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    // An object with no other keys than these; call before reading members.
    void allow_keys(std::initializer_list<std::string_view> keys) const;
    bool has(std::string_view key) const { return value_->contains(key); }
    bool is_object() const { return value_->is_object(); }
    bool is_number() const { return value_->is_number(); }
    bool is_integer() const { return value_->is_number_integer(); }  // without a point
    JsonValue member(std::string_view key) const;
    std::optional<JsonValue> find(std::string_view key) const;
    std::vector<std::string> keys() const;
    std::vector<JsonValue> items() const;

    bool boolean() const;
    std::string text() const;
    std::string one_of(std::initializer_list<std::string_view> choices) const;
    double number() const;
    double number_in(double low, double high) const;
    int64_t integer_in(int64_t low, int64_t high) const;
    std::vector<double> numbers(size_t count) const;  // within a float's range
    glm::vec3 vec3() const { return dvec3(); }
    glm::dvec3 dvec3() const;
    glm::vec3 direction() const;  // that has_length
    glm::vec3 colour() const;     // one number stands for grey; not negative

    // "scene.json: meshes[2].file", the start of every message about this value.
    std::string where() const;
    const std::string& file() const { return file_; }
    [[noreturn]] void fail(std::string_view allowed) const;  // "found ..., allowed: ..."

private:
    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

// Whether its length, as floats compute it, is neither 0 nor infinite.
bool has_length(glm::vec3 v);

// The candidate that needs the fewest edits to become `word`; empty when there is none.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace render
