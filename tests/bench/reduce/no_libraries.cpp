// no_libraries.cpp - in place of libraries/, without RSH_BENCH_PEERS.
#include "reduce/contender.hpp"

namespace bench {

std::vector<std::string> library_names() {
    return {};
}

std::unique_ptr<Contender> make_library(const std::string&, const Device&,
                                        const DeviceStream&) {
    return nullptr;
}

}  // namespace bench
