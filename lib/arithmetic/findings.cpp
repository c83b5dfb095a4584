#include "arithmetic/findings.hpp"

#include <cmath>
#include <cstdio>

namespace rsh {
namespace {

double rounded(double value) {
    return static_cast<float>(value);
}

bool agrees(const Operation& operation, double found, double answer, double ulps) {
    return operation.is_integer ? found == answer
                                : is_right(static_cast<float>(found), answer, ulps);
}

// What a wrong result says about the device.
cl_uint property_of(const Operation& operation, double answer, bool is_tiny) {
    if (is_tiny) return RSH_ARITHMETIC_UNDERFLOW;
    const bool is_computed = operation.property < RSH_ARITHMETIC_COMPARISON;
    if (is_computed && !std::isfinite(rounded(answer))) return RSH_ARITHMETIC_INFINITY;
    return operation.property;
}

std::string told(const Operation& operation, const Operands& o, double found, double answer,
                 cl_uint lanes) {
    char line[256];
    std::snprintf(
        line, sizeof line,
        "%s is %.10g, must be %.10g, for a = %.9g, b = %.9g, c = %.9g, d = %.9g, lanes: %u",
        operation.text, found, operation.is_integer ? answer : rounded(answer), o.a, o.b, o.c,
        o.d, lanes);
    return line;
}

}  // namespace

double Findings::ulps_of(const Operation& operation) const {
    if (correctly_rounded_) return 0;
    if (operation.property == RSH_ARITHMETIC_DIVISION) return kQuotientUlps;
    return operation.property == RSH_ARITHMETIC_SQUARE_ROOT ? kRootUlps : 0;
}

// Of the tiny, a device may take operands and results for 0.
bool Findings::is_accepted(const Operation& operation, const Operands& operands, double found,
                           bool is_tiny) {
    const double answer = operation.answer(operands), ulps = ulps_of(operation);
    const bool is_right = agrees(operation, found, answer, ulps);
    if (!is_tiny) return is_right;
    const bool is_flushed = !is_right || (found == 0 && rounded(answer) != 0);
    if (!is_right && !agrees(operation, found, operation.answer(flushed(operands)), ulps))
        return false;
    flushes_denormals |= is_flushed;
    return true;
}

void Findings::compare(const Cases& cases, const DeviceResults& results, size_t first) {
    for (const Operation& operation : operations()) {
        if (!(cases.probe_rows >> operation.row & 1)) continue;
        for (size_t i = 0; i < cases.operands.size(); ++i) {
            const Operands& operands = cases.operands[i];
            const double found = operation.is_integer
                                     ? results.as_int(operation.row, first + i)
                                     : results.as_float(operation.row, first + i);
            ++compared;
            if (is_accepted(operation, operands, found, cases.is_tiny)) continue;
            const double answer = operation.answer(operands);
            std::string& first_mistake = mistake[property_of(operation, answer, cases.is_tiny)];
            if (first_mistake.empty())
                first_mistake = told(operation, operands, found, answer, results.lanes());
        }
    }
}

}  // namespace rsh
