// references.hpp - what a scene looks like, without any rounding: the pictures that others are compared
// with.
#pragma once

#include "accuracy/edges.hpp"
#include "accuracy/image.hpp"
#include "accuracy/scenes.hpp"

namespace bench::accuracy {

struct References {
    Image truth;                // 8 x 8 samples per pixel
    Image centres;              // one sample, which is what rsh is exact about
    std::vector<bool> is_edge;  // of the pixels
    // Share of the pixels of `truth` in which rays that were not followed have a weight above 1/1024
    // together.
    double cut_pixels = 0;
};

References make_references(const Staged& staged, uint32_t width, uint32_t height);

}  // namespace bench::accuracy
