// objects.cpp - a table of handles, each with how often it is held.
#include "support/layers/objects.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace layer {
namespace {

size_t rsh_counts::*alive_of(Kind kind) {
    switch (kind) {
        case Kind::context:
            return &rsh_counts::contexts_alive;
        case Kind::queue:
            return &rsh_counts::queues_alive;
        case Kind::buffer:
            return &rsh_counts::buffers_alive;
        case Kind::sub_buffer:
            return &rsh_counts::sub_buffers_alive;
        case Kind::program:
        case Kind::binary_program:
            return &rsh_counts::programs_alive;
        case Kind::kernel:
            return &rsh_counts::kernels_alive;
        case Kind::event:
            return &rsh_counts::events_alive;
    }
    std::abort();
}

}  // namespace

Objects& objects() {
    static Objects* const all = new Objects;
    return *all;
}

void Objects::count(size_t rsh_counts::*word) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++(counts_.*word);
}

void Objects::insert(void* made, const Object& object) {
    alive_[made] = object;
    ++(counts_.*alive_of(object.kind));
    if (object.kind == Kind::kernel) ++counts_.kernels;
}

void Objects::add(void* made, Kind kind) {
    const std::lock_guard<std::mutex> lock(mutex_);
    insert(made, Object{kind});
}

void Objects::add_buffer(void* made, size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    insert(made, Object{Kind::buffer, 1, bytes});
    ++counts_.buffers;
    counts_.bytes_alive += bytes;
    counts_.bytes_peak = std::max(counts_.bytes_peak, counts_.bytes_alive);
}

void Objects::add_sub_buffer(void* made, void* buffer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    insert(made, Object{Kind::sub_buffer, 1, 0, buffer});
    ++counts_.sub_buffers;
    const auto parent = alive_.find(buffer);
    if (parent != alive_.end()) ++parent->second.holders;
}

void Objects::retain(void* object) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = alive_.find(object);
    if (found != alive_.end()) ++found->second.holders;
}

void Objects::release(void* object) {
    const std::lock_guard<std::mutex> lock(mutex_);
    drop(object);
}

void Objects::drop(void* object) {
    const auto found = alive_.find(object);
    if (found == alive_.end() || --found->second.holders > 0) return;
    const Object gone = found->second;
    alive_.erase(found);
    --(counts_.*alive_of(gone.kind));
    counts_.bytes_alive -= gone.bytes;
    if (gone.parent) drop(gone.parent);
}

bool Objects::is_binary(void* program) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = alive_.find(program);
    return found != alive_.end() && found->second.kind == Kind::binary_program;
}

rsh_counts Objects::counts() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return counts_;
}

void Objects::restart_peak() {
    const std::lock_guard<std::mutex> lock(mutex_);
    counts_.bytes_peak = counts_.bytes_alive;
}

void Objects::write(const char* path) const {
    const rsh_counts now = counts();
    std::FILE* const file = std::fopen(path, "w");
    bool is_written = file != nullptr;
    const char* before = "{";
    const auto write_word = [&](const char* name, size_t value) {
        is_written =
            is_written && std::fprintf(file, "%s\n  \"%s\": %zu", before, name, value) > 0;
        before = ",";
    };
#define RSH_WRITE(name) write_word(#name, now.name);
    RSH_COUNTS(RSH_WRITE)
#undef RSH_WRITE
    is_written = is_written && std::fputs("\n}\n", file) >= 0;
    if (file) is_written = std::fclose(file) == 0 && is_written;
    if (is_written) return;
    std::fprintf(stderr, "counts: cannot write RSH_COUNTS %s\n", path);
    std::_Exit(1);
}

}  // namespace layer
