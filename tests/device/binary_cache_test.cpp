// binary_cache_test.cpp - programs on disk: what was stored comes back, anything else is as good as
// nothing, and no failure gets out.
#include "device/cache_folders.hpp"

namespace {

namespace fs = std::filesystem;
using rsh::BinaryCache;
using std::chrono::hours;
using test::Binary;
using test::contents;
using test::kBinary;
using test::overwrite;
using test::set_age;

class BinaryCacheTest : public test::CacheFolders {};

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

TEST_F(BinaryCacheTest, EvictsItsOwnTemporaryFilesAfterAnHour) {
    cache().store("key", kBinary);
    const fs::path made = folder_ / "made";
    const std::string name = file_of("key").string();
    const fs::path orphan = name + ".4711.0.tmp";
    const fs::path young = name + ".4711.1.tmp";
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
