// hostile_files_test.cpp - small files of every format, changed by chance: each loads, or ends in an
// error that names it, soon and within bounds. RSH_HOSTILE_FILES=N tries N of each (300).
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <random>

#include "import/mesh_file.hpp"
#include "import/model_bounds.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

struct Seed {
    const char* name;
    std::string bytes;
};

std::string stl_triangles(uint32_t count) {
    std::string bytes(80, ' ');
    bytes += bytes_of<uint32_t>({count});
    for (uint32_t i = 0; i < count; ++i)
        bytes +=
            bytes_of<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1.0f * i, 0}) + std::string(2, '\0');
    return bytes;
}

std::string ply(const std::string& format, const std::string& values) {
    return "ply\nformat " + format +
           " 1.0\ncomment TextureFile a.png\nelement vertex 4\nproperty float x\n"
           "property float y\nproperty float z\nproperty uchar red\nelement face 1\n"
           "property list uchar int vertex_indices\nproperty list uchar float texcoord\n"
           "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
           values;
}

std::string binary_ply_values() {
    std::string values;
    for (const float x : {0.0f, 1.0f, 2.0f, 3.0f})
        values += bytes_of<float>({x, x * x, 0}) + '\x7f';
    values += '\4' + bytes_of<uint32_t>({0, 1, 2, 3}) + '\2' + bytes_of<float>({0, 1});
    return values + bytes_of<int32_t>({5, 0, 1, 2, -1, 3});
}

const Seed kSeeds[] = {
    {"a.obj",
     "# made by hand\nmtllib a.mtl \"b c.mtl\"\no x\nv 0 0 0\nv 1 0 0 1\nv 1.5e0 +1 -.5\nv 0 1 "
     "0\n"
     "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nusemtl red\ns off\nf 1/1/1 2/2/1 3/3/1 4\nf -4//1 -3 "
     "\\\n"
     "-2\nusemtl gone\nf 1 2 3 # end\n"},
    {"a.mtl",
     "newmtl red\nKa 0 0 0\nKd .8 .1 .1\nKs 1 1 1\nNs 50\nNi 1.5\nd 0.5\nTr 0.5\nTf 1 1 "
     "1\nillum 7\n"
     "map_Kd -s 4 1 1 -o 0 0 0 -clamp on -bm 1 maps\\a b.png\nnewmtl green\nKd 0 1\n"},
    {"a.off", "OFF\n# counts\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3\n"},
    {"b.off",
     "STCNOFF 4 1 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 1 1 1 1 0 0\n"
     "1 1 0 0 0 1 1 1 1 1 0 0\n0 1 0 0 0 1 1 1 1 1 0 0\n4 0 1 2 3\n"},
    {"c.off", "OFF BINARY\n" + std::string("\0\0\0\1\0\0\0\1\0\0\0\0", 12) +
                  std::string(12, '\0') + std::string("\0\0\0\3", 4) + std::string(16, '\0')},
    {"a.ply",
     ply("ascii", "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n4 0 1 2 3 2 0 1\n5 0 1 2 -1 3\n")},
    {"b.ply", ply("binary_little_endian", binary_ply_values())},
    {"c.ply", ply("binary_big_endian", binary_ply_values())},
    {"a.stl",
     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
     "endloop\nendfacet\nendsolid a\n"},
    {"b.stl", stl_triangles(3)}};

class Mutator {
public:
    explicit Mutator(uint32_t seed) : random_(seed) {}

    std::string operator()(std::string bytes) {
        for (size_t i = 1 + below(4); i > 0; --i) change(bytes);
        return bytes;
    }

private:
    size_t below(size_t end) { return end == 0 ? 0 : random_() % end; }

    std::string odd_word() {
        const std::string words[] = {"-1",
                                     "0",
                                     "4294967295",
                                     "4294967296",
                                     "2147483648",
                                     "1e400",
                                     "nan",
                                     "99999999999999999999",
                                     "-9223372036854775808",
                                     "1e9",
                                     "\\",
                                     "#",
                                     "\"",
                                     "/",
                                     "//",
                                     "\xef\xbb\xbf",
                                     "\r",
                                     "\n",
                                     " ",
                                     "f",
                                     "list",
                                     "BINARY",
                                     "-s",
                                     "16777216",
                                     "0x10",
                                     "1.5"};
        return words[below(std::size(words))];
    }

    void change(std::string& bytes) {
        const size_t at = below(bytes.size()), length = below(bytes.size() - at + 1);
        switch (below(8)) {
            case 0:
                bytes.resize(at);
                break;
            case 1:
                bytes.erase(at, 1 + below(8));
                break;
            case 2:
                bytes.insert(at, bytes.substr(below(bytes.size()), length));
                break;
            case 3:
                if (!bytes.empty()) bytes[at] = static_cast<char>(below(256));
                break;
            case 4:
                if (!bytes.empty()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
                break;
            case 5:
                bytes.insert(at, odd_word());
                break;
            case 6:
                if (bytes.size() >= at + 4)
                    bytes.replace(at, 4,
                                  bytes_of<uint32_t>({static_cast<uint32_t>(random_())}));
                break;
            default:
                replace_word(bytes, at);
        }
    }

    void replace_word(std::string& bytes, size_t at) {
        const size_t start = bytes.find_first_of(" \n", at);
        if (start == bytes.npos) return;
        const size_t end = std::min(bytes.find_first_of(" \n", start + 1), bytes.size());
        bytes.replace(start + 1, end - start - 1, odd_word());
    }

    std::mt19937 random_;
};

void expect_sound(const Model& model, size_t bytes, const std::string& what) {
    ASSERT_LE(model.mesh.positions.size(), 3 * bytes) << what;
    ASSERT_LE(model.mesh.triangles.size(), 3 * bytes) << what;
    expect_in_bounds(model, what);
}

TEST(HostileFiles, LoadOrEndInAnErrorThatNamesThem) {
    const char* wanted = std::getenv("RSH_HOSTILE_FILES");
    const uint32_t rounds = wanted ? static_cast<uint32_t>(std::atoi(wanted)) : 300;
    const TemporaryFolder folder;
    for (const Seed& seed : kSeeds) folder.write(seed.name, seed.bytes);
    const std::string obj = folder.path("a.obj");
    for (const Seed& seed : kSeeds) {
        const bool is_mtl = seed.name == std::string("a.mtl");
        for (uint32_t round = 0; round < rounds; ++round) {
            const std::string bytes = Mutator(round)(seed.bytes);
            const std::string file = folder.write(seed.name, bytes);
            const std::string what = file + ", round " + std::to_string(round);
            const auto start = std::chrono::steady_clock::now();
            try {
                const Model model = load_mesh(is_mtl ? obj : file);
                expect_sound(model, bytes.size() + 300, what);
            } catch (const std::exception& error) {
                EXPECT_NE(std::string(error.what()).find(file), std::string::npos)
                    << what << ": " << error.what();
            }
            const std::chrono::duration<double> taken =
                std::chrono::steady_clock::now() - start;
            EXPECT_LT(taken.count(), 2.0) << what;
            if (testing::Test::HasFatalFailure()) return;
        }
        folder.write(seed.name, seed.bytes);
    }
}

}  // namespace
}  // namespace render
