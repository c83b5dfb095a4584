// file_search.cpp - the order of folders in which scenes look for their files.
#include "files/file_search.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace render {
namespace {

namespace fs = std::filesystem;

void append_folders(const char* variable, std::vector<std::string>& folders) {
    const char* value = std::getenv(variable);
    std::string rest = value ? value : "";
    while (!rest.empty()) {
        const size_t colon = rest.find(':');
        if (colon != 0) folders.push_back(rest.substr(0, colon));
        rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
    }
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

// The forms of path that read_asset understands: plain, compressed, and a member of an archive.
// Whether the archive has that member is for the loader to find out.
bool is_readable(const fs::path& path) {
    const std::string text = path.string();
    if (is_file(path) || is_file(text.substr(0, text.find(':')))) return true;
    for (const char* ending : {".xz", ".gz", ".bz2", ".zst"})
        if (is_file(text + ending) ||
            is_file(fs::path(path).replace_extension(".tar") += ending))
            return true;
    return false;
}

}  // namespace

std::vector<std::string> search_folders(const std::string& scene_folder) {
    std::vector<std::string> folders{scene_folder.empty() ? "." : scene_folder};
    append_folders("RSH_SCENES", folders);
    append_folders("RSH_ASSETS", folders);
    return folders;
}

std::string find_file(const std::string& name, const std::vector<std::string>& folders,
                      const std::string& where) {
    for (const std::string& folder : folders) {
        const fs::path path = fs::path(folder) / name;  // an absolute name replaces the folder
        if (is_readable(path)) return path.string();
    }
    throw std::runtime_error(fmt::format(
        "{}: found \"{}\", allowed: a file in one of the folders {} (the scene's, then "
        "those of RSH_SCENES and RSH_ASSETS)",
        where, name, fmt::join(folders, ", ")));
}

}  // namespace render
