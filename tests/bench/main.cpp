// main.cpp - rsh-bench SUITE [--json FILE] [--quick] [--device NAME]: runs one suite and writes
// its cases. Ends with 1 when a case gave a wrong answer. Knows no suite but by the list.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

#include "files/whole_file.hpp"
#include "suite.hpp"

namespace {

struct Options {
    std::string json;
    std::string device;
    bool quick = false;
};

void add_suites(CLI::App& app, Options& options) {
    for (bench::Suite* suite : bench::suites()) {
        CLI::App* command = app.add_subcommand(suite->name(), suite->description());
        command->add_option("--json", options.json, "Write the measured cases to this file");
        command->add_flag("--quick", options.quick, "A selection of the cases, in a minute");
        command->add_option("--device", options.device,
                            "Part of a device's or platform's name");
        suite->add_options(*command);
    }
    app.require_subcommand(1);
}

nlohmann::json as_json(const bench::Case& c) {
    return {{"name", c.name}, {"params", c.params}, {"metrics", c.metrics}, {"ok", c.ok}};
}

void write(const std::string& path, const nlohmann::json& document) {
    render::WholeFile file(path);
    file.write(document.dump(1) + '\n');
    file.commit();
}

// The number of cases that were wrong.
size_t run(bench::Suite& suite, const Options& options) {
    if (!options.json.empty()) render::require_place(options.json);
    const bench::Device device(options.device);
    nlohmann::json document = {{"suite", suite.name()},
                               {"rsh", bench::describe_library()},
                               {"device", device.description()},
                               {"quick", options.quick},
                               {"cases", nlohmann::json::array()}};
    size_t wrong = 0;
    for (const bench::Case& c : suite.run({device, options.quick})) {
        document["cases"].push_back(as_json(c));
        if (c.ok) continue;
        ++wrong;
        fmt::print(stderr, "wrong answer: {}\n", c.name);
    }
    if (!options.json.empty()) write(options.json, document);
    fmt::print("{} cases, {} wrong\n", document["cases"].size(), wrong);
    return wrong;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("rsh-bench: measures rsh; every answer is checked before it is timed",
                 "rsh-bench");
    Options options;
    add_suites(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        size_t wrong = 0;
        for (bench::Suite* suite : bench::suites())
            if (app.got_subcommand(suite->name())) wrong += run(*suite, options);
        return wrong > 0 ? 1 : 0;
    } catch (const cl::Error& error) {
        fmt::print(stderr, "rsh-bench: {}: OpenCL error {} ({})\n", error.what(), error.err(),
                   rsh_status_string(error.err()));
    } catch (const std::exception& error) {
        fmt::print(stderr, "rsh-bench: {}\n", error.what());
    }
    return 1;
}
