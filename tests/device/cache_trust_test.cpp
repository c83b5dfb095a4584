// cache_trust_test.cpp - what the cache of programs does not take, because others may have written
// it, or because it is not what was stored: it goes on without, says why once, and mends the file.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "api/valid_calls.hpp"
#include "device/programs/binary_cache.hpp"

namespace {

namespace fs = std::filesystem;
using rsh::BinaryCache;

using Binary = std::vector<unsigned char>;
const Binary kBinary(1000, 7);
constexpr uid_t kNobody = 65534;

using Lines = std::vector<std::string>;

void keep_line(const char* message, void* lines) {
    static_cast<Lines*>(lines)->emplace_back(message);
}

mode_t mode_of(const fs::path& path) {
    struct stat found = {};
    EXPECT_EQ(lstat(path.c_str(), &found), 0) << path;
    return found.st_mode & 07777;
}

void overwrite(const fs::path& path, const std::string& data) {
    std::ofstream(path, std::ios::binary) << data;
}

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class CacheTrust : public ::testing::Test {
protected:
    CacheTrust()
        : above_(fs::temp_directory_path() /
                 ("rsh-cache-trust-" + std::to_string(std::random_device{}()))),
          folder_(above_ / "cache") {
        fs::create_directory(above_);
    }
    ~CacheTrust() override {
        std::error_code ignored;
        fs::remove_all(above_, ignored);
    }

    BinaryCache cache() { return BinaryCache(folder_.string(), {keep_line, &lines_}); }

    // The file that holds the one program there is.
    fs::path stored() {
        cache().store("key", kBinary);
        return fs::directory_iterator(folder_)->path();
    }

    // One line, with the path and the reason.
    void expect_told(const fs::path& path, const std::string& reason) {
        ASSERT_EQ(lines_.size(), 1u) << reason;
        for (const std::string& part : {std::string("program cache: "), path.string(), reason})
            EXPECT_NE(lines_[0].find(part), std::string::npos) << part << " in " << lines_[0];
    }

    Lines lines_;
    fs::path above_, folder_;
};

struct Spoiling {
    const char* name;
    std::function<void(const fs::path&)> spoil;  // the file
    const char* reason;
};

void replace_by(const fs::path& path, const std::function<void()>& make) {
    fs::remove(path);
    make();
}

std::vector<Spoiling> spoilings() {
    return {
        {"a FIFO", [](const fs::path& p) { replace_by(p, [&] { mkfifo(p.c_str(), 0600); }); },
         "no regular file"},
        {"a link to a device",
         [](const fs::path& p) { replace_by(p, [&] { fs::create_symlink("/dev/zero", p); }); },
         "symbolic link"},
        {"a link to what was stored",
         [](const fs::path& p) {
             fs::rename(p, p.string() + ".moved");
             fs::create_symlink(p.string() + ".moved", p);
         },
         "symbolic link"},
        {"a folder", [](const fs::path& p) { replace_by(p, [&] { fs::create_directory(p); }); },
         "no regular file"},
        {"a folder with a file",
         [](const fs::path& p) {
             replace_by(p, [&] {
                 fs::create_directory(p);
                 overwrite(p / "file", "x");
             });
         },
         "no regular file"},
        {"empty", [](const fs::path& p) { fs::resize_file(p, 0); }, "not what was stored"},
        {"half", [](const fs::path& p) { fs::resize_file(p, fs::file_size(p) / 2); },
         "not what was stored"},
        {"garbage", [](const fs::path& p) { overwrite(p, std::string(5000, '\x7f')); },
         "not what was stored"},
        {"longer", [](const fs::path& p) { overwrite(p, contents(p) + "x"); },
         "not what was stored"},
        {"too large", [](const fs::path& p) { fs::resize_file(p, uint64_t{1} << 40); },
         "must have at most"},
        {"writable by the group", [](const fs::path& p) { chmod(p.c_str(), 0620); },
         "writable by others"},
        {"writable by all", [](const fs::path& p) { chmod(p.c_str(), 0602); },
         "writable by others"},
    };
}

TEST_F(CacheTrust, RefusesEachFileThatIsNotWhatWasStoredAndMendsIt) {
    for (const Spoiling& spoiling : spoilings()) {
        SCOPED_TRACE(spoiling.name);
        fs::remove_all(folder_);
        const fs::path path = stored();
        spoiling.spoil(path);
        lines_.clear();
        BinaryCache own(folder_.string(), {keep_line, &lines_});
        const auto start = std::chrono::steady_clock::now();
        EXPECT_FALSE(own.load("key"));
        EXPECT_FALSE(own.load("key"));
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
        expect_told(path, spoiling.reason);
        own.store("key", kBinary);
        EXPECT_EQ(own.load("key"), kBinary);
        EXPECT_EQ(mode_of(path), 0600u);
        EXPECT_EQ(lines_.size(), 1u) << "told again";
    }
}

TEST_F(CacheTrust, RefusesTheFileOfAnotherKey) {
    const fs::path path = stored();
    const std::string of_key = contents(path);
    cache().store("other", Binary(1000, 8));
    for (const auto& entry : fs::directory_iterator(folder_)) overwrite(entry.path(), of_key);
    EXPECT_FALSE(cache().load("other"));
    EXPECT_EQ(cache().load("key"), kBinary);
}

// "ab" + "c" is not "a" + "bc".
TEST_F(CacheTrust, TellsWhereTheKeyEnds) {
    const fs::path path = stored();
    const std::string whole = contents(path);
    cache().store("ke", Binary{'y'});
    cache().store("key", kBinary);
    Binary longer = kBinary;
    longer.insert(longer.begin(), 'y');
    EXPECT_EQ(contents(path), whole);
    for (const auto& entry : fs::directory_iterator(folder_))
        if (entry.path() != path)
            overwrite(entry.path(), whole.substr(0, 40) + 'y' + whole.substr(40));
    EXPECT_FALSE(cache().load("ke"));
}

TEST_F(CacheTrust, RefusesWhatBelongsToAnother) {
    if (geteuid() != 0) {  // only root can give a file away
        BinaryCache roots("/", {keep_line, &lines_});
        EXPECT_FALSE(roots.load("key"));
        return expect_told("/", "belongs to the user 0");
    }
    const fs::path path = stored();
    ASSERT_EQ(chown(path.c_str(), kNobody, kNobody), 0);
    EXPECT_FALSE(cache().load("key"));
    expect_told(path, "belongs to the user 65534");
    lines_.clear();
    stored();
    ASSERT_EQ(chown(folder_.c_str(), kNobody, kNobody), 0);
    EXPECT_FALSE(cache().load("key"));
    expect_told(folder_, "belongs to the user 65534");
}

TEST_F(CacheTrust, RefusesAFolderThatOthersMayWriteTo) {
    const fs::path path = stored();
    for (const mode_t mode : {0770, 0707, 0777, 01777, 02775}) {
        ASSERT_EQ(chmod(folder_.c_str(), mode), 0);
        lines_.clear();
        BinaryCache own(folder_.string(), {keep_line, &lines_});
        EXPECT_FALSE(own.load("key"));
        EXPECT_FALSE(own.load("other"));
        own.store("other", kBinary);
        expect_told(folder_, "writable by others");
        EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "it was written to";
        EXPECT_TRUE(fs::exists(path)) << "it may be another's";
    }
    ASSERT_EQ(chmod(folder_.c_str(), 0755), 0);
    EXPECT_EQ(cache().load("key"), kBinary) << "that others read it is no harm";
}

TEST_F(CacheTrust, RefusesAFileInPlaceOfTheFolder) {
    overwrite(folder_, "a file");
    BinaryCache own(folder_.string(), {keep_line, &lines_});
    EXPECT_FALSE(own.load("key"));
    own.store("key", kBinary);
    expect_told(folder_, "cannot be opened");
    EXPECT_EQ(contents(folder_), "a file");
}

TEST_F(CacheTrust, SaysNothingOfWhatIsNotThere) {
    EXPECT_FALSE(cache().load("key"));
    stored();
    EXPECT_FALSE(cache().load("other"));
    EXPECT_TRUE(lines_.empty()) << lines_[0];
}

TEST_F(CacheTrust, MakesItsFoldersForTheUserAlone) {
    const mode_t before = umask(0);
    BinaryCache((folder_ / "below").string()).store("key", kBinary);
    umask(before);
    EXPECT_EQ(mode_of(folder_), 0700u);
    EXPECT_EQ(mode_of(folder_ / "below"), 0700u);
    EXPECT_EQ(mode_of(fs::directory_iterator(folder_ / "below")->path()), 0600u);
}

TEST_F(CacheTrust, IgnoresARelativeHomeOfCaches) {
    const char* const names[] = {"RSH_CACHE_DIR", "XDG_CACHE_HOME", "HOME"};
    std::vector<std::optional<std::string>> before;
    for (const char* name : names)
        before.push_back(getenv(name) ? std::optional<std::string>(getenv(name))
                                      : std::nullopt);
    unsetenv("RSH_CACHE_DIR");
    setenv("HOME", "/home/me", 1);
    setenv("XDG_CACHE_HOME", "caches", 1);
    EXPECT_EQ(BinaryCache::folder_for(nullptr), "/home/me/.cache/rsh");
    setenv("XDG_CACHE_HOME", "/caches", 1);
    EXPECT_EQ(BinaryCache::folder_for(nullptr), "/caches/rsh");
    setenv("RSH_CACHE_DIR", "", 1);
    EXPECT_EQ(BinaryCache::folder_for(nullptr), "");
    EXPECT_EQ(BinaryCache::folder_for("/given"), "/given");
    for (size_t i = 0; i < std::size(names); ++i)
        before[i] ? setenv(names[i], before[i]->c_str(), 1) : unsetenv(names[i]);
}

// The whole way: a context with such a folder compiles, says so once, and gives the right answer.
TEST_F(CacheTrust, OfAContextIsToldOnceThroughItsLog) {
    stored();
    ASSERT_EQ(chmod(folder_.c_str(), 0777), 0);
    lines_.clear();
    rsh_context_desc desc = {};
    desc.struct_size = sizeof desc;
    desc.context = test::device().context();
    desc.device = test::device().device();
    const std::string folder = folder_.string();
    desc.cache_dir = folder.c_str();
    desc.log = keep_line;
    desc.log_user = &lines_;
    rsh_context context = nullptr;
    RSH_CHECK(rsh_create_context(&desc, &context));
    const test::ValidCalls valid;
    for (const cl_uint strategy : {RSH_STRATEGY_CHUNK, RSH_STRATEGY_ATOMIC}) {
        rsh_reduce_desc reduce = valid.reduce();
        reduce.strategy = strategy;
        RSH_CHECK(rsh_reduce(context, test::device().queue(), &reduce, 0, nullptr, nullptr));
        test::device().queue.finish();
        EXPECT_EQ(valid.count.read()[0], 1024u);
    }
    rsh_release_context(context);
    const auto told = std::count_if(lines_.begin(), lines_.end(), [](const std::string& line) {
        return line.find("program cache: ") == 0;
    });
    EXPECT_EQ(told, 1) << testing::PrintToString(lines_);
}

}  // namespace
