#include "accuracy/picture_errors.hpp"

#include <algorithm>

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

PictureErrors compare(const Shown& reference, const Shown& shown,
                      const std::vector<bool>& is_edge) {
    const std::vector<Double3>&a = reference.srgb.pixels, &b = shown.srgb.pixels;
    Sum all, inside;
    for (size_t i = 0; i < a.size(); ++i) {
        all.add(a[i], b[i]);
        if (!is_edge[i]) inside.add(a[i], b[i]);
    }
    PictureErrors errors = {all.rmse(), inside.rmse(), all.wrong_share(), inside.wrong_share()};
    for (const double f : flip(reference.flip, shown.flip)) {
        errors.flip += f / double(a.size());
        errors.flip_above += (f > kMostFlip) / double(a.size());
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
