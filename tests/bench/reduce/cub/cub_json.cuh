// cub_json.cuh - results as rsh-bench reduce writes them (document.hpp has the format's version), so that
// rsh-bench table puts both into one row.
#pragma once

#include <cstdio>
#include <sstream>

#include "cub_race.cuh"

struct Job {
    uint32_t count, bytes, keep;

    std::string name() const {
        return "reduce/strategy:peer:cub/n:" + std::to_string(count) +
               "/bytes:" + std::to_string(bytes) + "/keep:" + std::to_string(keep) +
               "/pattern:random/by:not_null";
    }
};

inline double quantile(std::vector<double> values, double q) {
    std::sort(values.begin(), values.end());
    return values[size_t(q * double(values.size() - 1) + 0.5)];
}

inline std::string case_json(const Job& job, const Result& result) {
    std::ostringstream out;
    out << "{\"name\": \"" << job.name()
        << "\", \"ok\": " << (result.is_right ? "true" : "false")
        << ",\n  \"params\": {\"strategy\": \"peer:cub\", \"n\": " << job.count
        << ", \"bytes\": " << job.bytes << ", \"keep\": " << job.keep
        << ", \"pattern\": \"random\", \"keep_by\": \"not_null\"},\n  \"metrics\": {\"kept\": "
        << result.kept;
    if (result.is_right) {
        std::vector<double> ratios;
        for (size_t i = 0; i < result.copy.host.size(); ++i)
            ratios.push_back(result.copy.host[i] / result.select.host[i]);
        const double ms = quantile(result.select.host, 0.5);
        out << ", \"ms\": " << ms << ", \"ms_low\": " << quantile(result.select.host, 0.25)
            << ", \"ms_high\": " << quantile(result.select.host, 0.75)
            << ", \"elements_per_s\": " << job.count / ms * 1e3
            << ", \"copy_ms\": " << quantile(result.copy.host, 0.5)
            << ", \"ratio_to_copy\": " << quantile(ratios, 0.5)
            << ", \"ratio_low\": " << quantile(ratios, 0.25)
            << ", \"ratio_high\": " << quantile(ratios, 0.75)
            << ", \"device_ms\": " << quantile(result.select.device, 0.5)
            << ", \"device_copy_ms\": " << quantile(result.copy.device, 0.5)
            << ", \"pairs\": " << ratios.size();
    }
    out << "}}";
    return out.str();
}

inline std::string device_json() {
    cudaDeviceProp device;
    int driver = 0, runtime = 0;
    require(cudaGetDeviceProperties(&device, 0), "cudaGetDeviceProperties");
    require(cudaDriverGetVersion(&driver), "cudaDriverGetVersion");
    require(cudaRuntimeGetVersion(&runtime), "cudaRuntimeGetVersion");
    std::ostringstream out;
    out << "{\"name\": \"" << device.name << "\", \"platform\": \"CUDA\", \"driver\": \"CUDA "
        << driver << "\", \"platform_version\": \"runtime " << runtime << ", CUB "
        << CUB_VERSION << "\", \"compute_units\": " << device.multiProcessorCount
        << ", \"memory_bytes\": " << device.totalGlobalMem << "}";
    return out.str();
}

inline std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : ",\n ") + text;
    return "[" + all + "]";
}

// Written beside it first, so that a run that is killed leaves a whole file.
inline void write(const std::string& path, const std::vector<std::string>& cases,
                  const std::vector<std::string>& left_out) {
    if (path.empty()) return;
    const std::string beside = path + ".part";
    std::FILE* file = std::fopen(beside.c_str(), "w");
    const std::string text =
        "{\"suite\": \"reduce\",\n\"format_version\": 1,\n\"device\": " + device_json() +
        ",\n\"left_out\": " + joined(left_out) + ",\n\"cases\": " + joined(cases) + "}\n";
    const bool is_written =
        file && std::fwrite(text.data(), 1, text.size(), file) == text.size();
    if (!file || std::fclose(file) != 0 || !is_written ||
        std::rename(beside.c_str(), path.c_str()) != 0)
        throw std::runtime_error("cannot write " + path);
}
