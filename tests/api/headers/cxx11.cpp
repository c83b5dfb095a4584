// cxx11.cpp - rsh.h alone and first, as strict C++11. Compiling is the test.
#include <rsh/rsh.h>

static_assert(sizeof(rsh_ray) == 32 && sizeof(rsh_hit) == 16, "what the header promises");
