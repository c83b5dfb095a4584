// line_feed.cpp - joins lines that end with a backslash. Files that were put one behind the other
// have byte order marks in the middle.
#include "import/line_feed.hpp"

#include "files/text_scan.hpp"

namespace render {

LineFeed::int_type LineFeed::underflow() {
    if (rest_.empty()) return traits_type::eof();
    line_.clear();
    bool goes_on = true;
    while (goes_on && !rest_.empty()) {
        std::string_view part = without_mark(take_line(rest_));
        ++number_;
        goes_on = !part.empty() && part.back() == '\\';
        if (goes_on) part.remove_suffix(1);
        line_.append(part).append(goes_on ? " " : "");
    }
    edit_(line_);
    line_ += '\n';
    setg(line_.data(), line_.data(), line_.data() + line_.size());
    return traits_type::to_int_type(line_[0]);
}

}  // namespace render
