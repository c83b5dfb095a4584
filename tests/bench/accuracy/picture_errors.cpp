#include "accuracy/picture_errors.hpp"

#include <algorithm>

#include "accuracy/flip.hpp"

namespace bench::accuracy {
namespace {

using test::Double3;

constexpr int kMostSteps = 2;      // of 255: nobody sees that
constexpr double kMostFlip = 0.1;  // a difference that is seen at once

bool is_wrong(const Double3& a, const Double3& b) {
    const auto differs = [](double x, double y) {
        return std::abs(in_255(x) - in_255(y)) > kMostSteps;
    };
    return differs(a.x, b.x) || differs(a.y, b.y) || differs(a.z, b.z);
}

struct Sum {
    double squares = 0;
    size_t wrong = 0, count = 0;

    void add(const Double3& a, const Double3& b) {
        squares += dot(a - b, a - b) / 3;
        wrong += is_wrong(a, b);
        ++count;
    }
    double rmse() const { return count ? std::sqrt(squares / double(count)) : 0; }
    double wrong_share() const { return count ? double(wrong) / double(count) : 0; }
};

}  // namespace

PictureErrors compare(const Image& reference, const Image& shown,
                      const std::vector<bool>& is_edge) {
    const Image a = to_srgb(reference), b = to_srgb(shown);
    Sum all, inside;
    for (size_t i = 0; i < a.pixels.size(); ++i) {
        all.add(a.pixels[i], b.pixels[i]);
        if (!is_edge[i]) inside.add(a.pixels[i], b.pixels[i]);
    }
    PictureErrors errors = {all.rmse(), inside.rmse(), all.wrong_share(), inside.wrong_share()};
    for (const double f : flip(a, b)) {
        errors.flip += f / double(a.pixels.size());
        errors.flip_above += (f > kMostFlip) / double(a.pixels.size());
    }
    return errors;
}

void PictureErrors::put(nlohmann::json& metrics, const char* suffix) const {
    const auto set = [&](const char* name, double value) {
        metrics[std::string(name) + suffix] = value;
    };
    set("rmse", rmse);
    set("rmse_inside", rmse_inside);
    set("wrong_pixels", wrong_pixels);
    set("wrong_pixels_inside", wrong_inside);
    set("flip", flip);
    set("flip_above", flip_above);
}

}  // namespace bench::accuracy
