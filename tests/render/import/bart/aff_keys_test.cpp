// aff_keys_test.cpp - lists of keys that go back in time, or stand still in it.
#include "import/bart/aff_text.hpp"

namespace render {
namespace {

Model load_at(const std::string& text, double time) {
    return load_text(text)->at(time);
}

// A triangle under the keys `kind` with these times; the value of a key is its number, from 1.
std::string keys(const std::string& kind, const std::vector<double>& times) {
    std::string text = "x t { p 3 1 0 0  0 1 0  0 0 1 }\nk t {\n" + kind + " " +
                       std::to_string(times.size()) + "\n";
    for (size_t i = 0; i < times.size(); ++i) {
        const std::string n = std::to_string(i + 1);
        text += std::to_string(times[i]) + " ";
        if (kind == "visibility") text += std::to_string(i % 2) + "\n";
        if (kind == "rot") text += "0 1 0 " + n + "0 0 0 0\n";
        if (kind == "transl" || kind == "scale") text += n + " " + n + " 1 0 0 0\n";
    }
    return text + "}\n";
}

void expect_same_motion(const std::string& restarted, const std::string& clean) {
    const auto one = load_text(restarted), other = load_text(clean);
    for (double time = -1.0; time < 70.0; time += 0.5) {
        const Mesh a = one->at(time).mesh, b = other->at(time).mesh;
        for (size_t i = 0; i < b.positions.size(); ++i)
            ASSERT_EQ(a.positions[i], b.positions[i])
                << "vertex " << i << " at " << time << " of\n"
                << restarted;
    }
}

TEST(AffKeys, ThatRestartAreLeftOutUpToTheFirstLaterOne) {
    for (const char* kind : {"rot", "transl", "scale"}) {
        const std::string restarted = keys(kind, {0, 12, 24, 36, 48, 42, 45, 48, 60, 66});
        std::string clean = restarted;  // without the keys 6 to 8
        const size_t first = clean.find("42.0"), last = clean.find("60.0");
        clean.erase(first, last - first);
        clean.replace(clean.find(" 10\n"), 4, " 7\n");
        expect_same_motion(restarted, clean);
        expect_one_warning(*load_text(restarted),
                           {"a.aff, line 9", kind, "'t'", "left out: 3", "42.0", "48.0"});
    }
}

TEST(AffKeys, LoadEvenIfAllButOneAreLeftOut) {
    for (const char* kind : {"rot", "transl", "scale"}) {
        const Model model = load_at(keys(kind, {9, 1, 2, 3, 4}), 5.0);
        EXPECT_EQ(model.warnings.size(), 1u);
        EXPECT_EQ(model.mesh.triangles.size(), 1u);
    }
}

TEST(AffKeys, AtEqualTimesAreAJumpAndNoRestart) {
    const auto animation = load_text(keys("transl", {0, 1, 2, 2, 3, 3, 4}));
    expect_one_warning(*animation, {"a.aff, line 7", "transl of 't'", "jumps: 2", "2.0"});
    EXPECT_EQ(animation->at(2.0).mesh.positions[0], glm::vec3(1 + 4, 4, 1));
    EXPECT_NEAR(animation->at(2.0 - 1e-9).mesh.positions[0].y, 3.0, 1e-5);
}

TEST(AffKeys, OfVisibilityMayRestart) {
    const std::string text = keys("visibility", {1, 2, 0.5, 3, 4});
    EXPECT_EQ(load_at(text, 0.7).mesh.positions[0], glm::vec3(1, 0, 0));  // before the first
    EXPECT_EQ(load_at(text, 1.5).mesh.positions[0], glm::vec3(0));
    EXPECT_EQ(load_at(text, 2.5).mesh.positions[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(load_at(text, 2.5).warnings.size(), 1u);
}

TEST(AffKeys, OfAnimatedTrianglesMayRestartWithOneWarning) {
    std::string triangle = "tpa 3\n";
    for (const char* time : {"1", "3", "2"})
        triangle += std::string(time) + " " + time + " 0 0 0 0 1  0 1 0 0 0 1  0 0 1 0 0 1\n";
    const Model model = load_at(triangle + triangle, 9.0);
    EXPECT_EQ(model.mesh.positions[0], glm::vec3(3, 0, 0));
    EXPECT_EQ(model.warnings.size(), 1u);
}

TEST(AffKeys, NeedTimesThatAreNumbers) {
    for (const char* time : {"nan", "inf", "-inf"}) {
        std::string text = keys("transl", {0, 1, 2, 3});
        text.replace(text.find("1.000"), 8, time);
        try {
            load_at(text, 0.0);
            ADD_FAILURE() << "loads: " << text;
        } catch (const LoadError& error) {
            EXPECT_NE(std::string(error.what()).find("time of a key"), std::string::npos)
                << error.what();
        }
    }
}

}  // namespace
}  // namespace render
