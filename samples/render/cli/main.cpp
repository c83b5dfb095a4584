// main.cpp - rsh-render: scene files and meshes in, pictures and measurements out.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "cli/frame_loop.hpp"
#include "cli/inspection.hpp"
#include "cli/options.hpp"
#include "device/device.hpp"

int main(int argc, char** argv) {
    try {
        const render::ParsedOptions parsed = render::parse_options(argc, argv);
        if (!parsed.options) return parsed.exit_code;
        const render::Options& options = *parsed.options;
        if (options.lists_devices)
            fmt::print("{}", render::list_devices());
        else if (options.inspects)
            render::print_inspections(options);
        else
            return render::run(options);
        return 0;
    } catch (const cl::Error& error) {
        fmt::print(stderr, "rsh-render: {}: OpenCL error {} ({})\n", error.what(), error.err(),
                   rsh_status_string(error.err()));
    } catch (const std::exception& error) {
        fmt::print(stderr, "rsh-render: {}\n", error.what());
    }
    return 1;
}
