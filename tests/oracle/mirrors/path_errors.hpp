// path_errors.hpp - how far paths are from the exact ones after each bounce.
#pragma once

#include "oracle/mirrors/path.hpp"

namespace oracle {

// After a bounce; infinite from the first bounce on that is at another triangle than the exact
// path's. The next hit may be so already where the other two are not.
struct Errors {
    double position;   // of the ray's origin
    double direction;  // the angle
    double next_hit;   // of the point where the ray meets the next triangle
};

// One per bounce of the exact path.
std::vector<Errors> errors_of(const Path& path, const Path& exact);

// Of many paths, all of one number of bounces.
class ErrorTable {
public:
    ErrorTable(size_t paths, size_t bounces) : bounces_(bounces), rows_(paths) {}

    // Threads may set different paths at the same time.
    void set(size_t path, std::vector<Errors> errors) { rows_[path] = std::move(errors); }
    void append(const ErrorTable& more);

    size_t path_count() const { return rows_.size(); }
    size_t bounce_count() const { return bounces_; }
    // The smallest error that a share of the paths keeps to; bounces count from 1.
    double quantile(size_t bounce, double Errors::*error, double share) const;
    // Of the errors of each path to those of the same path in another table; without the paths of
    // which both are infinite, or 0. 0: there is no other.
    double median_of_ratios(const ErrorTable& to, size_t bounce, double Errors::*error) const;
    size_t lost_by(size_t bounce) const;
    // The first bounce by which more than this share of the paths are lost; 0: none.
    size_t bounce_when_lost(double share) const;

private:
    size_t bounces_;
    std::vector<std::vector<Errors>> rows_;
};

}  // namespace oracle
