// device_test.cpp - rsh::Device makes what rsh's calls need, owns it, and logs when it is told to.
#include <gtest/gtest.h>

#include <cstdlib>
#include <rsh/rsh.hpp>
#include <vector>

#include "support/device.hpp"

namespace {

// Packs a few words, so that a program is compiled, or taken from the cache.
std::vector<cl_uint> reduced(const rsh::Device& device) {
    const std::vector<cl_uint> words = {5, RSH_NO_HIT, 7, RSH_NO_HIT, 9};
    const size_t bytes = words.size() * sizeof(cl_uint);
    const cl::Context context(device.context(), true);
    const cl::CommandQueue queue(device.queue(), true);
    const cl::Buffer in(context, CL_MEM_READ_WRITE, bytes),
        out(context, CL_MEM_READ_WRITE, bytes);
    const cl::Buffer count(context, CL_MEM_READ_WRITE, sizeof(cl_uint));
    queue.enqueueWriteBuffer(in, CL_TRUE, 0, bytes, words.data());
    auto desc = rsh::make<rsh_reduce_desc>();
    desc.keep = RSH_KEEP_NOT_NULL;
    desc.element_bytes = 4;
    desc.count = static_cast<cl_uint>(words.size());
    desc.input = in();
    desc.output = out();
    desc.output_count = count();
    rsh::check(rsh_reduce(device.rsh(), device.queue(), &desc, 0, nullptr, nullptr));
    queue.finish();
    cl_uint kept = 0;
    queue.enqueueReadBuffer(count, CL_TRUE, 0, sizeof kept, &kept);
    std::vector<cl_uint> result(kept);
    queue.enqueueReadBuffer(out, CL_TRUE, 0, kept * sizeof(cl_uint), result.data());
    return result;
}

cl_uint references(cl_context context) {
    return cl::Context(context, true).getInfo<CL_CONTEXT_REFERENCE_COUNT>() - 1;
}

const std::vector<cl_uint> kKept = {5, 7, 9};

TEST(Device, ServesTheCalls) {
    EXPECT_EQ(reduced(rsh::Device()), kKept);
    const std::string name = test::device().device.getInfo<CL_DEVICE_NAME>();
    const rsh::Device named(name.c_str());
    EXPECT_EQ(cl::Device(named.device(), true).getInfo<CL_DEVICE_NAME>(), name);
    EXPECT_EQ(cl::Device(named.device(), true).getInfo<CL_DEVICE_PLATFORM>(), named.platform());
}

TEST(Device, GivesTheQueueItsProperties) {
    const cl_command_queue_properties wanted =
        CL_QUEUE_PROFILING_ENABLE | CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE;
    const cl_command_queue_properties supported =
        test::device().device.getInfo<CL_DEVICE_QUEUE_PROPERTIES>() & wanted;
    for (const cl_command_queue_properties properties :
         {cl_command_queue_properties{0}, supported}) {
        const rsh::Device device(nullptr, properties);
        EXPECT_EQ(cl::CommandQueue(device.queue(), true).getInfo<CL_QUEUE_PROPERTIES>(),
                  properties);
        EXPECT_EQ(reduced(device), kKept);
    }
}

TEST(Device, ReleasesWhatItMade) {
    auto device = std::make_unique<rsh::Device>();
    const cl::Context context(device->context(), true);
    EXPECT_GT(references(context()), 1u);
    device.reset();
    EXPECT_EQ(references(context()), 1u);
}

TEST(Device, CanBeMoved) {
    rsh::Device first;
    const rsh_context rsh = first.rsh();
    rsh::Device second(std::move(first));
    EXPECT_EQ(second.rsh(), rsh);
    EXPECT_EQ(first.rsh(), nullptr);
    EXPECT_EQ(first.context(), nullptr);
    EXPECT_EQ(first.queue(), nullptr);
    first = rsh::Device();
    second = std::move(first);
    EXPECT_EQ(reduced(second), kKept);
}

TEST(Device, ThatIsNotThereIsAnError) {
    try {
        const rsh::Device none("no such device");
        FAIL() << "there is none of that name";
    } catch (const rsh::Error& error) {
        EXPECT_EQ(error.status(), RSH_NO_DEVICE);
        EXPECT_NE(std::string(error.what()).find("RSH_NO_DEVICE"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("no such device"), std::string::npos);
    }
}

// What a device with this value of RSH_LOG writes to stderr while it is used.
std::string logged(const char* value) {
    const char* const set = std::getenv("RSH_LOG");
    const std::string before = set ? set : "";
    value ? setenv("RSH_LOG", value, 1) : unsetenv("RSH_LOG");
    const rsh::Device device(nullptr, 0, rsh::log_from_environment());
    set ? setenv("RSH_LOG", before.c_str(), 1) : unsetenv("RSH_LOG");
    testing::internal::CaptureStderr();
    EXPECT_EQ(reduced(device), kKept);
    return testing::internal::GetCapturedStderr();
}

TEST(Log, OfProgramsIsAskedForByTheEnvironment) {
    const std::string text = logged("1");
    EXPECT_EQ(text.find("rsh: reduce/"), 0u) << text;
    EXPECT_TRUE(text.find("compiled in") != std::string::npos ||
                text.find("taken from the disk cache") != std::string::npos)
        << text;
    EXPECT_EQ(text.back(), '\n');
}

TEST(Log, IsSilentUnlessItIsAskedFor) {
    for (const char* value : {static_cast<const char*>(nullptr), "", "0"})
        EXPECT_EQ(logged(value).find("rsh: "), std::string::npos);
    testing::internal::CaptureStderr();
    EXPECT_EQ(reduced(rsh::Device()), kKept);
    EXPECT_EQ(testing::internal::GetCapturedStderr().find("rsh: "), std::string::npos);
}

}  // namespace
