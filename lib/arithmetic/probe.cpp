#include "arithmetic/probe.hpp"

#include <cstring>

#include "arithmetic/findings.hpp"
#include "device/error.hpp"

namespace rsh {
namespace {

// In the order of their values.
const char* const kNames[] = {"rounding", "contraction", "fma",
                              "division", "square root", "comparison",
                              "infinity", "underflow",   "conversion"};
static_assert(sizeof kNames / sizeof *kNames == Findings::kProperties,
              "each property has a name");

std::vector<Operands> joined(const std::vector<Cases>& sets) {
    std::vector<Operands> all;
    for (const Cases& cases : sets)
        all.insert(all.end(), cases.operands.begin(), cases.operands.end());
    return all;
}

// One at a time, and in the vectors of the context.
void probe(Context& context, cl_command_queue queue, Findings& findings) {
    const std::vector<Cases> sets = arithmetic_cases();
    const std::vector<Operands> operands = joined(sets);
    for (const cl_uint lanes : {1u, context.vector_width}) {
        const DeviceResults results(context, queue, operands, lanes);
        size_t first = 0;
        for (const Cases& cases : sets) {
            findings.compare(cases, results, first);
            first += cases.operands.size();
        }
        if (context.vector_width == 1) break;
    }
}

void tell(const Context& context, const Findings& findings, rsh_selftest& report) {
    report.tested_arithmetic = (1u << Findings::kProperties) - 1;
    report.arithmetic_cases = findings.compared;
    report.flushes_denormals = findings.flushes_denormals;
    for (cl_uint property = 0; property < Findings::kProperties; ++property) {
        if (findings.mistake[property].empty()) continue;
        const std::string text = kNames[property] + (": " + findings.mistake[property]);
        context.log("arithmetic that does not hold: " + text);
        if (report.wrong_arithmetic == 0)
            std::strncpy(report.arithmetic_failure, text.c_str(),
                         sizeof report.arithmetic_failure - 1);
        report.wrong_arithmetic |= 1u << property;
    }
}

}  // namespace

const char* arithmetic_name(cl_uint property) {
    return property < Findings::kProperties ? kNames[property] : nullptr;
}

// A driver may also refuse to compile or to run the probes: then nothing is known to hold.
void probe_arithmetic(Context& context, cl_command_queue queue, rsh_selftest& report) {
    Findings findings(context.caps.correctly_rounded);
    try {
        probe(context, queue, findings);
    } catch (const Error& error) {
        for (std::string& mistake : findings.mistake) mistake = error.what();
    }
    tell(context, findings, report);
}

}  // namespace rsh
