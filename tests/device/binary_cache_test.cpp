// binary_cache_test.cpp - programs on disk: what was stored comes back, anything else is as good as
// nothing, and no failure gets out.
#include "device/programs/binary_cache.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>

namespace {

namespace fs = std::filesystem;
using rsh::BinaryCache;
using std::chrono::hours;

using Binary = std::vector<unsigned char>;
const Binary kBinary = {1, 2, 3, 0, 255, 7};

class BinaryCacheTest : public ::testing::Test {
protected:
    BinaryCacheTest()
        : folder_(fs::temp_directory_path() /
                  ("rsh-binary-cache-" + std::to_string(std::random_device{}()))) {}
    ~BinaryCacheTest() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    BinaryCache cache(uint64_t max_bytes = BinaryCache::kMaxBytes) const {
        return BinaryCache((folder_ / "made").string(), {nullptr, nullptr}, max_bytes);
    }

    // The file that storing `key` makes.
    fs::path file_of(const std::string& key) const {
        const std::string other = (folder_ / "other").string();
        BinaryCache(other).store(key, kBinary);
        const fs::path name = fs::directory_iterator(other)->path().filename();
        fs::remove_all(other);
        return folder_ / "made" / name;
    }

    fs::path folder_;
};

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void overwrite(const fs::path& path, const std::string& data) {
    std::ofstream(path, std::ios::binary) << data;
}

void set_age(const fs::path& path, hours age) {
    fs::last_write_time(path, fs::file_time_type::clock::now() - age);
}

TEST_F(BinaryCacheTest, FindsInAnotherProcessWhatWasStored) {
    EXPECT_FALSE(cache().load("key"));
    cache().store("key", kBinary);
    ASSERT_TRUE(cache().load("key"));
    EXPECT_EQ(*cache().load("key"), kBinary);
    cache().store("key", {9});
    EXPECT_EQ(cache().load("key"), Binary{9});
}

TEST_F(BinaryCacheTest, ComparesTheKeyAndNotOnlyTheName) {
    cache().store("key", kBinary);
    EXPECT_FALSE(cache().load("kez"));
    cache().store("kez", {9});
    overwrite(file_of("kez"), contents(file_of("key")));  // as if the hashes were the same
    EXPECT_FALSE(cache().load("kez"));
}

TEST_F(BinaryCacheTest, IgnoresAFileOfAnyOtherLength) {
    cache().store("key", kBinary);
    const fs::path path = file_of("key");
    const std::string whole = contents(path);
    ASSERT_GT(whole.size(), kBinary.size());
    for (size_t length = 0; length < whole.size(); ++length) {
        cache().store("key", kBinary);
        overwrite(path, whole.substr(0, length));
        EXPECT_FALSE(cache().load("key")) << length << " of " << whole.size() << " bytes";
    }
    overwrite(path, whole + '\0');
    EXPECT_FALSE(cache().load("key"));
    overwrite(path, whole);
    EXPECT_TRUE(cache().load("key"));
}

TEST_F(BinaryCacheTest, IgnoresAFileWithAnyOtherByte) {
    cache().store("key", kBinary);
    const fs::path path = file_of("key");
    const std::string whole = contents(path);
    for (size_t i = 0; i < whole.size(); ++i) {
        std::string wrong = whole;
        wrong[i] = char(wrong[i] ^ 0x10);
        overwrite(path, wrong);
        EXPECT_FALSE(cache().load("key")) << "byte " << i;
    }
}

TEST_F(BinaryCacheTest, EvictsWhatWasUsedLeastRecentlyAboveItsCap) {
    cache().store("a", kBinary);
    const uint64_t bytes = fs::file_size(file_of("a"));
    for (const char* key : {"b", "c"}) cache().store(key, kBinary);
    set_age(file_of("a"), hours(4));
    set_age(file_of("b"), hours(3));
    set_age(file_of("c"), hours(2));
    EXPECT_TRUE(cache().load("a")) << "and so it is the one used last";
    cache(4 * bytes).store("d", kBinary);
    for (const char* key : {"a", "b", "c", "d"}) EXPECT_TRUE(fs::exists(file_of(key))) << key;
    cache(3 * bytes).store("d", kBinary);
    EXPECT_FALSE(fs::exists(file_of("b")));
    for (const char* key : {"a", "c", "d"}) EXPECT_TRUE(fs::exists(file_of(key))) << key;
}

TEST_F(BinaryCacheTest, EvictsItsOwnTemporaryFilesAfterAnHour) {
    cache().store("key", kBinary);
    const fs::path made = folder_ / "made";
    const fs::path orphan = made / "0123456789abcdef.rshbin.4711.0.tmp";
    const fs::path young = made / "0123456789abcdef.rshbin.4711.1.tmp";
    const fs::path foreign = made / "letter.tmp";
    for (const fs::path& path : {orphan, young, foreign}) overwrite(path, "half");
    for (const fs::path& path : {orphan, foreign}) set_age(path, hours(2));
    cache().store("key", kBinary);
    EXPECT_FALSE(fs::exists(orphan));
    EXPECT_TRUE(fs::exists(young)) << "it is being written";
    EXPECT_TRUE(fs::exists(foreign)) << "it is not ours";
    EXPECT_TRUE(cache().load("key"));
}

TEST_F(BinaryCacheTest, LeavesNoTemporaryFileBehind) {
    cache().store("key", kBinary);
    EXPECT_FALSE(fs::is_empty(folder_ / "made"));
    for (const auto& entry : fs::directory_iterator(folder_ / "made"))
        EXPECT_EQ(entry.path().extension(), ".rshbin") << entry.path();
}

// Below a file no folder can be made, whoever the user is.
TEST_F(BinaryCacheTest, DoesWithoutAFolderThatCannotBeMade) {
    fs::create_directories(folder_);
    overwrite(folder_ / "made", "a file");
    BinaryCache below((folder_ / "made" / "below").string());
    EXPECT_NO_THROW(below.store("key", kBinary));
    EXPECT_FALSE(below.load("key"));
    EXPECT_EQ(contents(folder_ / "made"), "a file");
}

TEST_F(BinaryCacheTest, IsOffWithoutAFolder) {
    BinaryCache off("");
    off.store("key", kBinary);
    EXPECT_FALSE(off.load("key"));
}

}  // namespace
