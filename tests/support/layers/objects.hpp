// objects.hpp - the OpenCL objects that a process has made and not yet released, and the counts of
// counts.hpp. Any thread may call.
#pragma once

#include <mutex>
#include <unordered_map>

#include "support/layers/counts.hpp"

namespace layer {

enum class Kind { context, queue, buffer, sub_buffer, program, binary_program, kernel, event };

class Objects {
public:
    void count(size_t rsh_counts::*word);
    void add(void* made, Kind kind);
    void add_buffer(void* made, size_t bytes);
    void add_sub_buffer(void* made, void* buffer);
    void retain(void* object);
    void release(void* object);
    bool is_binary(void* program) const;
    rsh_counts counts() const;
    void restart_peak();
    // Ends the process where it cannot.
    void write(const char* path) const;

private:
    struct Object {
        Kind kind;
        size_t holders = 1;
        size_t bytes = 0;        // of a buffer
        void* parent = nullptr;  // of a sub-buffer
    };

    void insert(void* made, const Object& object);
    void drop(void* object);

    mutable std::mutex mutex_;
    std::unordered_map<void*, Object> alive_;
    rsh_counts counts_ = {};
};

// Never destroyed: a program's last calls come late.
Objects& objects();

}  // namespace layer
