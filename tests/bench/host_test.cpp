// host_test.cpp - the instruction set is what the system says of the processor.
#include "host.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace bench {
namespace {

#if defined(__x86_64__)
// Of the first processor in /proc/cpuinfo.
std::set<std::string> cpu_flags() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("flags", 0) != 0) continue;
        std::istringstream words(line.substr(line.find(':') + 1));
        return {std::istream_iterator<std::string>(words), {}};
    }
    return {};
}

TEST(Host, HasTheWidestVectorsThatTheSystemNames) {
    const std::set<std::string> flags = cpu_flags();
    ASSERT_FALSE(flags.empty()) << "/proc/cpuinfo has no line of flags";
    std::string widest;
    for (const char* name : {"sse2", "avx", "avx2", "avx512f"})
        if (flags.count(name)) widest = name;
    EXPECT_EQ(host_instruction_set(), widest);
}
#endif

TEST(Host, NamesSomeInstructionSet) {
    EXPECT_NE(host_instruction_set(), "");
}

}  // namespace
}  // namespace bench
