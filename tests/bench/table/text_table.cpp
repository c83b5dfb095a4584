#include "table/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace bench {
namespace {

std::string without_spaces_behind(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

bool is_caption(const TextTable::Row& row) {
    return row.size() == 1;
}

}  // namespace

std::string TextTable::text() const {
    std::vector<size_t> widths(rows_.front().size(), 0);
    for (const Row& row : rows_)
        for (size_t i = 0; i < row.size() && !is_caption(row); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (size_t begin = labels_; begin < widths.size();) {
        size_t end = begin, width = 0;
        for (size_t i = 0; i < labels_; ++i) width += widths[i] + 2;
        while (end < widths.size() && (end == begin || width + widths[end] <= kPageWidth))
            width += widths[end++] + 2;
        text += (begin > labels_ ? "\n" : "") + part(begin, end, widths);
        begin = end;
    }
    return text;
}

std::string TextTable::part(size_t begin, size_t end, const std::vector<size_t>& widths) const {
    std::string text;
    for (const Row& row : rows_) {
        if (is_caption(row)) {
            text += wrapped(row.front());
            continue;
        }
        std::string line;
        for (size_t i = 0; i < labels_; ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
        for (size_t i = begin; i < std::min(end, row.size()); ++i)
            line += fmt::format("{:>{}}  ", row[i], widths[i]);
        text += without_spaces_behind(line) + '\n';
    }
    return text;
}

std::string wrapped(const std::string& text, size_t indent) {
    std::istringstream words(text);
    std::string lines, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > kPageWidth) {
            lines += line + '\n';
            line = std::string(indent - 1, ' ');
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return lines + line + '\n';
}

}  // namespace bench
