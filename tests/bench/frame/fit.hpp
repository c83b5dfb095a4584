// fit.hpp - lines through measured points. Knows nothing about what they measure.
#pragma once

#include <vector>

namespace bench {

struct Point {
    double x, y;
};

// Of the least-squares line; 0 when all x are equal or there are fewer than two points.
double slope(const std::vector<Point>& points);

// The p of y = c * x^p, fitted to the logarithms; all x and y must be positive.
double exponent(const std::vector<Point>& points);

// 0 of no value; all values must be positive.
double geometric_mean(const std::vector<double>& values);

}  // namespace bench
