// off_binary.hpp - the body of an OFF file whose first line ends with BINARY.
#pragma once

#include "import/off_header.hpp"
#include "model/soup.hpp"

namespace render {

// `body` starts behind the first line. Numbers are big-endian, of 4 bytes.
Soup read_off_binary(std::string_view body, const OffKeyword& keyword, const std::string& name);

}  // namespace render
