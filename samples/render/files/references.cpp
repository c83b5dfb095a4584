// references.cpp - candidates for a name, in order, against what is there.
#include "files/references.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "files/asset.hpp"
#include "files/text_scan.hpp"

namespace render {
namespace {

namespace fs = std::filesystem;

// Beyond these a line is no list of names; trying them all would take long.
constexpr size_t kMaxNames = 64;
constexpr size_t kMaxWords = 6;  // of one of several names
constexpr size_t kMaxNameBytes = 1024;

bool starts_with_drive(std::string_view name) {
    return name.size() > 1 && name[1] == ':' &&
           ((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= 'A' && name[0] <= 'Z'));
}

std::string without_quotes(std::string_view name) {
    name = trimmed(name);
    for (const char quote : {'"', '\''})
        if (name.size() > 1 && name.front() == quote && name.back() == quote)
            name = trimmed(name.substr(1, name.size() - 2));
    return std::string(name);
}

std::string with_slashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

std::optional<std::string> found_beside(const std::string& location, const std::string& name) {
    return find_asset(sibling_path(location, name));
}

// `name` with slashes, without its first folders one by one.
std::optional<std::string> found_by_its_end(const std::string& location, std::string name) {
    if (starts_with_drive(name)) name.erase(0, 2);
    for (;;) {
        name.erase(0, std::min(name.find_first_not_of('/'), name.size()));
        if (name.empty()) return std::nullopt;
        if (auto found = found_beside(location, name)) return found;
        const size_t slash = name.find('/');
        if (slash == name.npos) break;
        name.erase(0, slash);
    }
    for (const char* folder : {"textures/", "maps/", "materials/", "images/", "../textures/",
                               "../maps/", "../materials/", "../images/"})
        if (auto found = found_beside(location, folder + name)) return found;
    return std::nullopt;
}

std::optional<std::string> found(const std::string& location, std::string_view text) {
    const std::string name = without_quotes(text);
    if (name.empty() || name.size() > kMaxNameBytes || name.find('\0') != name.npos)
        return std::nullopt;
    if (auto as_written = found_beside(location, name)) return as_written;
    return found_by_its_end(location, with_slashes(name));
}

// Beside `location`, whether it is there or not.
std::string expected(const std::string& location, std::string_view text) {
    std::string name = with_slashes(without_quotes(text));
    if (starts_with_drive(name)) name = name.substr(name.find_last_of("/:") + 1);
    return sibling_path(location, name);
}

// Words, and what stands in double quotes with its quotes.
std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> parts;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const size_t quote = line[0] == '"' ? line.find('"', 1) : line.npos;
        std::string_view part = line.substr(0, quote == line.npos ? quote : quote + 1);
        if (quote == line.npos) {
            std::string_view rest = line;
            part = take_token(rest);
        }
        parts.push_back(part);
        line.remove_prefix(part.size());
    }
    return parts;
}

std::string_view from_to(std::string_view first, std::string_view last) {
    return {first.data(), static_cast<size_t>(last.data() + last.size() - first.data())};
}

bool ends_name(std::string_view part, std::string_view ending) {
    return part.back() == '"' ||
           (part.size() >= ending.size() &&
            lower_case(part.substr(part.size() - ending.size())) == ending);
}

}  // namespace

std::string find_reference(const std::string& location, std::string_view name) {
    const auto path = found(location, name);
    return path ? *path : expected(location, name);
}

std::vector<std::string> find_references(const std::string& location, std::string_view line,
                                         std::string_view ending) {
    if (const auto whole = found(location, line)) return {*whole};
    std::vector<std::string_view> parts = split(line);
    parts.resize(std::min(parts.size(), kMaxNames));
    std::vector<std::string> paths;
    for (size_t i = 0; i < parts.size();) {
        size_t last = std::min(parts.size(), i + kMaxWords);
        std::optional<std::string> path;
        while (!path && last-- > i) path = found(location, from_to(parts[i], parts[last]));
        if (!path) {
            last = i;
            while (last + 1 < parts.size() && !ends_name(parts[last], ending)) ++last;
            path = expected(location, from_to(parts[i], parts[last]));
        }
        paths.push_back(*path);
        i = last + 1;
    }
    return paths;
}

}  // namespace render
