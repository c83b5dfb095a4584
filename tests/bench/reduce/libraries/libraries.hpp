// libraries.hpp - a maker per library that reduces in this process.
#pragma once

#include "reduce/contender.hpp"

namespace bench {

std::unique_ptr<Contender> make_boost(const Device& device, const DeviceStream& stream);
std::unique_ptr<Contender> make_parallel(const DeviceStream& stream);

}  // namespace bench
