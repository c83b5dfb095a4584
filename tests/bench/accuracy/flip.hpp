// flip.hpp - how different two pictures look to somebody who flips between them: LDR-FLIP (Andersson,
// Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild, FLIP: A Difference Evaluator for
// Alternating Images, HPG 2020), written from the paper.
#pragma once

#include "accuracy/image.hpp"

namespace bench::accuracy {

// A screen of 0.7 m with 3840 pixels, 0.7 m away.
constexpr double kPixelsPerDegree = 67.0206;

// 0..1 per pixel, of two pictures of one size in sRGB, 0..1.
std::vector<double> flip(const Image& reference_srgb, const Image& test_srgb,
                         double pixels_per_degree = kPixelsPerDegree);

}  // namespace bench::accuracy
