// cub_peer.cu - CUB's DeviceSelect::If, called as its users call it, on the streams of the pattern
// "random" of rsh-bench reduce, in turn with cudaMemcpyAsync of the same bytes. A program of its
// own, which needs CUDA's compiler and nothing else:
//   nvcc -O3 -std=c++17 -arch=native -o cub_peer cub_peer.cu
//   cub_peer [--n 1048576,16777216] [--bytes 4,8] [--keep 10,50,90] [--budget MS] [--limit S]
//            [--json FILE]
// Each answer is checked before it is timed; ends with 1 when one was wrong. Writes what the suite
// writes, with the strategy peer:cub, so that rsh-bench table puts both into one row. Times are the
// host's, from the call to the end of the work, as the suite's are; device_ms and device_copy_ms
// are between events.
#include <cuda_runtime.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "cub_json.cuh"
#include "cub_race.cuh"

namespace {

struct Options {
    std::map<std::string, std::string> values = {{"--n", "1048576,16777216,268435456"},
                                                 {"--bytes", "4,8"},
                                                 {"--keep", "10,50,90"},
                                                 {"--budget", "150"},
                                                 {"--limit", "0"},
                                                 {"--json", ""}};

    Options(int argc, char** argv) {
        for (int i = 1; i < argc; i += 2) {
            const auto found = values.find(argv[i]);
            if (found == values.end() || i + 1 == argc)
                throw std::runtime_error(std::string(argv[i]) + ": is no option with a value");
            found->second = argv[i + 1];
        }
    }
    std::vector<uint32_t> numbers(const std::string& name) const {
        std::vector<uint32_t> numbers;
        std::istringstream list(values.at(name));
        for (std::string one; std::getline(list, one, ',');)
            numbers.push_back(uint32_t(std::stoul(one)));
        return numbers;
    }
    double number(const std::string& name) const { return std::stod(values.at(name)); }
};

// Why a job must not begin; empty: it may.
std::string refusal(const Job& job, double passed, double limit) {
    if (limit > 0 && passed > limit)
        return "the limit of " + std::to_string(int(limit)) + " s has passed";
    size_t free = 0, all = 0;
    require(cudaMemGetInfo(&free, &all), "cudaMemGetInfo");
    const size_t needed = size_t{3} * job.count * job.bytes;  // and a little scratch memory
    if (needed <= free) return "";
    return "needs " + std::to_string(needed) + " bytes of memory, " + std::to_string(free) +
           " are free";
}

Result run_job(const Job& job, double budget_ms) {
    if (job.bytes == 4) return Race<uint32_t>(job.count, job.keep).run(budget_ms);
    if (job.bytes == 8) return Race<uint2>(job.count, job.keep).run(budget_ms);
    throw std::runtime_error("--bytes: is " + std::to_string(job.bytes) + ", must be 4 or 8");
}

size_t run(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::string> cases, left_out;
    size_t wrong = 0;
    for (const uint32_t count : options.numbers("--n"))
        for (const uint32_t bytes : options.numbers("--bytes"))
            for (const uint32_t keep : options.numbers("--keep")) {
                const Job job = {count, bytes, keep};
                const std::chrono::duration<double> passed =
                    std::chrono::steady_clock::now() - start;
                const std::string why = refusal(job, passed.count(), options.number("--limit"));
                if (!why.empty()) {
                    std::printf("left out: %s: %s\n", job.name().c_str(), why.c_str());
                    left_out.push_back("{\"name\": \"" + job.name() + "\", \"why\": \"" + why +
                                       "\"}");
                } else {
                    const Result result = run_job(job, options.number("--budget"));
                    wrong += !result.is_right;
                    cases.push_back(case_json(job, result));
                    std::printf("%s: %s\n", job.name().c_str(),
                                result.is_right ? "right" : "WRONG");
                }
                std::fflush(stdout);
                write(options.values.at("--json"), cases, left_out);
            }
    std::printf("%zu cases, %zu wrong, %zu left out\n", cases.size(), wrong, left_out.size());
    return wrong;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(Options(argc, argv)) > 0 ? 1 : 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "cub_peer: %s\n", error.what());
        return 1;
    }
}
