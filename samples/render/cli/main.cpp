// main.cpp - rsh-render: scene files and meshes in, pictures and measurements out.
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

#include "cli/frame_loop.hpp"
#include "cli/inspection.hpp"
#include "cli/interrupt.hpp"
#include "cli/options.hpp"
#include "device/device.hpp"

namespace {

int perform(const render::Options& options) {
    if (options.lists_devices) {
        fmt::print("{}", render::list_devices());
        return 0;
    }
    if (!options.inspects) return render::run(options);
    render::print_inspections(options);
    return 0;
}

// What is printed may be what was asked for, and is only then written to the disk.
void flush_output() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout))
        throw std::runtime_error(
            fmt::format("standard output: cannot be written: {}", std::strerror(errno)));
}

}  // namespace

int main(int argc, char** argv) {
    render::handle_signals();
    try {
        const render::ParsedOptions parsed = render::parse_options(argc, argv);
        const int code = parsed.options ? perform(*parsed.options) : parsed.exit_code;
        flush_output();
        return code;
    } catch (const render::Interrupted& end) {
        fmt::print(stderr, "rsh-render: {}\n", end.what());
        return 128 + end.signal;
    } catch (const cl::Error& error) {
        fmt::print(stderr, "rsh-render: {}: OpenCL error {} ({})\n", error.what(), error.err(),
                   rsh_status_string(error.err()));
    } catch (const std::exception& error) {
        fmt::print(stderr, "rsh-render: {}\n", error.what());
    }
    return 1;
}
