#include "programs/ptxas_log.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace bench {
namespace {

// The number in front of `what`; 0 where there is none.
unsigned number_before(const std::string& what, const std::string& line) {
    std::smatch found;
    const std::regex number("(\\d+) " + what);
    return std::regex_search(line, found, number) ? unsigned(std::stoul(found[1])) : 0;
}

void read_line(const std::string& line, PtxasFigures& kernel) {
    const unsigned stack = std::max(number_before("bytes stack frame", line),
                                    number_before("bytes cumulative stack size", line));
    kernel.stack_bytes = std::max(kernel.stack_bytes, stack);
    kernel.spill_store_bytes += number_before("bytes spill stores", line);
    kernel.spill_load_bytes += number_before("bytes spill loads", line);
    kernel.registers = std::max(kernel.registers, number_before("registers", line));
    kernel.shared_bytes = std::max(kernel.shared_bytes, number_before("bytes smem", line));
}

}  // namespace

// A part begins with the line that names an entry function and ends with that of its registers.
// Functions that were not inlined follow, and could be of any kernel.
std::map<std::string, PtxasFigures> read_ptxas_log(const std::string& log) {
    static const std::regex entry("Compiling entry function '([^']+)'");
    std::map<std::string, PtxasFigures> kernels;
    PtxasFigures* kernel = nullptr;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        std::smatch found;
        if (std::regex_search(line, found, entry))
            kernel = &kernels[found[1]];
        else if (kernel)
            read_line(line, *kernel);
        if (kernel && kernel->registers > 0) kernel = nullptr;
    }
    return kernels;
}

}  // namespace bench
