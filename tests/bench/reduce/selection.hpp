// selection.hpp - which streams are reduced by whom.
#pragma once

#include "reduce/contender.hpp"

namespace bench {

// What the command line asks for; empty lists: the suite's own choice.
struct ReduceOptions {
    std::vector<cl_uint> counts;
    std::vector<cl_uint> bytes;
    std::vector<int> keeps;
    std::vector<std::string> patterns;
    std::vector<std::string> contenders;
    std::vector<std::string> keep_by;
    std::string streams;               // a folder: its files, see streams/stream_files.hpp
    std::vector<std::string> plugins;  // shared objects
    std::string dump;                  // a folder: nothing is reduced, streams are written
    std::vector<std::string> scenes;   // of which pairs are written
    cl_uint vector_width = 0;
    double budget_ms = 0;
};

// A stream and those who reduce it.
struct Heat {
    StreamSpec stream;
    Keep keep = Keep::kNotNull;
    std::vector<std::string> contenders;  // peer:pyopencl among them
};

// plugins: their names, beside whoever else takes part. Throws std::runtime_error for a file that is
// no stream.
std::vector<Heat> select_heats(const ReduceOptions& options,
                               const std::vector<std::string>& plugins, bool quick);

}  // namespace bench
