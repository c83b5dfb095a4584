// libraries.cpp - the list of other libraries. One row each.
#include "reduce/libraries/libraries.hpp"

namespace bench {

std::vector<std::string> library_names() {
    return {"peer:boost_compute", "peer:parallel_copy_if"};
}

std::unique_ptr<Contender> make_library(const std::string& name, const Device& device,
                                        const DeviceStream& stream) {
    if (name == "peer:boost_compute") return make_boost(device, stream);
    return make_parallel(stream);
}

}  // namespace bench
