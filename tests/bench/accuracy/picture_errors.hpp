// picture_errors.hpp - how far a picture is from a reference, as numbers.
//
// All of them are of sRGB, as a screen shows the pictures: highlights that are clipped there count for
// nothing, and dark differences for what is seen of them. rmse is of values from 0 to 1 that are not
// rounded to 8 bits, so that it goes on telling good pictures apart; wrong_pixels is of 8 bits.
#pragma once

#include <nlohmann/json.hpp>

#include "accuracy/flip.hpp"

namespace bench::accuracy {

struct PictureErrors {
    double rmse = 0;          // over pixels and channels
    double rmse_inside = 0;   // over the pixels that are not at edges
    double wrong_pixels = 0;  // share that differs by more than 2 of 255 in a channel
    double wrong_inside = 0;  // likewise, of those that are not at edges
    double flip = 0;          // mean
    double flip_above = 0;    // share of the pixels above 0.1

    // "rmse" + suffix, and so on.
    void put(nlohmann::json& metrics, const char* suffix) const;
};

// A picture as it is compared.
struct Shown {
    explicit Shown(const Image& linear) : srgb(to_srgb(linear)), flip(flip_side(srgb)) {}

    Image srgb;
    FlipSide flip;
};

// is_edge: per pixel. Of one size.
PictureErrors compare(const Shown& reference, const Shown& shown,
                      const std::vector<bool>& is_edge);

}  // namespace bench::accuracy
