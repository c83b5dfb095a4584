// main.cpp - GoogleTest's main, and what every failure ends with: seed, device and the command
// that runs only that test again.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "support/device.hpp"
#include "support/random.hpp"

namespace {

class HowToRerun : public ::testing::EmptyTestEventListener {
public:
    explicit HowToRerun(std::string program) : program_(std::move(program)) {}

    void OnTestEnd(const ::testing::TestInfo& info) override {
        if (!info.result()->Failed()) return;
        std::printf("seed %llu, device %s\nrerun: RSH_SEED=%llu%s %s --gtest_filter=%s.%s\n",
                    (unsigned long long)test::seed(), test::device_name().c_str(),
                    (unsigned long long)test::seed(), test::small() ? " RSH_TEST_SMALL=1" : "",
                    program_.c_str(), info.test_suite_name(), info.name());
    }

private:
    std::string program_;
};

}  // namespace

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    ::testing::UnitTest::GetInstance()->listeners().Append(new HowToRerun(argv[0]));
    return RUN_ALL_TESTS();
}
