#include "oracle/mirrors/path_errors.hpp"

#include <algorithm>
#include <limits>

#include "oracle/quantile.hpp"

namespace oracle {
namespace {

using test::Double3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance(const Quad3& a, const Quad3& b) {
    return length(Double3(a - b));
}

double angle(const Quad3& a, const Quad3& b) {
    return std::atan2(length(Double3(cross(a, b))), double(dot(a, b)));
}

}  // namespace

std::vector<Errors> errors_of(const Path& path, const Path& exact) {
    std::vector<Errors> errors;
    for (size_t k = 0; k < exact.size() && k < path.size(); ++k) {
        const Step &step = path[k], &right = exact[k];
        if (step.ray.skip != right.ray.skip) break;
        errors.push_back({distance(step.ray.origin, right.ray.origin),
                          angle(step.ray.direction, right.ray.direction),
                          step.next.triangle == right.next.triangle
                              ? distance(step.next.point, right.next.point)
                              : kInfinity});
    }
    errors.resize(exact.size(), {kInfinity, kInfinity, kInfinity});
    return errors;
}

void ErrorTable::append(const ErrorTable& more) {
    rows_.insert(rows_.end(), more.rows_.begin(), more.rows_.end());
}

double ErrorTable::quantile(size_t bounce, double Errors::*error, double share) const {
    std::vector<double> all;
    for (const std::vector<Errors>& row : rows_) all.push_back(row[bounce - 1].*error);
    return oracle::quantile(std::move(all), share);
}

double ErrorTable::median_of_ratios(const ErrorTable& to, size_t bounce,
                                    double Errors::*error) const {
    std::vector<double> ratios;
    for (size_t i = 0; i < rows_.size(); ++i) {
        const double ratio = rows_[i][bounce - 1].*error / (to.rows_[i][bounce - 1].*error);
        if (!std::isnan(ratio)) ratios.push_back(ratio);
    }
    return ratios.empty() ? 0 : oracle::quantile(std::move(ratios), 0.5);
}

size_t ErrorTable::lost_by(size_t bounce) const {
    return size_t(std::count_if(rows_.begin(), rows_.end(), [&](const auto& row) {
        return row[bounce - 1].position == kInfinity;
    }));
}

size_t ErrorTable::bounce_when_lost(double share) const {
    for (size_t bounce = 1; bounce <= bounces_; ++bounce)
        if (double(lost_by(bounce)) > share * double(path_count())) return bounce;
    return 0;
}

}  // namespace oracle
