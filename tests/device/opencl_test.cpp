// opencl_test.cpp - which functions rsh calls for an object, by objects made up here.
#include "device/objects/opencl.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace {

cl_int CL_API_CALL some_platforms(cl_uint, cl_platform_id*, cl_uint*) {
    return CL_SUCCESS;
}

cl_icd_dispatch marked() {
    cl_icd_dispatch functions = {};
    std::memcpy(&functions.clGetPlatformIDs, &rsh::kLoaderCallsMark, sizeof(void*));
    return functions;
}

TEST(OpenCl, OfAnObjectThatNoNewLoaderKnowsIsTheDrivers) {
    const cl_icd_dispatch functions = marked();
    const rsh::ObjectHead object = {&functions, nullptr};
    EXPECT_EQ(&rsh::opencl(&object), &functions);
}

TEST(OpenCl, OfOneThatANewLoaderKnowsIsTheLoaders) {
    const cl_icd_dispatch functions = marked();
    const rsh::ObjectHead object = {&functions, &functions};
    EXPECT_EQ(&rsh::opencl(&object), &rsh::linked_functions());
}

// A driver of before puts what it likes behind its functions.
TEST(OpenCl, OfAnOldDriversIsTheLoaders) {
    cl_icd_dispatch functions = {};
    functions.clGetPlatformIDs = some_platforms;
    const rsh::ObjectHead object = {&functions, nullptr};
    EXPECT_EQ(&rsh::opencl(&object), &rsh::linked_functions());
}

TEST(OpenCl, OfNoObjectIsTheLoaders) {
    EXPECT_EQ(&rsh::opencl(nullptr), &rsh::linked_functions());
    const rsh::ObjectHead object = {nullptr, nullptr};
    EXPECT_EQ(&rsh::opencl(&object), &rsh::linked_functions());
}

}  // namespace
