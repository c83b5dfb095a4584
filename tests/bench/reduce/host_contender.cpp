// host_contender.cpp - std::copy_if on one core.
#include "reduce/host_copy_if.hpp"

namespace bench {
namespace {

struct OneCore {
    template <class In, class Out, class IsKept>
    Out operator()(In first, In last, Out output, IsKept is_kept) const {
        return std::copy_if(first, last, output, is_kept);
    }
};

}  // namespace

std::unique_ptr<Contender> make_host(const DeviceStream& stream) {
    return make_host_copy_if<OneCore>(stream.host);
}

}  // namespace bench
