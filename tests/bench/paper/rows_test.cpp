#include "paper/rows.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace bench::paper {
namespace {

// The talk's figures, in milliseconds; that of the build is kBuildPaperMs.
TEST(PaperRows, HaveEachFigureOfTheTalkOnce) {
    std::map<std::string, double> found;
    for (const Row& row : rows()) {
        if (!row.paper_ms) continue;
        EXPECT_TRUE(found.emplace(row.name, *row.paper_ms).second) << row.name;
    }
    const std::map<std::string, double> talk = {
        {"one_reflector", 79}, {"covering_1", 136},     {"covering_2", 391}, {"several", 302},
        {"patio", 300},        {"less_coherent", 1000}, {"statue", 4000},    {"museum3", 289},
        {"museum8", 3330},     {"large", 18500}};
    EXPECT_EQ(found, talk);
    EXPECT_EQ(kBuildPaperMs, 2);
}

TEST(PaperRows, QuickOnesAreThoseWithAFigure) {
    for (const Row& row : rows()) EXPECT_EQ(row.is_quick, row.paper_ms.has_value()) << row.name;
}

TEST(PaperRows, FiguresAreOf512x512) {
    for (const Row& row : rows())
        if (row.paper_ms) {
            EXPECT_EQ(row.size.width, 512u) << row.name;
            EXPECT_EQ(row.size.height, 512u) << row.name;
        }
}

TEST(PaperRows, HaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const Row& row : rows()) {
        const std::string name = case_name(row, "tiles");
        EXPECT_TRUE(names.insert(name).second) << name;
    }
}

TEST(PaperRows, StandInsAreAskedForRays) {
    for (const Row& row : rows()) {
        const bool is_covering = row.name.rfind("covering", 0) == 0;
        const bool is_single =
            row.name == "one_reflector" || row.name == "patio" || row.name == "large";
        EXPECT_EQ(row.least_spawn_share, is_covering ? 0.6 : is_single ? 0.15 : 0) << row.name;
        EXPECT_EQ(row.least_reflectors, row.name == "several" ? 5u : 0u) << row.name;
    }
}

TEST(PaperRows, SizesGoFrom128To4096) {
    std::set<cl_uint> sides;
    for (const Row& row : rows())
        if (row.name == "resolution") sides.insert(row.size.width);
    EXPECT_EQ(sides, (std::set<cl_uint>{128, 256, 512, 1024, 2048, 4096}));
}

TEST(PaperRows, ShadowsAreTheMuseums) {
    for (const Row& row : rows())
        EXPECT_EQ(row.has_shadows, row.name.rfind("museum", 0) == 0) << row.name;
}

TEST(PaperRows, AStrategyIsOfPaperFaithfulAlone) {
    for (const Row& row : rows()) {
        EXPECT_TRUE(row.takes("paper_faithful"));
        EXPECT_EQ(row.takes("tiles"), row.strategy.empty());
    }
}

}  // namespace
}  // namespace bench::paper
