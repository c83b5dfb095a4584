#include "oracle/leaving/snell.hpp"

#include <algorithm>
#include <limits>

namespace oracle {
namespace {

using test::Long3;

constexpr long double kU = kFloatUnit;

long double size_of_terms(Long3 a, Long3 b) {
    return std::fabs(a.x * b.x) + std::fabs(a.y * b.y) + std::fabs(a.z * b.z);
}

// Mean of both polarizations.
long double reflectance(long double eta, long double cosine, long double f) {
    const long double across = (cosine - f) / (cosine + f);
    const long double along = (eta * eta * cosine - f) / (eta * eta * cosine + f);
    return (across * across + along * along) / 2;
}

}  // namespace

PlaneHit plane_hit(const rsh_ray& ray, const test::Corners& corners) {
    const Long3 origin(test::origin(ray)), a(corners[0]);
    const Long3 edge1 = Long3(corners[1]) - a, edge2 = Long3(corners[2]) - a;
    PlaneHit at;
    at.incident = normalize(Long3(test::direction(ray)));
    const Long3 area = cross(edge1, edge2);
    at.normal = normalize(area);
    const long double along = dot(at.incident, at.normal);
    at.is_outside = along <= 0;
    if (!at.is_outside) at.normal = -1.0L * at.normal;
    at.cosine = std::fabs(along);
    at.error = 33 * kU * size_of_terms(at.incident, at.normal);
    at.is_sided = at.cosine > at.error;
    at.extent = std::max(max_norm(edge1), max_norm(edge2));
    at.reach = 0;
    for (const test::Float3 corner : corners)
        at.reach = std::max(at.reach, max_norm(Long3(corner) - origin));
    at.is_well_shaped = at.cosine > 0x1p-6L && length(area) > 0x1p-6L * at.extent * at.extent;
    return at;
}

Snell snell_at(const PlaneHit& at, float index) {
    const long double inside = index > 0 && std::isfinite(index) ? index : 1;
    const long double c = at.cosine;
    Snell snell;
    snell.eta = at.is_outside ? inside : 1 / inside;
    const long double eta = snell.eta, square = (eta - 1) * (eta + 1);
    snell.discriminant = square + c * c;
    snell.error = 10 * kU * eta * std::max(eta, 1.0L) + 3 * kU * std::fabs(square) +
                  2 * c * at.error + at.error * at.error +
                  2 * kU * (c * c + std::fabs(snell.discriminant));
    snell.is_total = snell.discriminant < -snell.error;
    snell.is_refracted = snell.discriminant > snell.error;
    snell.reflectance =
        snell.is_refracted ? reflectance(eta, c, std::sqrt(snell.discriminant)) : 1;
    return snell;
}

Long3 mirrored(const PlaneHit& at) {
    return at.incident + (2 * at.cosine) * at.normal;
}

Long3 refracted(const PlaneHit& at, const Snell& snell) {
    const long double f = std::sqrt(std::max(snell.discriminant, 0.0L));
    return normalize(at.incident + (at.cosine - f) * at.normal);
}

// A vector of length l that errs by e is turned by 2 e / l at most; then it is made a unit.
long double refracted_error(const PlaneHit& at, const Snell& snell) {
    if (!snell.is_refracted) return std::numeric_limits<long double>::infinity();
    const long double f = std::sqrt(snell.discriminant);
    const long double off = 13 * kU + at.error + snell.error / f + 7 * kU * f +
                            20 * kU * std::fabs(at.cosine - f) + 2 * kU;
    return 2 * std::sqrt(3.0L) * off / snell.eta + 13 * kU;
}

}  // namespace oracle
