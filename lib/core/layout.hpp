// layout.hpp - a scratch buffer's parts, declared once: the same object answers the size query
// and, through Scratch, hands out the parts. Allocates nothing.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rsh {

class Layout {
public:
    explicit Layout(size_t alignment) : alignment_(alignment) {}

    void add(std::string name, size_t bytes) {
        parts_.push_back({std::move(name), bytes_, bytes});
        bytes_ += (bytes + alignment_ - 1) / alignment_ * alignment_;
    }
    template <class T>
    void add_array(std::string name, size_t count) {
        add(std::move(name), count * sizeof(T));
    }

    struct Part {
        std::string name;
        size_t offset;
        size_t bytes;
    };
    const std::vector<Part>& parts() const { return parts_; }
    size_t bytes() const { return bytes_; }

private:
    size_t alignment_;
    size_t bytes_ = 0;
    std::vector<Part> parts_;
};

}  // namespace rsh
