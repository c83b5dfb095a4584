// text_scan.hpp - tokens, lines and numbers of the text formats, over a view of the whole file.
// Numbers are read as C reads them, independent of the locale: with nan, inf and values beyond
// a float's range, all of which std::istream refuses. Knows no format.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace render {

// A file that cannot be loaded; the message names the file.
struct LoadError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The whole token as a number; nothing when a character is left over. Beyond the range of a
// double the result is an infinity or zero.
std::optional<double> parse_number(std::string_view token);
std::optional<long long> parse_integer(std::string_view token);

// Throws LoadError for bytes that are no text, or text of wider characters. `name` starts it.
void require_text(std::string_view bytes, const std::string& name);

// Removes what may stand before the first keyword of a text: blanks and UTF-8 byte order marks.
std::string_view without_mark(std::string_view text);

// Removes blanks from both ends.
std::string_view trimmed(std::string_view text);

// Takes the first token, and the blanks before it, off `text`; empty at its end.
std::string_view take_token(std::string_view& text);

// Takes the first line off `text`, without its line end (LF, CR LF or CR).
std::string_view take_line(std::string_view& text);

std::string lower_case(std::string_view text);

}  // namespace render
