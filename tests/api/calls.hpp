// calls.hpp - the calls by the type of their descriptor, so that one template tests all of them, and
// what they must say when they refuse.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/device.hpp"

namespace test {

inline rsh_status call(const rsh_rasterize_desc* d, cl_event* e = nullptr) {
    return rsh_rasterize(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_bound_desc* d, cl_event* e = nullptr) {
    return rsh_bound(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_build_desc* d, cl_event* e = nullptr) {
    return rsh_build(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_traverse_desc* d, cl_event* e = nullptr) {
    return rsh_traverse(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_trace_desc* d, cl_event* e = nullptr) {
    return rsh_trace(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_audit_desc* d, cl_event* e = nullptr) {
    return rsh_audit(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_spawn_desc* d, cl_event* e = nullptr) {
    return rsh_spawn(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_spawn_wave_desc* d, cl_event* e = nullptr) {
    return rsh_spawn_wave(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_gather_wave_desc* d, cl_event* e = nullptr) {
    return rsh_gather_wave(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_shadow_desc* d, cl_event* e = nullptr) {
    return rsh_shadow(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_find_surfaces_desc* d, cl_event* e = nullptr) {
    return rsh_find_surfaces(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_shade_desc* d, cl_event* e = nullptr) {
    return rsh_shade(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_frame_desc* d, cl_event* e = nullptr) {
    return rsh_frame(device().rsh, device().queue(), d, 0, nullptr, e);
}
inline rsh_status call(const rsh_reduce_desc* d, cl_event* e = nullptr) {
    return rsh_reduce(device().rsh, device().queue(), d, 0, nullptr, e);
}

// Every word is in rsh_last_error().
inline void expect_said(const std::vector<std::string>& words) {
    const std::string message = rsh_last_error();
    for (const std::string& word : words)
        EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
}

}  // namespace test
