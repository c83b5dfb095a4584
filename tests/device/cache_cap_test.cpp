// cache_cap_test.cpp - what programs on disk may take together: those used least recently go, no
// other file does, and nobody who uses the folder at the same time is misled.
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>

#include "api/valid_calls.hpp"
#include "device/cache_folders.hpp"

namespace {

namespace fs = std::filesystem;
using rsh::BinaryCache;
using std::chrono::hours;
using test::Binary;
using test::kBinary;
using test::overwrite;
using test::set_age;

class CacheCap : public test::CacheFolders {};

TEST_F(CacheCap, EvictsWhatWasUsedLeastRecently) {
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

// Within one second, which is what a start takes that compiles: nothing is set back.
TEST_F(CacheCap, TellsWhichOfTwoFilesOfASecondWasUsedLater) {
    for (const char* key : {"a", "b", "c"}) store_later(key);
    const uint64_t bytes = fs::file_size(file_of("a"));
    std::this_thread::sleep_for(kTick);
    EXPECT_TRUE(cache().load("a"));
    std::this_thread::sleep_for(kTick);
    cache(2 * bytes).store("d", kBinary);
    EXPECT_EQ(kept({"a", "b", "c", "d"}), (Keys{"a", "d"}));
}

TEST_F(CacheCap, StoresNothingThatIsLargerThanItsCap) {
    for (const char* key : {"a", "b"}) store_later(key);
    const uint64_t bytes = fs::file_size(file_of("a"));
    cache(bytes - 1).store("c", kBinary);
    EXPECT_EQ(kept({"a", "b", "c"}), (Keys{"a", "b"})) << "and removes nothing for it";
    cache(bytes).store("c", kBinary);
    EXPECT_EQ(kept({"a", "b", "c"}), (Keys{"c"}));
}

// What a context with a larger cap stored is not refused.
TEST_F(CacheCap, LoadsAFileThatIsLargerThanItsCap) {
    cache().store("key", kBinary);
    EXPECT_TRUE(cache(1).load("key"));
    EXPECT_TRUE(fs::exists(file_of("key")));
}

TEST_F(CacheCap, EvictsNoFileThatIsNotItsOwn) {
    cache().store("key", kBinary);
    const fs::path made = folder_ / "made";
    const std::vector<fs::path> foreign = {
        made / "notes.rshbin", made / "0123.rshbin", made / "letter.txt",
        made / (file_of("key").filename().string() + ".bak")};
    for (const fs::path& path : foreign) overwrite(path, std::string(1000, 'x'));
    for (const fs::path& path : foreign) set_age(path, hours(2));
    cache(fs::file_size(file_of("key"))).store("other", kBinary);
    for (const fs::path& path : foreign) EXPECT_TRUE(fs::exists(path)) << path;
    EXPECT_EQ(kept({"key", "other"}), (Keys{"other"}));
}

// What `i` of `kHands` does: stores and loads under a cap that holds a few files of all.
bool store_and_load(const std::string& folder, uint64_t max_bytes, int i) {
    BinaryCache mine(folder, {nullptr, nullptr}, max_bytes);
    for (int round = 0; round < 40; ++round) {
        const int number = (round * 7 + i * 5) % 12;
        const Binary binary(20, static_cast<unsigned char>(number));
        const auto found = mine.load(std::to_string(number));
        if (found && *found != binary) return false;
        if (!found) mine.store(std::to_string(number), binary);
    }
    return true;
}

TEST_F(CacheCap, IsRightAndWithinItsCapWithThreadsAndProcessesAtOnce) {
    const std::string folder = (folder_ / "made").string();
    cache().store("0", Binary(20, 0));
    const uint64_t cap = 4 * fs::file_size(file_of("0"));
    std::vector<pid_t> processes;
    for (int i = 0; i < 2; ++i) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) _exit(store_and_load(folder, cap, i) ? 0 : 1);
        processes.push_back(child);
    }
    std::vector<std::thread> threads;
    std::atomic<int> right{0};
    for (int i = 2; i < 4; ++i)
        threads.emplace_back([&, i] { right += store_and_load(folder, cap, i); });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(right, 2);
    for (const pid_t child : processes) {
        int status = -1;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        EXPECT_EQ(status, 0) << "what was loaded is not what was stored";
    }
    cache(cap).store("last", kBinary);
    uint64_t total = 0;
    for (const auto& entry : fs::directory_iterator(folder)) total += entry.file_size();
    EXPECT_LE(total, cap);
    EXPECT_TRUE(cache().load("last"));
}

// What a context leaves in a folder that compiles a program which takes long.
uint64_t bytes_stored(const fs::path& folder, cl_ulong cache_bytes) {
    const std::string path = folder.string();
    rsh_context_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.context = test::device().context();
    desc.device = test::device().device();
    desc.cache_dir = path.c_str();
    desc.cache_bytes = cache_bytes;
    rsh_context context = nullptr;
    RSH_CHECK(rsh_create_context(&desc, &context));
    const test::ValidCalls valid;
    const rsh_shade_desc shade = valid.shade();
    RSH_CHECK(rsh_shade(context, test::device().queue(), &shade, 0, nullptr, nullptr));
    test::device().queue.finish();
    rsh_release_context(context);
    uint64_t bytes = 0;
    if (fs::exists(folder))
        for (const auto& entry : fs::directory_iterator(folder)) bytes += entry.file_size();
    return bytes;
}

// A driver that keeps what it compiles leaves the folder empty; ctest runs this once with one that
// keeps nothing.
TEST_F(CacheCap, OfAContextIsThatOfItsDescriptor) {
    // Drivers start their compilers with the first program, which then takes longer than a second time.
    cl::Program(test::device().context, "kernel void nothing() {}").build();
    EXPECT_EQ(bytes_stored(folder_ / "small", 1), 0u);
    if (std::getenv("RSH_TEST_DRIVER_KEEPS_NOTHING")) {
        EXPECT_GT(bytes_stored(folder_ / "default", 0), 0u);
    }
}

}  // namespace
