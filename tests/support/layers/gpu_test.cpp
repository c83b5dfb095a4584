// gpu_test.cpp - that the loader takes the layer of gpu.cpp, and that the device then is what a
// caller takes for a GPU. Fails without the layer.
#include <gtest/gtest.h>

#include <vector>

#include "support/device.hpp"

namespace {

cl_uint devices_of_type(cl_device_type type) {
    cl_uint count = 0;
    const cl_int status = clGetDeviceIDs(test::device().platform(), type, 0, nullptr, &count);
    return status == CL_SUCCESS ? count : 0;
}

TEST(GpuLayer, MakesEachDeviceSayThatItIsAGpu) {
    const cl::Device& device = test::device().device;
    EXPECT_EQ(device.getInfo<CL_DEVICE_TYPE>(), cl_device_type{CL_DEVICE_TYPE_GPU});
    EXPECT_EQ(device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>(), 1u);
    EXPECT_EQ(device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>(), 256u);
    EXPECT_EQ(device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>(), 49152u);
}

TEST(GpuLayer, FindsDevicesAsGpusAlone) {
    const cl_uint all = devices_of_type(CL_DEVICE_TYPE_ALL);
    EXPECT_GT(all, 0u);
    EXPECT_EQ(devices_of_type(CL_DEVICE_TYPE_GPU), all);
    EXPECT_EQ(devices_of_type(CL_DEVICE_TYPE_CPU), 0u);
}

TEST(GpuLayer, RefusesWhatAGpuRefuses) {
    const test::Device& device = test::device();
    const cl::Buffer buffer(device.context, CL_MEM_READ_WRITE, 4096);
    const cl_buffer_region region = {128, 1024};
    cl_int status = CL_SUCCESS;
    clCreateSubBuffer(buffer(), 0, CL_BUFFER_CREATE_TYPE_REGION, &region, &status);
    ASSERT_EQ(status, CL_MISALIGNED_SUB_BUFFER_OFFSET) << "no layer";
    // The layer looks at the group first, so that no kernel is needed.
    const size_t items = 512, group = 512;
    EXPECT_EQ(clEnqueueNDRangeKernel(device.queue(), nullptr, 1, nullptr, &items, &group, 0,
                                     nullptr, nullptr),
              CL_INVALID_WORK_GROUP_SIZE);
}

}  // namespace
