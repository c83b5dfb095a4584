// findings.hpp - compares what a device made of operands with what it should have, and keeps the
// first mistake of each property.
#pragma once

#include <string>

#include "arithmetic/cases.hpp"
#include "arithmetic/device_results.hpp"

namespace rsh {

class Findings {
public:
    // correctly_rounded: quotients and roots are to be.
    explicit Findings(bool correctly_rounded) : correctly_rounded_(correctly_rounded) {}

    // Results from index `first` on are those of the cases.
    void compare(const Cases& cases, const DeviceResults& results, size_t first);

    static constexpr cl_uint kProperties = RSH_ARITHMETIC_CONVERSION + 1;
    std::string mistake[kProperties];  // "": none
    cl_uint compared = 0;
    bool flushes_denormals = false;

private:
    bool is_accepted(const Operation& operation, const Operands& operands, double found,
                     bool is_tiny);
    double ulps_of(const Operation& operation) const;

    bool correctly_rounded_;
};

}  // namespace rsh
