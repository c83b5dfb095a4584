// json_text_test.cpp - JSON that is deep, long or cut, and numbers that do not fit their type.
#include "files/json_text.hpp"

#include <gtest/gtest.h>

#include "files/text_scan.hpp"
#include "import/vertex_frames.hpp"
#include "scene/scene_file.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

std::string repeated(const std::string& text, size_t times) {
    std::string all;
    for (size_t i = 0; i < times; ++i) all += text;
    return all;
}

std::string error_of(const std::string& text) {
    try {
        parse_json(text, "a.json");
    } catch (const LoadError& error) {
        return error.what();
    }
    return "";
}

// The message of a scene whose JSON is right but for its numbers.
std::string error_of_scene(const std::string& members) {
    try {
        parse_scene(R"({"meshes": [], )" + members + "}", "a.json");
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

void expect_in(const std::string& message, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos)
            << '"' << part << "\" is not in: " << message;
}

TEST(JsonText, IsAtMostSoDeep) {
    for (const size_t depth : {size_t{100}, size_t{1000}, size_t{60000}, size_t{1000000}})
        for (const auto& [open, close] : {std::pair("[", "]"), std::pair("{\"a\":", "}")}) {
            const std::string whole = repeated(open, depth) + "1" + repeated(close, depth);
            expect_in(error_of(whole), {"a.json", "nested 100 deep"});
            expect_in(error_of(repeated(open, depth + 1)), {"a.json", "nested 100 deep"});
        }
    EXPECT_EQ(error_of(repeated("[", 99) + repeated("]", 99)), "");
}

TEST(JsonText, OfAllFilesIsAtMostSoDeep) {
    const TemporaryFolder folder;
    const std::string deep = repeated("[", 60000);
    const std::string scene = folder.write("scene.json", deep);
    EXPECT_THROW(read_scenes({scene}), std::runtime_error);
    folder.write("a.json", deep);
    folder.write("a.off", "OFF 3 1 0\n0 0 0 1 0 0 0 1 0 3 0 1 2\n");
    EXPECT_THROW(load_vertex_frames(folder.path("a.off"), folder.write("a.f32", "")),
                 LoadError);
}

TEST(JsonText, MayBeginWithTheMarkOfUtf8) {
    EXPECT_EQ(parse_json("\xef\xbb\xbf{\"a\": 1} // comment", "a.json")["a"], 1);
}

TEST(JsonText, KeepsMessagesShort) {
    EXPECT_LT(error_of("[\"" + std::string(1000000, 'x')).size(), 400u);
    EXPECT_LT(error_of("[1" + std::string(1000000, '0') + "x").size(), 400u);
    for (const char* text :
         {"", "{", "[1, nan]", "[Infinity]", "[1e999]", "{\"a\": 1,}", "\xff\xfe{"})
        expect_in(error_of(text), {"a.json: not JSON"});
}

TEST(JsonText, NumbersFitTheirType) {
    const auto camera = [](const char* eye) {
        return R"("camera": {"at": [0, 0, 0], "eye": )" + std::string(eye) + "}";
    };
    for (const char* size : {"[1e99, 8]", "[-8, 8]", "[8, 3.7]", "[8, 18446744073709551615]",
                             "[8, \"8\"]", "[8, null]", "[9223372036854775808, 8]"})
        expect_in(error_of_scene(R"("settings": {"size": )" + std::string(size) + "}"),
                  {"a.json: settings.size[", "found", "a whole number from 1 to 16384"});
    for (const char* bounces : {"3.7", "-1", "1e300", "[3]"})
        expect_in(error_of_scene(R"("settings": {"bounces": )" + std::string(bounces) + "}"),
                  {"a.json: settings.bounces", "found", "a whole number"});
    for (const char* eye : {"[1e99, 0, 0]", "[0, -1e39, 0]", "[0, 0, 1e300]"})
        expect_in(error_of_scene(camera(eye)),
                  {"a.json: camera.eye", "found", "3 numbers from"});
    expect_in(error_of_scene(camera("[1e30, 0, 0]")), {"a.json: camera", "differ"});
    for (const char* ambient : {"1e99", "[1, 1, 1e39]"})
        expect_in(error_of_scene(R"("ambient": )" + std::string(ambient)),
                  {"a.json: ambient", "found", "a float"});
    for (const char* scale : {"1e99", "[1, 1e99, 1]", "1e-60", "0"})
        expect_in(error_of_scene(R"("meshes": [{"generator": "room", "transform": {"scale": )" +
                                 std::string(scale) + "}}]"),
                  {"a.json: meshes[0].transform.scale", "found"});
}

TEST(JsonText, WholeNumbersMayHaveAPointOrAnExponent) {
    EXPECT_EQ(
        *parse_scene(R"({"meshes": [], "settings": {"bounces": 3.0, "frames": 1e2}})", "a.json")
             .settings.frames,
        100);
}

}  // namespace
}  // namespace render
