// mesh_ranges_test.cpp - ranges of an rsh_geometry given wrongly: the status of rsh.h, a message with the
// field, the actual and the required value, and nothing is enqueued.
#include <gtest/gtest.h>

#include "api/calls.hpp"
#include "api/valid_calls.hpp"

namespace {

using test::call;

class MisuseOfMeshRanges : public ::testing::Test {
protected:
    template <class Desc>
    void refuses(const Desc& desc, rsh_status status, const std::vector<std::string>& words) {
        EXPECT_EQ(call(&desc), status) << rsh_last_error();
        test::expect_said(words);
        EXPECT_TRUE(valid_.outputs_untouched()) << words[0];
    }

    // Of any call that has a geometry.
    template <class Desc>
    void refuses_ranges(Desc valid, cl_mem output, const char* name) {
        valid.geometry.ranges = two_.get();
        valid.geometry.range_count = 2;
        Desc desc = valid;
        desc.geometry.ranges = nullptr;
        refuses(desc, RSH_INVALID_VALUE, {"geometry.ranges", "NULL"});
        desc = valid;
        desc.geometry.range_count = 3;
        refuses(desc, RSH_BUFFER_TOO_SMALL, {"geometry.ranges", "32 bytes", "48"});
        desc.geometry.range_count = 0xffffffffu;
        refuses(desc, RSH_BUFFER_TOO_SMALL, {"geometry.ranges", "68719476720"});
        const cl::Context other(test::device().device);
        const cl::Buffer foreign(other, CL_MEM_READ_WRITE, 65536);
        desc = valid;
        desc.geometry.ranges = foreign();
        refuses(desc, RSH_INVALID_VALUE, {"geometry.ranges", "context"});
        desc.geometry.ranges = output;
        refuses(desc, RSH_INVALID_VALUE, {name, "overlap", "geometry.ranges"});
    }

    const test::Buffer<rsh_mesh_range> two_{std::vector<rsh_mesh_range>(2)};
    test::ValidCalls valid_;
};

TEST_F(MisuseOfMeshRanges, IsRefusedByEveryCallWithAGeometry) {
    refuses_ranges(valid_.rasterize(), valid_.hits.get(), "hits");
    refuses_ranges(valid_.bound(), valid_.bounds.get(), "bounds");
    refuses_ranges(valid_.traverse(), valid_.hits.get(), "hits");
    refuses_ranges(valid_.audit(), valid_.report.get(), "report");
}

// Nothing tells the host what a buffer holds: here ranges that do not ascend, in memory that the call
// reads as well.
TEST_F(MisuseOfMeshRanges, WithWrongContentsIsTaken) {
    auto desc = valid_.bound();
    desc.geometry.ranges = desc.geometry.vertices;
    desc.geometry.range_count = 3;
    EXPECT_EQ(call(&desc), RSH_SUCCESS) << rsh_last_error();
    test::device().queue.finish();
}

}  // namespace
