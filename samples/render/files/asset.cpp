// asset.cpp - paths -> bytes, through libarchive. Reads a file or one member at a time and
// keeps no cache.
#include "files/asset.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "files/text_scan.hpp"

namespace render {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCompressed[] = {".xz", ".gz", ".bz2", ".zst"};
constexpr const char* kArchives[] = {".tar.xz",  ".tar.gz", ".tgz", ".tar.bz2",
                                     ".tar.zst", ".tar",    ".zip"};

// No scene of the field needs this much.
constexpr size_t kMaxBytes = size_t{4} << 30;

// A few bytes can unpack to any amount. Meshes pack to a hundredth at best, so what unpacks to more
// than a thousandfold, and is large, is no mesh.
constexpr size_t kMaxUnpackedRatio = 1000;
constexpr size_t kSmallBytes = size_t{256} << 20;

size_t most_unpacked(const std::string& container) {
    const size_t by_ratio = kMaxUnpackedRatio * std::filesystem::file_size(container);
    return std::min(kMaxBytes, std::max(kSmallBytes, by_ratio));
}

struct CloseArchive {
    void operator()(archive* a) const { archive_read_free(a); }
};
using Archive = std::unique_ptr<archive, CloseArchive>;

bool is_file(const std::string& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

bool ends_with(const std::string& text, const std::string& ending) {
    return text.size() > ending.size() &&
           lower_case(text.substr(text.size() - ending.size())) == ending;
}

bool is_archive(const std::string& path) {
    for (const char* ending : kArchives)
        if (ends_with(path, ending)) return true;
    return false;
}

bool is_compressed(const std::string& path) {
    for (const char* ending : kCompressed)
        if (ends_with(path, ending)) return true;
    return false;
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    throw LoadError(path + ": " + what);
}

std::string message_of(archive* a) {
    const char* text = archive_error_string(a);
    return text ? text : "not an archive or a compressed file";
}

Archive open_archive(const std::string& path, bool as_single_file) {
    Archive a(archive_read_new());
    if (!a) fail(path, "libarchive has no memory");
    archive_read_support_filter_all(a.get());
    if (as_single_file)
        archive_read_support_format_raw(a.get());
    else
        archive_read_support_format_all(a.get());
    constexpr size_t kBlock = 1 << 16;
    if (archive_read_open_filename(a.get(), path.c_str(), kBlock) != ARCHIVE_OK)
        fail(path, message_of(a.get()));
    return a;
}

[[noreturn]] void fail_as_too_large(const std::string& location, size_t most) {
    fail(location, "unpacks to more than " + std::to_string(most) +
                       " bytes, the most that is read of a file of its size");
}

std::string read_entry(archive* a, const std::string& location, size_t most) {
    std::string bytes;
    char block[1 << 16];
    for (;;) {
        const auto got = archive_read_data(a, block, sizeof block);
        if (got < 0) fail(location, "cannot be unpacked: " + message_of(a));
        if (got == 0) return bytes;
        bytes.append(block, static_cast<size_t>(got));
        if (bytes.size() > most) fail_as_too_large(location, most);
    }
}

std::string member_name(const char* name) {
    return name ? fs::path(name).lexically_normal().generic_string() : std::string();
}

// The member's bytes; nothing when the archive has no such member.
std::optional<std::string> read_member(const std::string& path, const std::string& member) {
    const Archive a = open_archive(path, false);
    const std::string wanted = member_name(member.c_str());
    archive_entry* entry = nullptr;
    int status;
    const size_t most = most_unpacked(path);
    while ((status = archive_read_next_header(a.get(), &entry)) == ARCHIVE_OK) {
        if (member_name(archive_entry_pathname(entry)) == wanted)
            return read_entry(a.get(), path + ":" + member, most);
        // What is not wanted is unpacked too, on the way to the next header.
        const auto passed = static_cast<size_t>(archive_filter_bytes(a.get(), 0));
        const auto size = static_cast<size_t>(archive_entry_size(entry));
        if (passed > most || size > most - passed) fail_as_too_large(path, most);
    }
    if (status != ARCHIVE_EOF) fail(path, "cannot be unpacked: " + message_of(a.get()));
    return std::nullopt;
}

std::string read_compressed(const std::string& path) {
    const Archive a = open_archive(path, true);
    archive_entry* entry = nullptr;
    if (archive_read_next_header(a.get(), &entry) != ARCHIVE_OK)
        fail(path, "cannot be unpacked: " + message_of(a.get()));
    // libarchive hands on what no filter recognizes; the only "filter" then is the file itself.
    if (archive_filter_count(a.get()) < 2) fail(path, "cannot be unpacked: is not compressed");
    return read_entry(a.get(), path, most_unpacked(path));
}

std::string read_plain(const std::string& path) {
    const size_t size = fs::file_size(path);
    if (size > kMaxBytes)
        fail(path, "has " + std::to_string(size) + " bytes, the most that is read is " +
                       std::to_string(kMaxBytes));
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    if (size > 0) bytes << file.rdbuf();
    if (!file || !bytes) fail(path, "cannot be read");
    return bytes.str();
}

Asset read_existing(const std::string& path) {
    if (is_archive(path))
        fail(path, "is an archive; name the member to load, as in " + path + ":scene.obj");
    return {path, is_compressed(path) ? read_compressed(path) : read_plain(path)};
}

// Position of the colon between an archive that exists and its member; npos: there is none.
size_t member_colon(const std::string& path) {
    size_t colon = path.find(':');
    while (colon != std::string::npos && !is_file(path.substr(0, colon)))
        colon = path.find(':', colon + 1);
    return colon;
}

std::optional<Asset> read_from_archive_of_same_name(const std::string& path) {
    for (const char* ending : kArchives) {
        const std::string candidate = fs::path(path).replace_extension(ending).string();
        if (!is_file(candidate)) continue;
        const std::string member = fs::path(path).filename().string();
        if (auto bytes = read_member(candidate, member))
            return Asset{candidate + ":" + member, std::move(*bytes)};
    }
    return std::nullopt;
}

// Of the names that differ from `wanted` in case only, the first in order; empty: there is none.
std::string find_spelling(const std::vector<std::string>& names, const std::string& wanted) {
    std::string found;
    for (const std::string& name : names)
        if (lower_case(name) == lower_case(wanted) && (found.empty() || name < found))
            found = name;
    return found;
}

std::vector<std::string> names_in_folder(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end;
         !error && entry != end; entry.increment(error)) {
        names.push_back(entry->path().filename().string());
        const std::string name = names.back();
        for (const char* ending : kCompressed)
            if (ends_with(name, ending))
                names.push_back(name.substr(0, name.size() - std::strlen(ending)));
    }
    return names;
}

std::optional<std::string> find_in_folders(const std::string& path) {
    fs::path found;
    for (const fs::path& part : fs::path(path)) {
        std::error_code ignored;
        fs::path next = found / part;
        if (!fs::exists(next, ignored)) {
            const std::string name = find_spelling(names_in_folder(found), part.string());
            if (name.empty()) return std::nullopt;
            next = found / name;
        }
        found = next;
    }
    std::error_code ignored;
    if (fs::is_directory(found, ignored)) return std::nullopt;
    return found.string();
}

std::vector<std::string> names_in_archive(const std::string& path) {
    const Archive a = open_archive(path, false);
    std::vector<std::string> names;
    archive_entry* entry = nullptr;
    while (archive_read_next_header(a.get(), &entry) == ARCHIVE_OK)
        names.push_back(member_name(archive_entry_pathname(entry)));
    return names;
}

std::optional<std::string> find_in_archive(const std::string& archive,
                                           const std::string& member) {
    const std::string wanted = member_name(member.c_str());
    const std::vector<std::string> names = names_in_archive(archive);
    const bool is_exact = std::find(names.begin(), names.end(), wanted) != names.end();
    const std::string name = is_exact ? wanted : find_spelling(names, wanted);
    if (name.empty()) return std::nullopt;
    return archive + ":" + name;
}

std::optional<std::string> find_in_archive_of_same_name(const std::string& path) {
    for (const char* ending : kArchives) {
        const std::string candidate = fs::path(path).replace_extension(ending).string();
        if (!is_file(candidate)) continue;
        if (auto found = find_in_archive(candidate, fs::path(path).filename().string()))
            return found;
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> find_asset(const std::string& path) {
    if (is_file(path)) return path;
    const size_t colon = member_colon(path);
    if (colon != std::string::npos)
        return find_in_archive(path.substr(0, colon), path.substr(colon + 1));
    auto found = find_in_folders(path);
    return found ? found : find_in_archive_of_same_name(path);
}

Asset read_asset(const std::string& path) {
    if (is_file(path)) return read_existing(path);
    std::error_code ignored;  // of a name that is too long, say
    if (fs::is_directory(path, ignored)) fail(path, "is a directory, not a file");
    const size_t colon = member_colon(path);
    if (colon != std::string::npos) {
        const std::string container = path.substr(0, colon);
        if (auto bytes = read_member(container, path.substr(colon + 1)))
            return {path, std::move(*bytes)};
        fail(container, "has no member " + path.substr(colon + 1));
    }
    for (const char* ending : kCompressed)
        if (is_file(path + ending)) return read_existing(path + ending);
    if (auto found = read_from_archive_of_same_name(path)) return std::move(*found);
    fail(path, "does not exist, neither as a file nor compressed nor in an archive beside it");
}

std::string sibling_path(const std::string& location, const std::string& name) {
    if (fs::path(name).is_absolute()) return name;
    const size_t colon = member_colon(location);
    const size_t start = colon == std::string::npos ? 0 : colon + 1;
    const fs::path folder = fs::path(location.substr(start)).parent_path();
    return location.substr(0, start) + (folder / name).lexically_normal().generic_string();
}

std::string inner_extension(const std::string& location) {
    fs::path path = location;
    if (is_compressed(location) && !is_archive(location)) path = path.stem();
    const std::string dotted = path.extension().string();
    return dotted.empty() ? std::string() : lower_case(dotted.substr(1));
}

}  // namespace render
