// allocation.cpp - host memory that runs out when faults.hpp says so. With glibc malloc itself, and
// so what operator new, folders and exceptions take; under a sanitizer, which has its own malloc,
// operator new alone.
#include <cerrno>
#include <cstdlib>
#include <new>

#include "faults/faults.hpp"

namespace {

bool runs_out() noexcept {
    if (!faults::fails_now(faults::Kind::memory, "malloc")) return false;
    errno = ENOMEM;
    return true;
}

}  // namespace

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): glibc's.
void* __libc_malloc(size_t bytes);
void* __libc_calloc(size_t count, size_t bytes);
void* __libc_realloc(void* memory, size_t bytes);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

void* malloc(size_t bytes) {
    return runs_out() ? nullptr : __libc_malloc(bytes);
}

void* calloc(size_t count, size_t bytes) {
    return runs_out() ? nullptr : __libc_calloc(count, bytes);
}

void* realloc(void* memory, size_t bytes) {
    return runs_out() ? nullptr : __libc_realloc(memory, bytes);
}

}  // extern "C"

#else

void* operator new(size_t bytes) {
    void* const memory = runs_out() ? nullptr : std::malloc(bytes ? bytes : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void* operator new[](size_t bytes) {
    return operator new(bytes);
}

void* operator new(size_t bytes, const std::nothrow_t&) noexcept {
    return runs_out() ? nullptr : std::malloc(bytes ? bytes : 1);
}

void* operator new[](size_t bytes, const std::nothrow_t& none) noexcept {
    return operator new(bytes, none);
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete[](void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}

void operator delete[](void* memory, size_t) noexcept {
    std::free(memory);
}

#endif
