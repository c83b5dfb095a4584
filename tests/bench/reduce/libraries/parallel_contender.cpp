// parallel_contender.cpp - std::copy_if on all cores, by the parallel policy (oneTBB).
#include "reduce/libraries/libraries.hpp"

#include <execution>

#include "reduce/host_copy_if.hpp"

namespace bench {
namespace {

struct AllCores {
    template <class In, class Out, class IsKept>
    Out operator()(In first, In last, Out output, IsKept is_kept) const {
        return std::copy_if(std::execution::par, first, last, output, is_kept);
    }
};

}  // namespace

std::unique_ptr<Contender> make_parallel(const DeviceStream& stream) {
    return make_host_copy_if<AllCores>(stream.host);
}

}  // namespace bench
