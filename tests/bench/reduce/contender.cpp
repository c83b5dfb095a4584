// contender.cpp - the library's own strategies, and the table of contenders.
#include "reduce/contender.hpp"

namespace bench {
namespace {

std::vector<cl_uchar> as_bits(const std::vector<cl_uchar>& flags) {
    std::vector<cl_uchar> bits((flags.size() + 7) / 8);
    for (size_t i = 0; i < flags.size(); ++i)
        bits[i / 8] = cl_uchar(bits[i / 8] | (flags[i] ? 1 << i % 8 : 0));
    return bits;
}

template <class T>
cl::Buffer upload(const Device& device, const std::vector<T>& data) {
    const size_t bytes = data.size() * sizeof(T);
    const cl::Buffer buffer(device.context(), CL_MEM_READ_WRITE, bytes);
    device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, data.data());
    return buffer;
}

class OwnStrategy final : public Contender {
public:
    OwnStrategy(cl_uint strategy, const Device& device, rsh_context rsh,
                const DeviceStream& stream)
        : device_(device), rsh_(rsh), stream_(stream) {
        desc_.struct_size = sizeof desc_;
        desc_.strategy = strategy;
        desc_.keep = id_of(stream.keep);
        desc_.element_bytes = stream.host.spec.bytes;
        desc_.count = stream.host.count();
        desc_.input = stream.input();
        desc_.flags = stream.flags();
        desc_.output = stream.output();
        desc_.output_count = stream.count();
    }

    void run() override {
        rsh::check(rsh_reduce(rsh_, device_.queue()(), &desc_, 0, nullptr, nullptr),
                   "rsh_reduce");
        device_.queue().finish();
    }
    bool is_right() const override {
        cl_uint count = 0;
        device_.queue().enqueueReadBuffer(stream_.count, CL_TRUE, 0, sizeof count, &count);
        return is_output_right(device_, stream_, count,
                               rsh_strategy_is_stable(desc_.strategy) != CL_FALSE);
    }
    cl_ulong launches() const override {
        rsh::check(rsh_count_statistics(rsh_, CL_TRUE), "rsh_count_statistics");
        rsh::check(rsh_reduce(rsh_, device_.queue()(), &desc_, 0, nullptr, nullptr),
                   "rsh_reduce");
        rsh_statistics statistics{};
        statistics.struct_size = sizeof statistics;
        rsh::check(rsh_get_statistics(rsh_, &statistics), "rsh_get_statistics");
        rsh::check(rsh_count_statistics(rsh_, CL_FALSE), "rsh_count_statistics");
        return statistics.launches;
    }

private:
    const Device& device_;
    rsh_context rsh_;
    const DeviceStream& stream_;
    rsh_reduce_desc desc_{};
};

}  // namespace

DeviceStream::DeviceStream(const Device& device, const Stream& stream, Keep keeps)
    : host(stream),
      keep(keeps),
      input(upload(device, stream.words)),
      output(device.context(), CL_MEM_READ_WRITE, stream.bytes()),
      count(device.context(), CL_MEM_READ_WRITE, sizeof(cl_uint)),
      copied(device.context(), CL_MEM_READ_WRITE, stream.bytes()) {
    if (keep == Keep::kFlags) flags = upload(device, stream.flags);
    if (keep == Keep::kBits) flags = upload(device, as_bits(stream.flags));
    device.queue().enqueueFillBuffer(output, cl_uint{0}, 0, stream.bytes());
    device.queue().enqueueFillBuffer(copied, cl_uint{0}, 0, stream.bytes());
    device.queue().finish();
}

const char* name_of(Keep keep) {
    constexpr const char* kNames[] = {"not_null", "flags", "bits"};
    return kNames[int(keep)];
}

cl_uint id_of(Keep keep) {
    constexpr cl_uint kIds[] = {RSH_KEEP_NOT_NULL, RSH_KEEP_FLAGS, RSH_KEEP_BITS};
    return kIds[int(keep)];
}

std::vector<std::string> peer_names() {
    std::vector<std::string> names = {"peer:copy",         "peer:copy_buffer",
                                      "peer:copy_kernel",  "peer:copy_stream",
                                      "peer:empty_launch", "peer:std_copy_if"};
    const std::vector<std::string> libraries = library_names();
    names.insert(names.end(), libraries.begin(), libraries.end());
    return names;
}

std::unique_ptr<Contender> make_contender(const std::string& name, const Device& device,
                                          rsh_context rsh, const DeviceStream& stream) {
    if (name == "peer:std_copy_if") return make_host(stream);
    for (const std::string& library : library_names())
        if (name == library) return make_library(name, device, stream);
    if (name.rfind("peer:", 0) == 0) return make_copy(name, device, stream, stream.output);
    cl_uint strategy = 0;
    rsh::check(rsh_strategy_from_name(name.c_str(), &strategy), "rsh_strategy_from_name");
    return std::make_unique<OwnStrategy>(strategy, device, rsh, stream);
}

void spoil_answer(const Device& device, const DeviceStream& stream) {
    const cl_uint none = RSH_NO_HIT;
    device.queue().enqueueFillBuffer(stream.output, none, 0, stream.host.bytes());
    device.queue().enqueueFillBuffer(stream.count, none, 0, sizeof none);
    device.queue().finish();
}

bool is_output_right(const Device& device, const DeviceStream& stream, size_t count,
                     bool is_stable) {
    if (count != stream.host.kept_count) return false;
    stream.read.resize(count * stream.host.words_per_element());
    if (!stream.read.empty())
        device.queue().enqueueReadBuffer(stream.output, CL_TRUE, 0,
                                         stream.read.size() * sizeof(cl_uint),
                                         stream.read.data());
    return is_answer(stream.host, stream.read.data(), count, is_stable);
}

}  // namespace bench
