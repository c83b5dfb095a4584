// whole_file_test.cpp - where files may be written, and what is there when writing fails.
#include "files/whole_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "temporary_folder.hpp"

namespace render {
namespace {

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

size_t files_in(const std::string& folder) {
    const std::filesystem::directory_iterator all(folder);
    return static_cast<size_t>(std::distance(begin(all), end(all)));
}

void put(const std::string& path, const std::string& bytes) {
    WholeFile file(path);
    file.write(bytes);
    file.commit();
}

std::string error_of(const std::string& path, const std::string& bytes = "new") {
    try {
        put(path, bytes);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

void expect_error(const std::string& path, const char* part) {
    const std::string message = error_of(path);
    EXPECT_EQ(message.find(path), 0u) << message;
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
    EXPECT_THROW(require_place(path), std::runtime_error) << path;
}

TEST(WholeFile, IsThereOnlyAfterCommit) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.png", "old");
    {
        WholeFile file(path);
        file.write("ne");
        file.write("w");
        EXPECT_EQ(content(path), "old");
        EXPECT_EQ(files_in(folder.path("")), 2u) << "the temporary file is beside it";
    }
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(files_in(folder.path("")), 1u) << "the temporary file is removed";
    put(path, "new");
    EXPECT_EQ(content(path), "new");
    put(folder.path("b.png"), "");
    EXPECT_EQ(files_in(folder.path("")), 2u);
}

TEST(WholeFile, KeepsTheModeOfWhatWasThere) {
    const TemporaryFolder folder;
    const auto mode = [](const std::string& path) {
        struct stat found {};
        EXPECT_EQ(stat(path.c_str(), &found), 0) << path;
        return found.st_mode & 07777;
    };
    const std::string path = folder.write("a.png", "old");
    for (const mode_t kept : {0600u, 0640u, 0666u}) {
        chmod(path.c_str(), kept);
        put(path, "new");
        EXPECT_EQ(mode(path), kept);
    }
    const mode_t before = umask(027);
    put(folder.path("b.png"), "new");
    umask(before);
    EXPECT_EQ(mode(folder.path("b.png")), 0640u);
}

TEST(WholeFile, ReplacesWhatALinkPointsTo) {
    const TemporaryFolder folder;
    folder.write("sub/a.png", "old");
    std::filesystem::create_symlink("sub/a.png", folder.path("one.png"));
    std::filesystem::create_symlink(folder.path("one.png"), folder.path("two.png"));
    put(folder.path("two.png"), "new");
    EXPECT_EQ(content(folder.path("sub/a.png")), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("two.png")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("one.png")));
    std::filesystem::create_symlink("sub/none.png", folder.path("dangling.png"));
    put(folder.path("dangling.png"), "first");
    EXPECT_EQ(content(folder.path("sub/none.png")), "first");
}

TEST(WholeFile, NamesWhatIsWrongWithAPath) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "old");
    expect_error(folder.path("none/a.png"), "folder");
    expect_error(file + "/a.png", "folder");
    expect_error(folder.path(""), "is a folder");
    expect_error(folder.path(std::string(300, 'a')), "too long");
    std::filesystem::create_symlink("loop", folder.path("loop"));
    expect_error(folder.path("loop"), "symbolic links");
    EXPECT_NE(error_of("").find("no name"), std::string::npos);
    if (geteuid() != 0) {
        chmod(file.c_str(), 0444);
        expect_error(file, "Permission denied");
        chmod(folder.path("").c_str(), 0555);
        expect_error(folder.path("a.png"), "may not be written to");
        chmod(folder.path("").c_str(), 0755);
    }
}

TEST(WholeFile, WritesIntoWhatIsNoFile) {
    const TemporaryFolder folder;
    const std::string pipe = folder.path("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string read;
    std::thread reader([&] { read = content(pipe); });
    put(pipe, "new");
    reader.join();
    EXPECT_EQ(read, "new");
    EXPECT_EQ(error_of("/dev/null"), "");
    EXPECT_NE(error_of("/dev/full").find("No space left"), std::string::npos);
    EXPECT_EQ(files_in(folder.path("")), 1u);
}

// In a process of its own, whose files may have at most 64 KiB: as good as a full disk.
int status_on_a_full_disk(const std::string& path, size_t bytes) {
    const pid_t child = fork();
    if (child == 0) {
        const rlimit limit{65536, 65536};
        setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN);
        _exit(error_of(path, std::string(bytes, 'n')).find("untouched") != std::string::npos);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

TEST(WholeFile, AFullDiskLeavesTheOldFile) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.png", "old");
    EXPECT_EQ(WEXITSTATUS(status_on_a_full_disk(path, 65537)), 1);
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(files_in(folder.path("")), 1u);
    EXPECT_EQ(status_on_a_full_disk(path, 65536), 0);
    EXPECT_EQ(content(path).size(), 65536u);
}

}  // namespace
}  // namespace render
