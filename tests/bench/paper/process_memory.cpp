#include "paper/process_memory.hpp"

#include <sys/resource.h>

namespace bench::paper {

size_t process_peak_bytes() {
    rusage usage{};
    return getrusage(RUSAGE_SELF, &usage) == 0 ? size_t(usage.ru_maxrss) * 1024 : 0;
}

}  // namespace bench::paper
