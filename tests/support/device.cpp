// device.cpp - rsh::Device in the words of the C++ bindings. Made once per process: programs that
// a test has built serve the next.
#include "support/device.hpp"

#include <rsh/rsh.hpp>

namespace test {
namespace {

Device make_device() {
    static ::rsh::Device* const own =
        new ::rsh::Device(nullptr, CL_QUEUE_PROFILING_ENABLE, ::rsh::log_from_environment());
    Device made;
    made.platform = cl::Platform(own->platform());
    made.device = cl::Device(own->device(), true);
    made.context = cl::Context(own->context(), true);
    made.queue = cl::CommandQueue(own->queue(), true);
    made.rsh = own->rsh();
    made.name = made.device.getInfo<CL_DEVICE_NAME>() + " (" +
                made.device.getInfo<CL_DRIVER_VERSION>() + ")";
    return made;
}

}  // namespace

Device& device() {
    static Device* const made = new Device(make_device());
    return *made;
}

std::string device_name() {
    try {
        return device().name;
    } catch (const std::exception& error) {
        return std::string("none: ") + error.what();
    }
}

cl::CommandQueue Device::out_of_order_queue() const {
    const auto supported = device.getInfo<CL_DEVICE_QUEUE_PROPERTIES>();
    const cl_command_queue_properties wanted = CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE;
    return {context, device, supported & wanted};
}

OwnContext::OwnContext(cl_uint vector_width)
    : OwnContext([vector_width] {
          rsh_context_desc desc = {};
          desc.vector_width = vector_width;
          return desc;
      }()) {}

OwnContext::OwnContext(rsh_context_desc desc) {
    desc.struct_size = sizeof desc;
    desc.context = device().context();
    desc.device = device().device();
    RSH_CHECK(rsh_create_context(&desc, &context_));
}

OwnContext::~OwnContext() {
    rsh_release_context(context_);
}

void check(rsh_status status, const char* call) {
    ::rsh::check(status, call);
}

}  // namespace test
