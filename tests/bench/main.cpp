// main.cpp - rsh-bench SUITE [--json FILE] [--quick] [--limit SECONDS] [--device NAME]: runs one
// suite and writes its cases; rsh-bench table FILE...: shows what was written. Ends with 1 when a
// case gave a wrong answer. Knows no suite but by the list.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "document.hpp"
#include "suite.hpp"
#include "table/report.hpp"

namespace {

struct Options {
    std::string json;
    std::string device;
    bool quick = false;
    double limit = 0;
    std::string command;  // as it was called
    std::vector<std::string> files;
};

void add_suites(CLI::App& app, Options& options) {
    for (bench::Suite* suite : bench::suites()) {
        CLI::App* command = app.add_subcommand(suite->name(), suite->description());
        command->add_option("--json", options.json, "Write the measured cases to this file");
        command->add_flag("--quick", options.quick, "A selection of the cases, in a minute");
        command
            ->add_option("--limit", options.limit,
                         "Seconds after which no case begins: the rest is left out, by name")
            ->check(CLI::PositiveNumber);
        command->add_option("--device", options.device,
                            "Part of a device's or platform's name");
        suite->add_options(*command);
    }
    app.require_subcommand(1);
}

void add_table(CLI::App& app, Options& options) {
    CLI::App* command = app.add_subcommand("table", "Shows files of results as one text");
    command->add_option("files", options.files, "JSON that --json or device.sh wrote")
        ->required();
}

int show_table(const Options& options) {
    const bench::Report report = bench::make_report(options.files);
    fmt::print("{}", report.text);
    return report.is_good ? 0 : 1;
}

// The number of cases that were wrong.
size_t run(bench::Suite& suite, const Options& options) {
    suite.prepare();
    const bench::Limit limit(options.limit);
    const bench::Device device(options.device);
    bench::Document document({{"suite", suite.name()},
                              {"rsh", bench::describe_library()},
                              {"command", options.command},
                              {"device", device.description()},
                              {"quick", options.quick}},
                             options.json);
    suite.run({device, options.quick, limit, document});
    document.finish();
    fmt::print("{} cases, {} wrong, {} left out\n", document.cases().size(),
               document.wrong_count(), document.left_out_count());
    return document.wrong_count();
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("rsh-bench: measures rsh; every answer is checked before it is timed",
                 "rsh-bench");
    Options options;
    options.command = fmt::format("{}", fmt::join(argv, argv + argc, " "));
    add_suites(app, options);
    add_table(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        if (app.got_subcommand("table")) return show_table(options);
        size_t wrong = 0;
        for (bench::Suite* suite : bench::suites())
            if (app.got_subcommand(suite->name())) wrong += run(*suite, options);
        return wrong > 0 ? 1 : 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "rsh-bench: {}\n", bench::describe_error(error));
    }
    return 1;
}
