// cxx11.cpp - rsh.hpp, and with it rsh.h, alone and first, as strict C++11. Compiling is the test.
#include <rsh/rsh.hpp>

static_assert(sizeof(rsh_ray) == 32 && sizeof(rsh_hit) == 16, "what the header promises");
static_assert(!std::is_copy_constructible<rsh::Device>::value &&
                  std::is_nothrow_move_constructible<rsh::Device>::value,
              "a device has one owner");
