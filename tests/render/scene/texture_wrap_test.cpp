// texture_wrap_test.cpp - the option -clamp of map_Kd, up to the tables of the device.
#include <gtest/gtest.h>

#include "scene/scene_file.hpp"
#include "scene/world.hpp"
#include "temporary_folder.hpp"

namespace render {
namespace {

TEST(TextureWrap, IsThatOfTheMaterial) {
    const TemporaryFolder folder;
    folder.write("a.ppm", "P6 1 1 255\nabc");
    folder.write("a.mtl",
                 "newmtl repeats\nmap_Kd a.ppm\nnewmtl clamps\nmap_Kd -clamp on a.ppm\n"
                 "newmtl again\nmap_Kd -s 2 -clamp on a.ppm\n");
    const std::string obj = folder.write(
        "a.obj",
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl repeats\n"
        "f 1/1 2/1 3/1\nusemtl clamps\nf 1/1 2/1 3/1\nusemtl again\nf 1/1 2/1 3/1\n");
    const World world(parse_scene(R"({"meshes": [{"file": ")" + obj + R"("}]})", "a.json"));
    EXPECT_TRUE(world.warnings().empty()) << world.warnings()[0];
    ASSERT_EQ(world.materials().size(), 3u);
    const auto& textures = world.textures().textures();
    ASSERT_EQ(textures.size(), 2u) << "one image, repeating and clamped";
    EXPECT_EQ(textures[world.materials()[0].texture].wrap, RSH_WRAP_REPEAT);
    EXPECT_EQ(textures[world.materials()[1].texture].wrap, RSH_WRAP_CLAMP);
    EXPECT_EQ(textures[world.materials()[2].texture].wrap, RSH_WRAP_CLAMP);
}

}  // namespace
}  // namespace render
