// temporary_folder.cpp - files and archives for tests, through libarchive's writer.
#include "temporary_folder.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "files/text_scan.hpp"
#include "import/mesh_file.hpp"

namespace render {
namespace {

void add_entry(archive* a, const std::string& name, const std::string& bytes) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(bytes.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_write_header(a, entry);
    archive_write_data(a, bytes.data(), bytes.size());
    archive_entry_free(entry);
}

void write_archive(const std::string& path, bool is_raw,
                   const std::map<std::string, std::string>& members) {
    archive* a = archive_write_new();
    archive_write_add_filter_xz(a);
    if (is_raw)
        archive_write_set_format_raw(a);
    else
        archive_write_set_format_ustar(a);
    archive_write_open_filename(a, path.c_str());
    for (const auto& [name, bytes] : members) add_entry(a, name, bytes);
    EXPECT_EQ(archive_write_close(a), ARCHIVE_OK) << path;
    archive_write_free(a);
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("rsh_loader_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
}

std::string TemporaryFolder::write_xz(const std::string& name, const std::string& bytes) const {
    write_archive(path(name), true, {{"data", bytes}});
    return path(name);
}

std::string TemporaryFolder::write_tar_xz(
    const std::string& name, const std::map<std::string, std::string>& members) const {
    write_archive(path(name), false, members);
    return path(name);
}

std::string error_of_mesh(const std::string& path) {
    try {
        load_mesh(path);
    } catch (const LoadError& error) {
        return error.what();
    }
    ADD_FAILURE() << path << " loads, but must not";
    return {};
}

}  // namespace render
