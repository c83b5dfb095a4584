// device_bytes.hpp - how many bytes of OpenCL's buffers exist in this process, as the counting layer sees
// it from outside of the library: tests/support/layers/counts.hpp.
#pragma once

#include "support/layers/counts.hpp"

namespace bench::memory {

// Names the layer that was built with this program to OpenCL's loader, if OPENCL_LAYERS names none.
// To be called before anything of OpenCL.
void load_counting_layer();

class DeviceBytes {
public:
    // Throws std::runtime_error when the loader has not taken the layer.
    DeviceBytes();

    size_t alive() const { return read().bytes_alive; }
    // Most that were alive at once since restart_peak().
    size_t peak() const { return read().bytes_peak; }
    void restart_peak() const { restart_peak_(); }

private:
    rsh_counts read() const;

    rsh_read_counts_function read_;
    rsh_restart_peak_function restart_peak_;
};

}  // namespace bench::memory
