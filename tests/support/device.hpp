// device.hpp - the OpenCL device under test: RSH_DEVICE, or the first there is.
// Without a device every test that asks for one fails; none is skipped.
#pragma once

#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_ENABLE_EXCEPTIONS
#include <CL/opencl.hpp>
#include <string>

#include <rsh/rsh.h>

namespace test {

struct Device {
    cl::Platform platform;
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;  // in order, profiling
    rsh_context rsh = nullptr;
    std::string name;

    cl::CommandQueue out_of_order_queue() const;
};

// The device, made on first use. Throws, and so fails the test, when there is none.
Device& device();

// "name (version)" of the device, or why there is none; never throws.
std::string device_name();

// An rsh_context of its own for a test that counts or releases.
class OwnContext {
public:
    explicit OwnContext(cl_uint vector_width = 0);
    // As the descriptor says, on the device under test.
    explicit OwnContext(rsh_context_desc desc);
    ~OwnContext();
    OwnContext(const OwnContext&) = delete;
    OwnContext& operator=(const OwnContext&) = delete;
    rsh_context get() const { return context_; }

private:
    rsh_context context_ = nullptr;
};

// Throws with rsh_last_error() unless the call succeeded.
void check(rsh_status status, const char* call);

}  // namespace test

#define RSH_CHECK(call) ::test::check((call), #call)
