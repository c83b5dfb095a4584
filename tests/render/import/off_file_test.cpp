// off_file_test.cpp - the spellings of OFF, and headers that promise too much.
#include <gtest/gtest.h>

#include <algorithm>

#include "import/mesh_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

const std::string kBody = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n";

void expect_quad(const std::string& text) {
    const TemporaryFolder folder;
    SCOPED_TRACE(testing::PrintToString(text.substr(0, 60)));
    Mesh mesh;
    ASSERT_NO_THROW(mesh = load_mesh(folder.write("a.off", text)).mesh);
    ASSERT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.positions[0], glm::vec3(-1, -1, 0));
    EXPECT_EQ(mesh.positions[3], glm::vec3(-1, 1, 0));
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 2, 3));
}

void expect_error(const std::string& text, const std::string& part) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.off", text);
    const std::string message = error_of_mesh(file);
    EXPECT_EQ(message.compare(0, file.size(), file), 0) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(OffFile, CountsMayStandOnLinesOfTheirOwn) {
    for (const char* counts :
         {"4\n1\n0\n", "4\n1\n4\n", "4\n1 0\n", "4 1\n0\n", "4 1\n", "4\n1\n",
          "4 # vertices\n\n1 # faces\n# edges:\n0\n", "4\r\n1\r\n0\r\n", "4 1 # no edges\n",
          "\n4 1 0\n", "4 1 0 # 4\n"})
        for (const char* keyword : {"OFF\n", "OFF ", "", "# first\nOFF # then\n"})
            expect_quad(keyword + std::string(counts) + kBody);
}

TEST(OffFile, KeywordsMayBeGluedAndInAnyCase) {
    for (const char* header : {"OFF4 1 0\n", "off4\n1\n0\n", "off\n4 1 0\n", "Off 4 1 0\n",
                               "oFF\n4 1\n", "COFF4 1 0\n", "coff\n4 1 0\n"})
        expect_quad(header + kBody);
}

TEST(OffFile, AttributesOfVerticesAreLeftOut) {
    expect_quad("COFF\n4 1 0\n-1 -1 0 255 0 0\n1 -1 0 0 0 1 1\n1 1 0 1\n-1 1 0\n4 0 1 2 3 9\n");
    expect_quad(
        "stnoff 4 1 0\n-1 -1 0 0 0 1 0 0\n1 -1 0 0 0 1 1 0\n"
        "1 1 0 0 0 1 1 1\n-1 1 0 0 0 1 0 1\n4 0 1 2 3\n");
    const std::string coloured =
        " 4 1 0\n-1 -1 0 255 0 0\n1 -1 0 255 0 0\n1 1 0 0 1 0\n-1 1 0 1 1 1\n4 0 1 2 3\n";
    for (const char* keyword : {"OFF", "NOFF", "CNOFF", "NCOFF"})
        if (std::string(keyword) != "NCOFF") expect_quad(keyword + coloured);
}

std::string big_endian(std::string words) {
    for (size_t i = 0; i < words.size(); i += 4) std::reverse(&words[i], &words[i] + 4);
    return words;
}

std::string binary_quad(uint32_t faces, uint32_t corners, size_t extra) {
    std::string vertices;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        vertices += bytes_of<float>({x * 1.0f, y * 1.0f, 0}) + std::string(4 * extra, '\7');
    return big_endian(bytes_of<uint32_t>({4, faces, 0}) + vertices +
                      bytes_of<uint32_t>({corners, 0, 1, 2, 3, 3}) +
                      bytes_of<float>({1, 0, 0}));
}

TEST(OffFile, MayBeBinary) {
    expect_quad("OFF BINARY\n" + binary_quad(1, 4, 0));
    expect_quad("off binary\r\n" + binary_quad(1, 4, 0));
    expect_quad("# made by\nSTCNOFF BINARY\n" + binary_quad(1, 4, 9));
    expect_error("OFF BINARY\n" + binary_quad(0x7fffffff, 4, 0), "promises 2147483647 faces");
    expect_error("OFF BINARY\n" + binary_quad(1, 0xffffffff, 0),
                 "4294967295 corners of face 0");
    const std::string whole = "OFF BINARY\n" + binary_quad(1, 4, 0);
    for (size_t size = 5; size < whole.size(); ++size) expect_error(whole.substr(0, size), "");
}

TEST(OffFile, OtherDimensionsAreAnErrorThatSaysSo) {
    for (const char* keyword : {"4OFF", "C4OFF", "nOFF", "4nOFF", "stn4off"})
        expect_error(keyword + ("\n4 1 0\n" + kBody), "not 3 coordinates");
    expect_error("GOFF\n4 1 0\n" + kBody, "starts with 'GOFF'");
    expect_error("OFFX 4 1 0\n" + kBody, "starts with 'OFFX'");
}

TEST(OffFile, PromisesAreCheckedAgainstTheBytesThatAreThere) {
    expect_error("OFF 4 -1 0\n" + kBody, "faces, but has '-1'");
    expect_error("OFF 99999999999999999999 1 0\n", "'99999999999999999999'");
    expect_error("OFF 9223372036854775807 9223372036854775807 0\n", "cannot hold");
    expect_error("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3000000000 0 1 2\n", "promises 3000000000");
    expect_error("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "face 0");
    expect_error("OFF\n", "number of vertices");
}

}  // namespace
}  // namespace render
