// stream_files_test.cpp - streams in files: what they hold is read, and what is wrong with them is said.
#include <gtest/gtest.h>

#include <fstream>

#include "reduce/streams/bitmap.hpp"
#include "reduce/streams/stream_files.hpp"

namespace {

namespace fs = std::filesystem;
using bench::read_stream_file;
using Flags = std::vector<cl_uchar>;

// A folder of its own for each test.
class StreamFiles : public ::testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(::testing::TempDir()) /
                  ::testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path store(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    // What reading a file with these bytes is refused by, without the path.
    std::string refusal(const std::string& name, const std::string& bytes) const {
        const fs::path path = store(name, bytes);
        try {
            read_stream_file(path);
        } catch (const std::exception& error) {
            const std::string text = error.what(), begin = path.string() + ": ";
            EXPECT_EQ(text.rfind(begin, 0), 0u) << text;
            return text.substr(begin.size());
        }
        return "none";
    }

    fs::path folder_;
};

TEST_F(StreamFiles, FlagsAreABytePerElement) {
    EXPECT_EQ(read_stream_file(store("a.flags", std::string("\1\0\0\1", 4))),
              (Flags{1, 0, 0, 1}));
}

TEST_F(StreamFiles, FlagsAreNothingElse) {
    EXPECT_EQ(refusal("a.flags", std::string("\1\0\2", 3)), "byte 2 is 2, must be 0 or 1");
    EXPECT_EQ(refusal("b.flags", ""),
              "is 0 bytes long, must be 1 for each of 1 to 2147483648 elements");
}

TEST_F(StreamFiles, PairsComeBackAsTheyWereWritten) {
    const fs::path path = folder_ / "a.pairs";
    bench::write_pairs(path,
                       {{7, 0x01020304}, {RSH_NO_HIT, 9}, {0xffffff, 1}, {0, RSH_NO_HIT}});
    EXPECT_EQ(read_stream_file(path), (Flags{1, 0, 1, 1}));
    EXPECT_TRUE(bench::has_pairs(path));
    std::ifstream file(path, std::ios::binary);
    std::string bytes(12, ' ');
    file.read(bytes.data(), 12);
    EXPECT_EQ(bytes, std::string("\7\0\0\0\4\3\2\1\xff\xff\xff\xff", 12));
}

TEST_F(StreamFiles, PairsAreWhole) {
    EXPECT_EQ(refusal("a.pairs", std::string(20, '\0')),
              "is 20 bytes long, must be 8 for each of 1 to 2147483648 elements");
    EXPECT_EQ(refusal("b.pairs", ""),
              "is 0 bytes long, must be 8 for each of 1 to 2147483648 elements");
}

TEST_F(StreamFiles, BitsAreRowsPaddedToBytes) {
    EXPECT_EQ(read_stream_file(store("a.pbm", "P4 # made by hand\n10 2\n\xc0\x40\x01\x80")),
              (Flags{1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0}));
}

TEST_F(StreamFiles, GreyIsKeptUnlessItIsBlack) {
    EXPECT_EQ(read_stream_file(store("a.pgm", std::string("P5\n3 1\n255\n\0\1\xff", 14))),
              (Flags{0, 1, 1}));
}

TEST_F(StreamFiles, BitmapsThatAreNoneAreRefused) {
    EXPECT_EQ(refusal("a.pbm", "P6\n1 1\n255\nabc"),
              "begins with \"P6\", must be a bitmap: P4 or P5");
    EXPECT_EQ(refusal("b.pbm", ""), "begins with \"\", must be a bitmap: P4 or P5");
    EXPECT_EQ(refusal("c.pbm", "P4\n0 1\n"), "width is \"0\", must be 1 to 2147483648");
    EXPECT_EQ(refusal("d.pbm", "P4\n8 -1\n"), "height is \"-1\", must be 1 to 268435456");
    EXPECT_EQ(refusal("e.pgm", "P5\n1 1\n65535\nab"),
              "highest value is \"65535\", must be 1 to 255");
    EXPECT_EQ(refusal("f.pbm", "P4\n16 2\nabc"), "has 3 bytes behind its head, must have 4");
}

TEST_F(StreamFiles, AreFoundByTheirNames) {
    EXPECT_THROW(bench::find_stream_files(folder_ / "none"), std::runtime_error);
    store("README.md", "no stream");
    EXPECT_THROW(bench::find_stream_files(folder_), std::runtime_error);
    for (const char* name : {"b.flags", "d.pgm", "a.pairs", "c.pbm"}) store(name, "");
    std::string names;
    for (const fs::path& path : bench::find_stream_files(folder_))
        names += path.filename().string() + ' ';
    EXPECT_EQ(names, "a.pairs b.flags c.pbm d.pgm ");
}

}  // namespace
