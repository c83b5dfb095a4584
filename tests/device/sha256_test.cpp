// sha256_test.cpp - the vectors that NIST publishes with FIPS 180-4, however they are cut.
#include "device/programs/sha256.hpp"

#include <gtest/gtest.h>

namespace {

std::string digest_of(const std::string& text, size_t step) {
    rsh::Sha256 sum;
    for (size_t at = 0; at < text.size(); at += step)
        sum.add(text.data() + at, std::min(step, text.size() - at));
    return rsh::hexadecimal(sum.digest());
}

struct Vector {
    std::string text;
    const char* digest;
};

TEST(Sha256, GivesThePublishedDigests) {
    const Vector vectors[] = {
        {"", "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"},
        {"abc", "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"},
        {"abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq",
         "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"},
        {"abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqklmno"
         "pqr"
         "lmnopqrsmnopqrstnopqrstu",
         "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1"},
        {std::string(1000000, 'a'),
         "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"}};
    for (const Vector& vector : vectors)
        for (const size_t step : {1, 3, 64, 100, 1000000})
            EXPECT_EQ(digest_of(vector.text, step), vector.digest)
                << vector.text.size() << " bytes, " << step << " at a time";
}

// The ends of blocks, and of the room that the length takes in the last one.
TEST(Sha256, DependsOnEachByteAtTheEndsOfBlocks) {
    for (const size_t bytes : {54, 55, 56, 57, 63, 64, 65, 119, 120, 128}) {
        std::string text(bytes, 'x');
        const std::string whole = digest_of(text, 7);
        EXPECT_EQ(whole, digest_of(text, bytes));
        EXPECT_NE(whole, digest_of(text + 'x', bytes)) << bytes;
        text.back() = 'y';
        EXPECT_NE(whole, digest_of(text, bytes)) << bytes;
    }
}

}  // namespace
