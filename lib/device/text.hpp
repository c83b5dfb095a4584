// text.hpp - puts a text together in room that is there already: to report that there is no memory
// must not take any. What does not fit is cut off.
#pragma once

#include <charconv>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace rsh {

class Text {
public:
    // `bytes` at least 1, for the end.
    Text(char* room, size_t bytes) noexcept : next_(room), last_(room + bytes - 1) {
        *next_ = '\0';
    }

    template <class... Parts>
    Text& add(const Parts&... parts) noexcept {
        (add_one(parts), ...);
        return *this;
    }

private:
    void add_one(std::string_view part) noexcept {
        const size_t bytes =
            part.size() < size_t(last_ - next_) ? part.size() : size_t(last_ - next_);
        std::memmove(next_, part.data(), bytes);
        next_ += bytes;
        *next_ = '\0';
    }

    void add_one(char part) noexcept { add_one(std::string_view(&part, 1)); }

    template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
    void add_one(Number part) noexcept {
        char digits[32];
        if constexpr (std::is_floating_point_v<Number>) {
            std::snprintf(digits, sizeof digits, "%.9g", double(part));
            add_one(std::string_view(digits));
        } else {
            const char* const end = std::to_chars(digits, digits + sizeof digits, part).ptr;
            add_one(std::string_view(digits, size_t(end - digits)));
        }
    }

    char* next_;
    char* last_;
};

}  // namespace rsh
