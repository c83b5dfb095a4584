// flip.hpp - how different two pictures look to somebody who flips between them: LDR-FLIP (Andersson,
// Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild, FLIP: A Difference Evaluator for
// Alternating Images, HPG 2020), written from the paper.
#pragma once

#include "accuracy/image.hpp"

namespace bench::accuracy {

// A screen of 0.7 m with 3840 pixels, 0.7 m away.
constexpr double kPixelsPerDegree = 67.0206;

// What FLIP needs of one picture, which is compared with others.
struct FlipSide {
    std::vector<test::Double3> colours;   // as they are seen from there
    std::vector<test::Double3> features;  // x: how much of an edge, y: of a point
};

// Of a picture in sRGB, 0..1.
FlipSide flip_side(const Image& srgb, double pixels_per_degree = kPixelsPerDegree);

// 0..1 per pixel, of two pictures of one size.
std::vector<double> flip(const FlipSide& a, const FlipSide& b);

}  // namespace bench::accuracy
