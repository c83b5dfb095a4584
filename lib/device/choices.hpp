// choices.hpp - the engines, shapes or strategies that there are. A list that takes no memory: names
// are looked up where no failure can be told.
#pragma once

#include <cstddef>

namespace rsh {

template <class Choice>
class Choices {
public:
    template <size_t Count>
    constexpr Choices(const Choice* const (&all)[Count]) : begin_(all), end_(all + Count) {}

    const Choice* const* begin() const { return begin_; }
    const Choice* const* end() const { return end_; }
    const Choice& front() const { return **begin_; }

private:
    const Choice* const* begin_;
    const Choice* const* end_;
};

}  // namespace rsh
