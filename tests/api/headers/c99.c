/* c99.c - rsh_interface.h, and with it rsh.h, alone and first, as strict C99. Compiling is the test. */
#include <rsh/rsh_interface.h>

rsh_status rsh_header_is_c99(const rsh_reduce_desc* desc);

rsh_status rsh_header_is_c99(const rsh_reduce_desc* desc) {
    return desc->struct_size == sizeof *desc ? RSH_SUCCESS : RSH_INVALID_VALUE;
}
