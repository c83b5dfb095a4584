/* c99.c - rsh.h alone, first and twice, as strict C99. Compiling is the test. */
#include <rsh/rsh.h>

rsh_status rsh_header_is_c99(const rsh_reduce_desc* desc);

rsh_status rsh_header_is_c99(const rsh_reduce_desc* desc) {
    return desc->struct_size == sizeof *desc ? RSH_SUCCESS : RSH_INVALID_VALUE;
}
