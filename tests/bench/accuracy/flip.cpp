// flip.cpp - the paper's steps in their order. Names of its symbols in comments.
#include "accuracy/flip.hpp"

#include <algorithm>

#include "oracle/on_all_cores.hpp"

namespace bench::accuracy {
namespace {

using test::Double3;

constexpr double kPi = 3.14159265358979323846;
// Exponents of the colour difference and of the feature difference: q_c, q_f.
constexpr double kColourExponent = 0.7, kFeatureExponent = 0.5;
// What 0.4 of the largest difference becomes: p_c, p_t.
constexpr double kKneeAt = 0.4, kKneeTo = 0.95;
// Width of the detected features, in degrees.
constexpr double kFeatureDegrees = 0.082;

Double3 componentwise(const Double3& v, double (*f)(double)) {
    return {f(v.x), f(v.y), f(v.z)};
}

double decode_srgb(double s) {
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// Of linear sRGB, with the white (1, 1, 1) at (1, 1, 1).
constexpr double kXyz[3][3] = {
    {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

double row_sum(int i) {
    return kXyz[i][0] + kXyz[i][1] + kXyz[i][2];
}

Double3 relative_xyz(const Double3& linear) {
    const auto row = [&](int i) {
        return dot(Double3(kXyz[i][0], kXyz[i][1], kXyz[i][2]), linear) / row_sum(i);
    };
    return {row(0), row(1), row(2)};
}

// YCxCz: luminance, red against green, blue against yellow.
Double3 to_opponent(const Double3& linear) {
    const Double3 v = relative_xyz(linear);
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

// Cramer's rule on kXyz.
Double3 from_opponent(const Double3& o) {
    const double y = (o.x + 16) / 116;
    const Double3 v = {(y + o.y / 500) * row_sum(0), y * row_sum(1),
                       (y - o.z / 200) * row_sum(2)};
    const auto column = [](int k) { return Double3(kXyz[0][k], kXyz[1][k], kXyz[2][k]); };
    const Double3 r = column(0), g = column(1), b = column(2);
    const double volume = dot(r, cross(g, b));
    return {dot(v, cross(g, b)) / volume, dot(r, cross(v, b)) / volume,
            dot(r, cross(g, v)) / volume};
}

double lab_curve(double t) {
    constexpr double kDelta = 6.0 / 29;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}

// CIELAB with Hunt's effect: colours look weaker where it is dark.
Double3 to_hunt_lab(const Double3& linear) {
    const Double3 f = componentwise(relative_xyz(linear), lab_curve);
    const double lightness = 116 * f.y - 16, weaker = 0.01 * lightness;
    return {lightness, weaker * 500 * (f.x - f.y), weaker * 200 * (f.y - f.z)};
}

// Not std::hypot, whose symbol in Debian 12's C library older ones lack.
double length(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// The distance for large differences (Abasi, Tehran and Fairchild 2020).
double hyab(const Double3& a, const Double3& b) {
    return std::fabs(a.x - b.x) + length(a.y - b.y, a.z - b.z);
}

// A weight per component for each pixel of a square around the centre.
struct Kernel {
    int radius = 0;
    std::vector<Double3> weights;
};

template <class WeightOf>  // of a pixel, by its distance from the centre in pixels
Kernel make_kernel(int radius, const WeightOf& weight_of) {
    Kernel kernel = {radius, {}};
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) kernel.weights.push_back(weight_of(x, y));
    return kernel;
}

// With what lies beyond the border, as Image::at has it.
Image padded(const Image& image, int radius) {
    Image made = {image.width + 2 * uint32_t(radius), image.height + 2 * uint32_t(radius), {}};
    for (int64_t y = 0; y < made.height; ++y)
        for (int64_t x = 0; x < made.width; ++x)
            made.pixels.push_back(image.at(x - radius, y - radius));
    return made;
}

Image convolved(const Image& image, const Kernel& kernel) {
    const Image from = padded(image, kernel.radius);
    Image made = {image.width, image.height, std::vector<Double3>(image.pixels.size())};
    const size_t side = 2 * size_t(kernel.radius) + 1;
    oracle::on_all_cores(image.height, [&](size_t row) {
        for (size_t column = 0; column < image.width; ++column) {
            Double3 sum;
            for (size_t y = 0; y < side; ++y) {
                const Double3* pixel = &from.pixels[(row + y) * from.width + column];
                const Double3* weight = &kernel.weights[y * side];
                for (size_t x = 0; x < side; ++x) sum = sum + weight[x] * pixel[x];
            }
            made.pixels[row * image.width + column] = sum;
        }
    });
    return made;
}

// The eye's contrast sensitivity per component: sums of two Gaussians, a1, b1, a2, b2.
double sensitivity(const double (&k)[4], double square_degrees) {
    const auto gaussian = [&](double a, double b) {
        return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * square_degrees / b);
    };
    return gaussian(k[0], k[1]) + gaussian(k[2], k[3]);
}

Kernel sensitivity_kernel(double pixels_per_degree) {
    constexpr double kLight[4] = {1, 0.0047, 0, 1e-5}, kRed[4] = {1, 0.0053, 0, 1e-5},
                     kBlue[4] = {34.1, 0.04, 13.5, 0.025};
    const int radius =
        int(std::ceil(3 * std::sqrt(kBlue[1] / (2 * kPi * kPi)) * pixels_per_degree));
    Kernel kernel = make_kernel(radius, [&](int x, int y) {
        const double square = (x * x + y * y) / (pixels_per_degree * pixels_per_degree);
        return Double3(sensitivity(kLight, square), sensitivity(kRed, square),
                       sensitivity(kBlue, square));
    });
    Double3 sum;
    for (const Double3& weight : kernel.weights) sum = sum + weight;
    for (Double3& weight : kernel.weights)
        weight = {weight.x / sum.x, weight.y / sum.y, weight.z / sum.z};
    return kernel;
}

// x: an edge, first derivative of a Gaussian; y: a point, second derivative; both along one axis.
// Positive weights have the sum 1, negative ones -1.
Kernel feature_kernel(double pixels_per_degree, bool is_across) {
    const double deviation = 0.5 * kFeatureDegrees * pixels_per_degree;
    Kernel kernel = make_kernel(int(std::ceil(3 * deviation)), [&](int x, int y) {
        const double along = is_across ? y : x;
        const double g = std::exp(-(x * x + y * y) / (2 * deviation * deviation));
        return Double3(-along * g, (along * along / (deviation * deviation) - 1) * g, 0);
    });
    Double3 above, below;
    for (const Double3& w : kernel.weights) {
        above = above + Double3(std::max(w.x, 0.0), std::max(w.y, 0.0), 0);
        below = below + Double3(std::max(-w.x, 0.0), std::max(-w.y, 0.0), 0);
    }
    for (Double3& w : kernel.weights)
        w = {w.x / (w.x > 0 ? above.x : below.x), w.y / (w.y > 0 ? above.y : below.y), 0};
    return kernel;
}

// How the picture looks from afar: CIELAB of what the eye resolves.
std::vector<Double3> seen_colours(const Image& opponent, double pixels_per_degree) {
    Image seen = convolved(opponent, sensitivity_kernel(pixels_per_degree));
    for (Double3& p : seen.pixels)
        p = to_hunt_lab(
            componentwise(from_opponent(p), [](double x) { return std::clamp(x, 0.0, 1.0); }));
    return seen.pixels;
}

std::vector<Double3> features(const Image& opponent, double pixels_per_degree) {
    Image light = opponent;
    for (Double3& p : light.pixels) p = ((p.x + 16) / 116) * Double3(1, 1, 1);
    const Image along = convolved(light, feature_kernel(pixels_per_degree, false));
    const Image across = convolved(light, feature_kernel(pixels_per_degree, true));
    std::vector<Double3> made;
    for (size_t i = 0; i < light.pixels.size(); ++i) {
        const Double3 &a = along.pixels[i], &b = across.pixels[i];
        made.push_back({length(a.x, b.x), length(a.y, b.y), 0});
    }
    return made;
}

double colour_difference(const Double3& a, const Double3& b) {
    static const double largest =
        std::pow(hyab(to_hunt_lab({0, 1, 0}), to_hunt_lab({0, 0, 1})), kColourExponent);
    const double x = std::pow(hyab(a, b), kColourExponent), knee = kKneeAt * largest;
    if (x < knee) return kKneeTo / kKneeAt * x / largest;
    return kKneeTo + (x - knee) / (largest - knee) * (1 - kKneeTo);
}

double feature_difference(const Double3& a, const Double3& b) {
    const double larger = max_norm(a - b);
    return std::clamp(std::pow(larger / std::sqrt(2.0), kFeatureExponent), 0.0, 1.0);
}

Image opponent_of(const Image& srgb) {
    Image made = srgb;
    for (Double3& p : made.pixels) p = to_opponent(componentwise(p, decode_srgb));
    return made;
}

}  // namespace

FlipSide flip_side(const Image& srgb, double pixels_per_degree) {
    const Image opponent = opponent_of(srgb);
    return {seen_colours(opponent, pixels_per_degree), features(opponent, pixels_per_degree)};
}

std::vector<double> flip(const FlipSide& a, const FlipSide& b) {
    std::vector<double> made;
    for (size_t i = 0; i < a.colours.size(); ++i)
        made.push_back(std::pow(colour_difference(a.colours[i], b.colours[i]),
                                1 - feature_difference(a.features[i], b.features[i])));
    return made;
}

}  // namespace bench::accuracy
