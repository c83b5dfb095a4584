// boost_contender.cpp - boost::compute::copy_if over the same buffers and queue.
#include "reduce/libraries/libraries.hpp"

#include <boost/compute/algorithm/copy_if.hpp>
#include <boost/compute/command_queue.hpp>
#include <boost/compute/function.hpp>
#include <boost/compute/iterator/buffer_iterator.hpp>
#include <boost/compute/types/fundamental.hpp>

namespace bench {
namespace {

namespace compute = boost::compute;

BOOST_COMPUTE_FUNCTION(bool, is_kept_1, (compute::uint_ e), { return e != 0xffffffffu; });
BOOST_COMPUTE_FUNCTION(bool, is_kept_2, (compute::uint2_ e), { return e.x != 0xffffffffu; });
BOOST_COMPUTE_FUNCTION(bool, is_kept_4, (compute::uint4_ e), { return e.x != 0xffffffffu; });

template <class Element, class IsKept>
class BoostCopyIf final : public Contender {
public:
    BoostCopyIf(const Device& device, const DeviceStream& stream, const IsKept& is_kept)
        : device_(device),
          stream_(stream),
          is_kept_(is_kept),
          queue_(device.queue()(), true),
          input_(stream.input(), true),
          output_(stream.output(), true) {}

    void run() override {
        const auto begin = compute::make_buffer_iterator<Element>(input_, 0);
        const auto out = compute::make_buffer_iterator<Element>(output_, 0);
        const auto end =
            compute::copy_if(begin, begin + stream_.host.count(), out, is_kept_, queue_);
        queue_.finish();
        count_ = cl_uint(end - out);
    }
    bool is_right() const override { return is_output_right(device_, stream_, count_, true); }

private:
    const Device& device_;
    const DeviceStream& stream_;
    IsKept is_kept_;
    compute::command_queue queue_;
    compute::buffer input_, output_;
    cl_uint count_ = 0;
};

template <class Element, class IsKept>
std::unique_ptr<Contender> make(const Device& device, const DeviceStream& stream,
                                const IsKept& is_kept) {
    return std::make_unique<BoostCopyIf<Element, IsKept>>(device, stream, is_kept);
}

}  // namespace

// No type of OpenCL C has 12 bytes.
std::unique_ptr<Contender> make_boost(const Device& device, const DeviceStream& stream) {
    switch (stream.host.spec.bytes) {
        case 4:
            return make<compute::uint_>(device, stream, is_kept_1);
        case 8:
            return make<compute::uint2_>(device, stream, is_kept_2);
        case 16:
            return make<compute::uint4_>(device, stream, is_kept_4);
        default:
            return nullptr;
    }
}

}  // namespace bench
