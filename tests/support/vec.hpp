// vec.hpp - the three numbers that tests and oracles calculate with, in any precision.
// Element-wise operators, dot, cross; has no other geometry.
#pragma once

#include <cmath>

namespace test {

template <class T>
struct Vec3 {
    T x{}, y{}, z{};

    Vec3() = default;
    Vec3(T a, T b, T c) : x(a), y(b), z(c) {}
    template <class U>
    explicit Vec3(const Vec3<U>& v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}
};

using Float3 = Vec3<float>;
using Double3 = Vec3<double>;
using Long3 = Vec3<long double>;
static_assert(sizeof(Float3) == 12, "a packed vertex");

template <class T>
Vec3<T> operator+(Vec3<T> a, Vec3<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Vec3<T> operator-(Vec3<T> a, Vec3<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Vec3<T> operator*(Vec3<T> a, Vec3<T> b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T>
Vec3<T> operator*(T s, Vec3<T> a) {
    return {s * a.x, s * a.y, s * a.z};
}
template <class T>
T dot(Vec3<T> a, Vec3<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(Vec3<T> a) {
    return std::sqrt(dot(a, a));
}
template <class T>
Vec3<T> normalize(Vec3<T> a) {
    return (T(1) / length(a)) * a;
}
template <class T>
T max_norm(Vec3<T> a) {
    return std::fmax(std::fabs(a.x), std::fmax(std::fabs(a.y), std::fabs(a.z)));
}
template <class T>
bool finite(Vec3<T> a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace test
