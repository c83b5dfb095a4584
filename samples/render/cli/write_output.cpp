// write_output.cpp - the moment at which a signal still counts.
#include "cli/write_output.hpp"

#include "cli/interrupt.hpp"
namespace render {

void write_output(const std::string& path, std::string_view bytes) {
    WholeFile file(path);
    file.write(bytes);
    commit_output(file);
}

void commit_output(WholeFile& file) {
    stop_if_interrupted();
    file.commit();
}

}  // namespace render
