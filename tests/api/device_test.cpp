// device_test.cpp - rsh::Device makes what rsh's calls need, owns it, makes the calls, and logs when
// it is told to.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <rsh/rsh.hpp>
#include <vector>

#include "support/device.hpp"

namespace {

// Packs a few words, so that a program is compiled, or taken from the cache.
std::vector<cl_uint> reduced(const rsh::Device& device) {
    const std::vector<cl_uint> words = {5, RSH_NO_HIT, 7, RSH_NO_HIT, 9};
    const rsh::Buffer in = device.upload(words), out = device.buffer(words.size() * 4),
                      count = device.buffer(sizeof(cl_uint));
    auto desc = rsh::make<rsh_reduce_desc>();
    desc.keep = RSH_KEEP_NOT_NULL;
    desc.element_bytes = 4;
    desc.count = static_cast<cl_uint>(words.size());
    desc.input = in.get();
    desc.output = out.get();
    desc.output_count = count.get();
    device.run(rsh_reduce, desc);
    clFinish(device.queue());
    const cl_uint kept = device.download<cl_uint>(count.get(), 1)[0];
    return device.download<cl_uint>(out.get(), kept);
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

TEST(Device, BuffersAreItsOwnAndFreeThemselves) {
    const rsh::Device device;
    cl::Buffer kept;
    {
        const rsh::Buffer buffer = device.upload(std::vector<cl_ushort>{1, 2, 3});
        kept = cl::Buffer(buffer.get(), true);
        EXPECT_EQ(kept.getInfo<CL_MEM_SIZE>(), 6u);
        EXPECT_EQ(kept.getInfo<CL_MEM_CONTEXT>()(), device.context());
        device.write(buffer.get(), std::vector<cl_ushort>{4, 5});
        EXPECT_EQ(device.download<cl_ushort>(buffer.get(), 3),
                  (std::vector<cl_ushort>{4, 5, 3}));
        EXPECT_EQ(kept.getInfo<CL_MEM_REFERENCE_COUNT>(), 2u);
    }
    EXPECT_EQ(kept.getInfo<CL_MEM_REFERENCE_COUNT>(), 1u);
}

TEST(Device, EmptyArraysAreNoBuffer) {
    const rsh::Device device;
    EXPECT_EQ(device.upload(std::vector<cl_uint>()).get(), nullptr);
    EXPECT_EQ(device.buffer(0).get(), nullptr);
    device.write(nullptr, std::vector<cl_uint>());
    EXPECT_TRUE(device.download<cl_uint>(nullptr, 0).empty());
}

// Each of the calls that enqueue has this form, and each query that of rsh_build_query.
TEST(Device, RunsCallsBehindEvents) {
    const rsh::Device device;
    cl::UserEvent go(cl::Context(device.context(), true));
    const rsh::Buffer rays = device.buffer(64 * sizeof(rsh_ray));
    auto build = rsh::make<rsh_build_desc>();
    build.rays = rays.get();
    build.width = 64;
    const size_t bytes = device.sizes_of(rsh_build_query, build).output_bytes;
    EXPECT_GT(bytes, 0u);
    const rsh::Buffer nodes = device.buffer(bytes);
    build.nodes = nodes.get();
    const rsh::Event done = device.run(rsh_build, build, {go()});
    clFlush(device.queue());
    const cl::Event seen(done.get(), true);
    EXPECT_GT(seen.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>(), CL_COMPLETE);
    go.setStatus(CL_COMPLETE);
    seen.wait();
}

TEST(Device, RefusedCallsAreErrorsThatNameTheField) {
    const rsh::Device device;
    auto build = rsh::make<rsh_build_desc>();
    build.width = 64;
    build.shape = 99;
    for (const bool is_query : {true, false}) try {
            is_query ? void(device.sizes_of(rsh_build_query, build))
                     : void(device.run(rsh_build, build));
            FAIL() << "there is no shape 99";
        } catch (const rsh::Error& error) {
            EXPECT_EQ(error.status(), RSH_INVALID_VALUE);
            EXPECT_NE(std::string(error.what()).find("shape"), std::string::npos);
        }
    try {
        rsh::check(rsh_build(device.rsh(), nullptr, &build, 0, nullptr, nullptr), "rsh_build");
        FAIL() << "there is no queue";
    } catch (const rsh::Error& error) {
        EXPECT_EQ(std::string(error.what()).find("rsh_build: RSH_INVALID_VALUE"), 0u)
            << error.what();
    }
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
