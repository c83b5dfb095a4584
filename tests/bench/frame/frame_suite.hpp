// frame_suite.hpp - rsh-bench frame: bound + build + traverse of frames in which every triangle
// moves, against Embree rebuilt or refitted and traced in the same run on the same rays.
#pragma once

#include "suite.hpp"

namespace bench {

class FrameSuite final : public Suite {
public:
    const char* name() const noexcept override { return "frame"; }
    const char* description() const noexcept override {
        return "Frames of moving triangles: every engine against Embree's rebuild + trace";
    }
    void add_options(CLI::App& app) override;
    void run(const Run& run) override;

private:
    std::string filter_, rows_ = "standard";
    std::vector<cl_uint> widths_;
    bool lists_ = false;
};

}  // namespace bench
