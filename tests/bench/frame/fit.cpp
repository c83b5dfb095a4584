#include "frame/fit.hpp"

#include <cmath>

namespace bench {

double slope(const std::vector<Point>& points) {
    double x = 0, y = 0;
    for (const Point& p : points) {
        x += p.x / double(points.size());
        y += p.y / double(points.size());
    }
    double xx = 0, xy = 0;
    for (const Point& p : points) {
        xx += (p.x - x) * (p.x - x);
        xy += (p.x - x) * (p.y - y);
    }
    return xx > 0 ? xy / xx : 0;
}

double exponent(const std::vector<Point>& points) {
    std::vector<Point> logarithms;
    for (const Point& p : points) logarithms.push_back({std::log(p.x), std::log(p.y)});
    return slope(logarithms);
}

double geometric_mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return values.empty() ? 0 : std::exp(sum / double(values.size()));
}

}  // namespace bench
