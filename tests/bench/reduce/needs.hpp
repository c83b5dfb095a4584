// needs.hpp - what a contender of a stream will allocate, on the device and on the host.
#pragma once

#include "memory.hpp"
#include "reduce/selection.hpp"

namespace bench {

// Of streams with a count; of others none: it is known too late, and small.
std::vector<NamedBytes> buffers_of(const Heat& heat, const std::string& name, rsh_context rsh);
size_t host_bytes_of(const Heat& heat, const std::string& name);

}  // namespace bench
