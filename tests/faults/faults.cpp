// faults.cpp - which call is to fail.
#include "faults/faults.hpp"

#include <atomic>

namespace faults {
namespace {

thread_local bool armed = false;
thread_local Plan plan;
thread_local size_t count = 0;
thread_local bool failed = false;
thread_local const char* failed_name = "";
thread_local int depth = 0;
std::atomic<long> all_references{0};

}  // namespace

Armed::Armed(const Plan& wanted) {
    plan = wanted;
    count = 0;
    failed = false;
    failed_name = "";
    armed = true;
}

Armed::~Armed() {
    armed = false;
}

size_t counted() {
    return count;
}

bool any_failed() {
    return failed;
}

const char* failed_call() {
    return failed_name;
}

bool fails_now(Kind kind, const char* name) noexcept {
    if (!armed || plan.kind != kind) return false;
    if (kind == Kind::memory && depth > 0) return false;
    const size_t number = count++;
    if (number != plan.first && !(plan.and_all_after && number > plan.first)) return false;
    failed = true;
    failed_name = name;
    return true;
}

cl_int failing_code() noexcept {
    return plan.code;
}

InsideOpenCl::InsideOpenCl() noexcept {
    ++depth;
}

InsideOpenCl::~InsideOpenCl() {
    --depth;
}

bool InsideOpenCl::is_nested() const noexcept {
    return depth > 1;
}

long references() noexcept {
    return all_references;
}

void count_reference(int change) noexcept {
    all_references += change;
}

}  // namespace faults
