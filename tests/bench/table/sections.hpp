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
// Per file of GoogleTest: how many passed.
std::string tests_section(const std::vector<ResultFile>& files);
// Some ran, and none failed.
bool have_tests_passed(const ResultFile& file_of_tests);

}  // namespace bench
