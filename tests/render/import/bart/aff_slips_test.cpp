// aff_slips_test.cpp - what is wrong in AFF files that can be had, and can be understood all the same:
// it loads, with a warning that names file and line. Keys have a file of their own, textures too.
#include "import/bart/aff_text.hpp"

namespace render {
namespace {

constexpr const char* kTriangle = "p 3 1 0 0 0 1 0 0 0 1\n";
constexpr const char* kStandsStill =
    " { transl 4 0 0 0 0 0 0 0 1 0 0 0 0 0 0 2 0 0 0 0 0 0 3 0 0 0 0 0 0 }\n";

TEST(AffSlips, AnIncludeMayBeAbsent) {
    const auto animation = load_text("b 0 0 0\ni 0 none.aff\n" + std::string(kTriangle));
    expect_one_warning(*animation, {"a.aff, line 2", "none.aff", "not there"});
    EXPECT_EQ(animation->at(0.0).mesh.triangles.size(), 1u) << "what comes after it counts";
}

TEST(AffSlips, AnIncludeThatCannotBeUnpackedIsAnError) {
    const TemporaryFolder folder;
    folder.write("part.aff.xz", "no such thing");
    const std::string file = folder.write("a.aff", "i 0 part.aff\n");
    EXPECT_THROW(load_aff(file), LoadError);
}

TEST(AffSlips, AnIncludeMayBeInAnotherCaseOrAnArchive) {
    const TemporaryFolder folder;
    folder.write("Part.AFF", kTriangle);
    folder.write_tar_xz("b.tar.xz", {{"b.aff", kTriangle}});
    const Model model = load_aff(folder.write("a.aff", "i 0 part.aff i 0 b.aff\n"))->at(0.0);
    EXPECT_EQ(model.mesh.triangles.size(), 2u);
    EXPECT_TRUE(model.warnings.empty());
}

TEST(AffSlips, ATransformMayHaveNoKeys) {
    const std::string moved = "x car {\n" + std::string(kTriangle) + "}\n";
    const auto animation = load_text("\n" + moved + moved);
    expect_one_warning(*animation, {"a.aff, line 2", "'car'", "no keys"});
    EXPECT_EQ(animation->at(0.5).mesh.positions[0], glm::vec3(1, 0, 0));
}

TEST(AffSlips, ALightMayHaveNoKeys) {
    const auto animation = load_text(kTriangle + std::string("la lamp 1 2 3\n"));
    expect_one_warning(*animation, {"a.aff, line 2", "'lamp'", "no keys"});
    EXPECT_EQ(animation->at(0.5).lights.at(0).position, glm::vec3(1, 2, 3));
}

TEST(AffSlips, KeysMayMoveNothing) {
    const auto animation = load_text(kTriangle + std::string("k ghost") + kStandsStill);
    expect_one_warning(*animation, {"a.aff, line 2", "'ghost'", "move nothing"});
}

TEST(AffSlips, KeysOfTheCameraNeedNoTransform) {
    const auto animation = load_text(kTriangle + std::string("k camera") + kStandsStill);
    EXPECT_TRUE(animation->at(0.0).warnings.empty());
}

// The kitchen's wheels are one file each, which is included twice.
TEST(AffSlips, AreWarnedOfOnceWhereAFileIsIncludedTwice) {
    const TemporaryFolder folder;
    folder.write("wheel.aff", "x wheel { " + std::string(kTriangle) + "}\ni 0 none.aff\n");
    const auto animation = load_aff(folder.write("a.aff", "i 0 wheel.aff i 0 wheel.aff\n"));
    const std::vector<std::string> warnings = animation->at(0.0).warnings;
    ASSERT_EQ(warnings.size(), 2u);
    expect_parts(warnings[0], {"wheel.aff, line 3", "none.aff"});
    expect_parts(warnings[1], {"wheel.aff, line 1", "'wheel'"});
}

// A zero byte is no end of the file.
TEST(AffSlips, AZeroByteIsAnUnknownWord) {
    std::string text = std::string(kTriangle) + "? " + kTriangle;
    text[text.find('?')] = '\0';
    expect_parts(error_of(text), {"a.aff, line 2"});
}

// Nothing says how many words belong to a command that is not known.
TEST(AffSlips, AnUnknownWordIsAnError) {
    expect_parts(error_of(kTriangle + std::string("q 3\n")), {"a.aff, line 2", "'q'"});
    expect_parts(error_of("k a {\nshear 4 }\n"), {"a.aff, line 2", "'shear'"});
}

}  // namespace
}  // namespace render
