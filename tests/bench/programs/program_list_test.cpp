#include "programs/program_list.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace bench {
namespace {

std::vector<std::string> texts(const std::string& list) {
    std::istringstream lines(list);
    std::vector<std::string> texts;
    for (const ProgramName& name : read_program_list(lines)) texts.push_back(name.text());
    return texts;
}

TEST(ProgramList, HasWhatAFrameLaunchesFirstAndVariantsLast) {
    EXPECT_EQ(texts("reduce/atomic -D A=1\n"
                    "reduce/atomic -D A=2\n"
                    "\n"
                    "programs/tiles\n"
                    "programs/surface -D S=0\n"
                    "programs/surface -D S=1\n"
                    "programs/paper_faithful\n"),
              (std::vector<std::string>{"programs/paper_faithful", "programs/tiles",
                                        "programs/surface -D S=0", "reduce/atomic -D A=1",
                                        "programs/surface -D S=1", "reduce/atomic -D A=2"}));
}

TEST(ProgramList, SeparatesTheStemFromItsOptions) {
    std::istringstream lines("reduce/atomic -D RSH_WORDS=2 -D RSH_KEEP=1\n");
    const auto names = read_program_list(lines);
    ASSERT_EQ(names.size(), 1u);
    EXPECT_EQ(names[0].stem, "reduce/atomic");
    EXPECT_EQ(names[0].options, "-D RSH_WORDS=2 -D RSH_KEEP=1");
}

// A stem that is renamed would fall behind the variants of others.
TEST(ProgramList, BeginsWithBothTraversalsOfTheStoredList) {
    std::ifstream lines(RSH_PROGRAM_LIST);
    const auto names = read_program_list(lines);
    ASSERT_GT(names.size(), 4u) << RSH_PROGRAM_LIST;
    EXPECT_EQ(names[0].stem, "programs/paper_faithful");
    EXPECT_EQ(names[1].stem, "programs/tiles");
    EXPECT_EQ(names[2].stem, "programs/surface");
    EXPECT_EQ(names[3].stem, "camera/rasterize");
}

}  // namespace
}  // namespace bench
