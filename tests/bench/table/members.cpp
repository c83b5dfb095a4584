#include "table/members.hpp"

#include <fmt/format.h>

namespace bench {
namespace {

using nlohmann::json;

const json& member(const json& object, const char* key) {
    static const json none;
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

}  // namespace

std::string text_of(const json& object, const char* key, const std::string& otherwise) {
    const json& found = member(object, key);
    return found.is_string() ? found.get<std::string>() : otherwise;
}

double number_of(const json& object, const char* key) {
    const json& found = member(object, key);
    return found.is_number() ? found.get<double>() : 0;
}

bool is_true(const json& object, const char* key) {
    const json& found = member(object, key);
    return found.is_boolean() && found.get<bool>();
}

std::string cell(const json& object, const char* key, int decimals) {
    const json& found = member(object, key);
    return found.is_number() ? fmt::format("{:.{}f}", found.get<double>(), decimals) : "-";
}

}  // namespace bench
