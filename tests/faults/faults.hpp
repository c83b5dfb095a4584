// faults.hpp - makes chosen calls of rsh fail inside: allocations of host memory, or calls of OpenCL.
// Both are taken over by this program (allocation.cpp, opencl.cpp); only what rsh asks for on the
// thread of an armed call counts, never what OpenCL asks for itself.
#pragma once

#include <rsh/rsh.h>

#include <cstddef>
#include <string>

namespace faults {

enum class Kind { none, memory, opencl };

struct Plan {
    Kind kind = Kind::none;
    size_t first = 0;  // the first one that fails, from 0
    bool and_all_after = false;
    cl_int code = 0;  // opencl: what it returns
};

// From its making to its end, on this thread. What it counts stays to be read.
class Armed {
public:
    explicit Armed(const Plan& plan);
    ~Armed();
    Armed(const Armed&) = delete;
    Armed& operator=(const Armed&) = delete;
};

// How many of the last armed kind there were, whether any failed, and the name of the last call of
// OpenCL that did.
size_t counted();
bool any_failed();
const char* failed_call();

// For those who take over calls: whether the next one is to fail.
bool fails_now(Kind kind, const char* name) noexcept;
cl_int failing_code() noexcept;

// While one lives, allocations are OpenCL's.
class InsideOpenCl {
public:
    InsideOpenCl() noexcept;
    ~InsideOpenCl();
    InsideOpenCl(const InsideOpenCl&) = delete;
    InsideOpenCl& operator=(const InsideOpenCl&) = delete;
    // Whether OpenCL called itself.
    bool is_nested() const noexcept;
};

// References to OpenCL objects that this program holds, by the calls that made and released them.
long references() noexcept;
void count_reference(int change) noexcept;

}  // namespace faults
