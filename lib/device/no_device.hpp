// no_device.hpp - what to say when OpenCL has platforms, but no device. Asks OpenCL nothing.
#pragma once

#include <string>

namespace rsh {

// `platforms` are the names of those that are there. PoCL offers no device when it cannot write to
// its cache; the message then names the variable of the environment that says where that is.
std::string no_device_text(const std::string& platforms);

}  // namespace rsh
