// text_table.hpp - rows of text under heads, aligned: the first columns to the left, numbers to the
// right. What is wider than a page goes on in a second table below, with the first columns again.
#pragma once

#include <string>
#include <vector>

namespace bench {

constexpr size_t kPageWidth = 100;

class TextTable {
public:
    using Row = std::vector<std::string>;

    TextTable(Row heads, size_t labels) : rows_{std::move(heads)}, labels_(labels) {}

    void add(Row row) { rows_.push_back(std::move(row)); }
    // A line above the rows that follow.
    void add_caption(const std::string& text) { rows_.push_back({text}); }
    bool is_empty() const { return rows_.size() == 1; }
    std::string text() const;

private:
    std::string part(size_t begin, size_t end, const std::vector<size_t>& widths) const;

    std::vector<Row> rows_;
    size_t labels_;  // columns that are aligned to the left and said again
};

// Words in lines no wider than a page, all but the first indented. A longer word stays whole.
std::string wrapped(const std::string& text, size_t indent = 4);

}  // namespace bench
