// departures.cpp - the judgement of departures.hpp.
//
// A ray that leaves a convex body hits none of it. Rounded corners may make the body slightly
// concave: then a hit is right if the triangle really rises above the plane of the one left, and
// the stored ray hits it but for the rounding of lateral coordinates (oracle/hit.hpp).
//
// A ray that goes on inside leaves the body at its exact first hit of the stored triangles, or at
// its origin if there is none. A hit by which it enters does not count: an origin at an edge may be
// an ulp outside of the neighbour, or on it (rsh.h). One that is reported must be true, but for the
// rounding of lateral coordinates: the origin does not lie inside of that plane, as far as two
// floats per number can tell (2^-42 of three terms, kernels/mesh/leaving.h), or the ray runs along it.
//
// A reported hit is an exact one of a triangle whose corners moved by 45u |.| at most (u = 2^-24,
// |.|: largest component of corner - origin, kernels/mesh/intersect.h). Let T be the triangle of
// the exact exit, R the one reported, both with outward normals. If R's point lies behind the exit
// by s, it is s cos(T) beyond T's plane, yet within 45u |.| of a triangle of the body, which has no
// point there. If it lies before the exit by s, the ray is inside R's plane up to the exit, so the
// point is s cos(R) inside it, yet within 45u |.| of it. So s <= 45u |.| (1 / cos(T) + 1 / cos(R)).
// Where only one of the two is there, the line has passed within that distance of the silhouette,
// and the chord between that triangle and the one by which the ray is in, the one left or an entry,
// is no longer than the same bound for these two.
// The same line may also run along a third triangle, closer to its plane than 45u |.| all the way.
#include "shade/departures.hpp"

#include <cmath>
#include <sstream>

#include "support/compare.hpp"

namespace test {
namespace {

Corners corners_of(const Mesh& mesh, uint32_t triangle) {
    Corners corners = {};
    mesh.corners(triangle, &corners);
    return corners;
}

Long3 outward_normal(const Corners& c, Double3 centre) {
    const Long3 a(c[0]);
    const Long3 normal = cross(Long3(c[1]) - a, Long3(c[2]) - a);
    return dot(normal, a - Long3(centre)) < 0 ? -1.0L * normal : normal;
}

// Whether a corner of `other` lies in front of the plane of `left`, for sure.
bool rises_above(const Corners& other, const Corners& left, Double3 centre) {
    const Long3 normal = outward_normal(left, centre);
    for (const Float3 corner : other) {
        const Long3 way = Long3(corner) - Long3(left[0]);
        if (dot(normal, way) > 0x1p-60L * length(normal) * length(way)) return true;
    }
    return false;
}

double reach_of(const Corners& c, Double3 origin) {
    double reach = 0;
    for (const Float3 corner : c) reach = std::fmax(reach, max_norm(Double3(corner) - origin));
    return reach;
}

double cosine_of(const Corners& c, Double3 direction) {
    const Double3 a(c[0]), normal = cross(Double3(c[1]) - a, Double3(c[2]) - a);
    return std::fabs(dot(normal, direction)) / (length(normal) * length(direction));
}

double exit_bound(const rsh_ray& ray, const Corners& one, const Corners& other) {
    const Double3 o(origin(ray)), d(direction(ray));
    return 45 * 0x1p-24 * std::fmax(reach_of(one, o), reach_of(other, o)) *
           (1 / cosine_of(one, d) + 1 / cosine_of(other, d));
}

// From its origin to t within rounding of the triangle's plane.
bool runs_along(const rsh_ray& ray, double t, const Corners& c) {
    const Double3 a(c[0]), o(origin(ray)), d(direction(ray));
    const Double3 normal = normalize(cross(Double3(c[1]) - a, Double3(c[2]) - a));
    const double bound = 45 * 0x1p-24 * reach_of(c, o);
    return std::fabs(dot(normal, o - a)) <= bound &&
           std::fabs(dot(normal, o - a) + t * dot(normal, d)) <= bound;
}

class Judge {
public:
    Judge(const Journey& journey, const Departures& departures)
        : journey_(journey), departures_(departures) {}

    Tally tally() {
        for (size_t i = 0; i < departures_.rays.size(); ++i)
            if (is_active(departures_.rays[i])) judge(i);
        return tally_;
    }

private:
    void judge(size_t i) {
        const Corners left = corners_of(journey_.mesh, departures_.skip[i]);
        const Long3 normal = outward_normal(left, journey_.centre);
        if (dot(normal, Long3(direction(departures_.rays[i]))) > 0) {
            ++tally_.outwards;
            if (!is_free(i, left)) complain(i, &tally_.stopped, "leaves and is stopped");
        } else {
            ++tally_.inwards;
            tally_.lost += departures_.hits[i].primitive == RSH_NO_HIT;
            if (!is_in_place(i, left)) complain(i, &tally_.misplaced, "gets out elsewhere");
        }
    }

    bool is_free(size_t i, const Corners& left) const {
        const uint32_t hit = departures_.hits[i].primitive;
        if (hit == RSH_NO_HIT) return true;
        const Corners corners = corners_of(journey_.mesh, hit);
        return rises_above(corners, left, journey_.centre) &&
               oracle::intersect(departures_.rays[i], corners).possible;
    }

    bool is_in_place(size_t i, const Corners& left) {
        const rsh_ray& ray = departures_.rays[i];
        const uint32_t hit = departures_.hits[i].primitive;
        const oracle::Answer exit = exact_exit(i);
        if (enters(ray, hit)) {
            ++tally_.again;
            const Corners corners = corners_of(journey_.mesh, hit);
            return oracle::intersect(ray, corners).possible &&
                   (height_above(corners, ray) >=
                        -0x1p-40 * reach_of(corners, Double3(origin(ray))) ||
                    is_grazed(ray, exit.t, corners));
        }
        if (is_near(i, exit, left)) return true;
        const double t = hit == RSH_NO_HIT ? exit.t : double(departures_.hits[i].t);
        return (hit == RSH_NO_HIT || exit.primitive == RSH_NO_HIT) && runs_along_any(ray, t);
    }

    // Of a ray's origin, outwards.
    double height_above(const Corners& c, const rsh_ray& ray) const {
        const Long3 normal = outward_normal(c, journey_.centre);
        return double(dot(normal, Long3(origin(ray)) - Long3(c[0])) / length(normal));
    }

    // Runs along that triangle all the way out, or more nearly so than side_ahead of
    // kernels/mesh/leaving.h can tell.
    static bool is_grazed(const rsh_ray& ray, double exit, const Corners& entered) {
        const bool is_parallel = cosine_of(entered, Double3(direction(ray))) < 0x1p-20;
        return runs_along(ray, is_parallel ? 0 : exit, entered);
    }

    // Within what the rounding of both triangles may move the point.
    bool is_near(size_t i, const oracle::Answer& exit, const Corners& left) const {
        const rsh_ray& ray = departures_.rays[i];
        const rsh_hit& hit = departures_.hits[i];
        const oracle::Answer& first = departures_.exact[i];
        const double t = hit.primitive == RSH_NO_HIT ? 0 : double(hit.t);
        const double apart = std::fabs(t - exit.t) * length(Double3(direction(ray)));
        const Corners entry =
            enters(ray, first.primitive) ? corners_of(journey_.mesh, first.primitive) : left;
        const auto or_entry = [&](uint32_t triangle) {
            return triangle == RSH_NO_HIT ? entry : corners_of(journey_.mesh, triangle);
        };
        return apart == 0 ||
               apart <= exit_bound(ray, or_entry(hit.primitive), or_entry(exit.primitive));
    }

    bool enters(const rsh_ray& ray, uint32_t triangle) const {
        if (triangle == RSH_NO_HIT) return false;
        const Long3 normal =
            outward_normal(corners_of(journey_.mesh, triangle), journey_.centre);
        return dot(normal, Long3(direction(ray))) < 0;
    }

    bool runs_along_any(const rsh_ray& ray, double t) const {
        for (uint32_t k = 0; k < journey_.mesh.triangle_count(); ++k)
            if (runs_along(ray, t, corners_of(journey_.mesh, k))) return true;
        return false;
    }

    // The first hit of a triangle that the ray does not enter by.
    oracle::Answer exact_exit(size_t i) const {
        oracle::Answer first = departures_.exact[i];
        if (!enters(departures_.rays[i], first.primitive)) return first;
        first = {};
        for (uint32_t k = 0; k < journey_.mesh.triangle_count(); ++k) {
            if (k == departures_.skip[i] || enters(departures_.rays[i], k)) continue;
            const auto hit =
                oracle::intersect(departures_.rays[i], corners_of(journey_.mesh, k));
            if (!hit.exact || (first.primitive != RSH_NO_HIT && hit.t >= first.t)) continue;
            first.primitive = k, first.t = hit.t;
        }
        return first;
    }

    void complain(size_t i, Fault* fault, const char* what) const {
        if (fault->count++ > 0) return;
        std::ostringstream text;
        text.precision(9);
        text << departures_.rays[i] << " " << what << ": hit " << departures_.hits[i]
             << "; exactly primitive " << departures_.exact[i].primitive << ", t "
             << departures_.exact[i].t;
        const std::pair<const char*, uint32_t> triangles[] = {
            {"left", departures_.skip[i]},
            {"hit", departures_.hits[i].primitive},
            {"exactly hit", departures_.exact[i].primitive}};
        for (const auto& [name, triangle] : triangles) {
            if (triangle == RSH_NO_HIT) continue;
            text << "\n  " << name << " " << triangle << ":";
            for (const Float3 c : corners_of(journey_.mesh, triangle))
                text << " (" << c.x << " " << c.y << " " << c.z << ")";
        }
        fault->first = text.str();
    }

    const Journey& journey_;
    const Departures& departures_;
    Tally tally_;
};

Fault sum(const Fault& a, const Fault& b) {
    return {a.count + b.count, a.count > 0 ? a.first : b.first};
}

}  // namespace

void Tally::add(const Tally& other) {
    outwards += other.outwards;
    inwards += other.inwards;
    stopped = sum(stopped, other.stopped);
    misplaced = sum(misplaced, other.misplaced);
    lost += other.lost;
    again += other.again;
}

Tally judge(const Journey& journey, const Departures& departures) {
    return Judge(journey, departures).tally();
}

}  // namespace test
