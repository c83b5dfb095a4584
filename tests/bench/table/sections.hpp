// sections.hpp - the parts of the report: each takes the files it knows out of all, and is
// empty when there are none.
#pragma once

#include "table/result_file.hpp"

namespace bench {

// Device, driver and library: once, if all files tell the same.
std::string head_section(const std::vector<ResultFile>& files);
// Per program and options: seconds, and what the driver tells of each kernel.
std::string programs_section(const std::vector<ResultFile>& files);
// Per stream: each strategy's and each peer's ratio to a copy.
std::string reduce_section(const std::vector<ResultFile>& files);
// Per scene, size and kind of rays: the stages of each engine.
std::string frame_section(const std::vector<ResultFile>& files);
// Per family: the worst of its cases.
std::string stability_section(const std::vector<ResultFile>& files);
// Per scene: the time of each contender, and its wrong hits.
std::string hits_section(const std::vector<ResultFile>& files);
// Per batch of tests: how many passed, and which failed.
std::string tests_section(const std::vector<ResultFile>& files);

}  // namespace bench
