#include "host.hpp"

#include <sys/utsname.h>

namespace bench {

std::string host_instruction_set() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return "avx512f";
    if (__builtin_cpu_supports("avx2")) return "avx2";
    if (__builtin_cpu_supports("avx")) return "avx";
    return "sse2";
#else
    utsname names;
    return ::uname(&names) == 0 ? names.machine : "unknown";
#endif
}

}  // namespace bench
