// write_output.cpp - the moment at which a signal still counts.
#include "cli/write_output.hpp"

#include "cli/interrupt.hpp"
#include "files/whole_file.hpp"

namespace render {

void write_output(const std::string& path, std::string_view bytes) {
    WholeFile file(path);
    file.write(bytes);
    stop_if_interrupted();
    file.commit();
}

}  // namespace render
