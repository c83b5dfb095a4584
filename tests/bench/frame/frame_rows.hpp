// frame_rows.hpp - the table of cases: scene x size x rays; each is run with every column
// (engine x bound) of the library, all against the same runs of Embree.
#pragma once

#include <string>
#include <vector>

#include "frame/rsh_tracer.hpp"

namespace bench {

struct FrameRow {
    SceneSpec scene;
    Size size;
    RayKind rays;
    bool is_quick;  // part of --quick

    std::string name() const;  // "frame/scene:room-sphere-80k/size:512x512/rays:shadow"
};

// Rows of one scene stand together. Scene files whose meshes are absent are found out when they
// are read.
std::vector<FrameRow> frame_rows();

// Rooms of 20 K, 700 K and 2.3 M triangles with a mirror floor at 512x512 to 4096x4096, the small
// pictures first: what a device that nobody knows is asked within a minute.
std::vector<FrameRow> device_rows();

// By name from the library: engines but brute force, with each bound that they take.
std::vector<Column> frame_columns(const Device& device);

// Each column with each width of vectors in turn; without widths, as they are.
std::vector<Column> with_widths(const std::vector<Column>& columns,
                                const std::vector<cl_uint>& widths);

// Whether a run of this column ends within seconds.
bool is_measured(const FrameRow& row, const Column& column);

std::string case_name(const FrameRow& row, const Column& column);

}  // namespace bench
