// line_feed.hpp - a text file as a stream that ends after each line until the next one is asked
// for. A parser that calls back in the middle of the stream can so be told which line it is in,
// and each line can be edited into a form that the parser knows.
#pragma once

#include <functional>
#include <streambuf>
#include <string>
#include <string_view>

namespace render {

class LineFeed : public std::streambuf {
public:
    using Edit = std::function<void(std::string& line)>;
    LineFeed(std::string_view text, Edit edit) : rest_(text), edit_(std::move(edit)) {}

    // The line handed out last, as edited; and its number, from 1.
    const std::string& line() const { return line_; }
    size_t number() const { return number_; }

protected:
    int_type underflow() override;

private:
    std::string_view rest_;
    Edit edit_;
    std::string line_;
    size_t number_ = 0;
};

}  // namespace render
