#include "programs/ptxas_log.hpp"

#include <gtest/gtest.h>

namespace bench {
namespace {

// As ptxas of CUDA 12.9 says it, with the numbers of one function that was not inlined behind.
constexpr char kLog[] = R"(ptxas info    : 0 bytes gmem
ptxas info    : Compiling entry function 'rsh_tiles' for 'sm_90'
ptxas info    : Function properties for rsh_tiles
    35376 bytes stack frame, 24 bytes spill stores, 48 bytes spill loads
ptxas info    : Used 255 registers, used 0 barriers, 35380 bytes cumulative stack size
ptxas info    : Compile time = 4087.048 ms
ptxas info    : Function properties for visit
    64 bytes stack frame, 8 bytes spill stores, 8 bytes spill loads
ptxas info    : Compiling entry function 'rsh_scan' for 'sm_90'
ptxas info    : Function properties for rsh_scan
    0 bytes stack frame, 0 bytes spill stores, 0 bytes spill loads
ptxas info    : Used 40 registers, used 1 barriers, 2048 bytes smem, 400 bytes cmem[0]
)";

TEST(PtxasLog, HasTheFiguresOfEachKernel) {
    const auto kernels = read_ptxas_log(kLog);
    ASSERT_EQ(kernels.size(), 2u);
    const PtxasFigures& tiles = kernels.at("rsh_tiles");
    EXPECT_EQ(tiles.registers, 255u);
    EXPECT_EQ(tiles.stack_bytes, 35380u);
    EXPECT_EQ(tiles.spill_store_bytes, 24u);
    EXPECT_EQ(tiles.spill_load_bytes, 48u);
    EXPECT_EQ(tiles.shared_bytes, 0u);
    const PtxasFigures& scan = kernels.at("rsh_scan");
    EXPECT_EQ(scan.registers, 40u);
    EXPECT_EQ(scan.stack_bytes, 0u);
    EXPECT_EQ(scan.shared_bytes, 2048u);
}

TEST(PtxasLog, IsEmptyForWhatOtherCompilersSay) {
    EXPECT_TRUE(read_ptxas_log("").empty());
    EXPECT_TRUE(read_ptxas_log("warning: 12 registers, 4 bytes stack frame\n").empty());
}

}  // namespace
}  // namespace bench
