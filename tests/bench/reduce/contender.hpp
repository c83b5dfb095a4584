// contender.hpp - who takes part: the library's strategies, copies, and other libraries, each
// called as its users call it. run() works on one stream, waits for the end and can be repeated.
#pragma once

#include <memory>

#include "device.hpp"
#include "reduce/stream.hpp"

namespace bench {

// What "kept" is told by.
enum class Keep { kNotNull, kFlags, kBits };
const char* name_of(Keep keep);
cl_uint id_of(Keep keep);  // RSH_KEEP_...

// A stream in the memory of the device; all contenders of one context share it.
struct DeviceStream {
    DeviceStream(const Device& device, const Stream& stream, Keep keep);

    const Stream& host;
    Keep keep;
    cl::Buffer input, output, count;
    cl::Buffer flags;  // bytes or bits; none where the elements themselves tell
    // Where the copy goes that contenders are compared with. Not the output: one that stores
    // past the caches would leave that in memory, one that does not would bring it close, for
    // whoever comes next.
    cl::Buffer copied;
    mutable std::vector<cl_uint> read;  // where outputs are read to, to be checked
};

class Contender {
public:
    virtual ~Contender() = default;
    virtual void run() = 0;
    virtual bool is_right() const = 0;               // what the last run gave
    virtual cl_ulong launches() const { return 0; }  // 0: not known
};

// Makes the contender of that name for a stream; null if it cannot take it. Throws
// std::runtime_error when there is none of that name.
//   a strategy's name; peer:copy_buffer, clEnqueueCopyBuffer; peer:copy_kernel, a kernel;
//   peer:copy, the quicker one of these; peer:copy_stream, a kernel that stores past the caches;
//   peer:empty_launch; peer:std_copy_if; a library's name
std::unique_ptr<Contender> make_contender(const std::string& name, const Device& device,
                                          rsh_context rsh, const DeviceStream& stream);
std::vector<std::string> peer_names();  // in this process

std::unique_ptr<Contender> make_copy(const std::string& name, const Device& device,
                                     const DeviceStream& stream, const cl::Buffer& to);
std::unique_ptr<Contender> make_host(const DeviceStream& stream);

// Other libraries in this process: those of the folder libraries/, or none without
// RSH_BENCH_PEERS. make_library() takes only these names.
std::vector<std::string> library_names();
std::unique_ptr<Contender> make_library(const std::string& name, const Device& device,
                                        const DeviceStream& stream);

// Lest a contender that writes nothing be judged by the answer of the one before it. Nobody keeps an
// element that begins with RSH_NO_HIT.
void spoil_answer(const Device& device, const DeviceStream& stream);

// Reads the output: whether its first `count` elements are the answer.
bool is_output_right(const Device& device, const DeviceStream& stream, size_t count,
                     bool is_stable);

}  // namespace bench
