// motion_schema.cpp - transforms and key frames out of JSON.
#include "scene/motion_schema.hpp"

#include <cfloat>

#include <glm/gtc/matrix_transform.hpp>

namespace render {
namespace {

constexpr double kLargest = 1e30;

// {"axis": [x, y, z], "degrees": d} or a quaternion [w, x, y, z] of any length but zero.
Rotation rotation(const JsonValue& value) {
    if (!value.is_object()) {
        const auto n = value.numbers(4);
        const glm::dquat q(n[0], n[1], n[2], n[3]);
        if (!(glm::length(q) > 0.0)) value.fail("a quaternion [w, x, y, z] that is not 0");
        return rotation_of(q);
    }
    value.allow_keys({"axis", "degrees"});
    return {glm::normalize(glm::dvec3(value.member("axis").direction())),
            value.member("degrees").number()};
}

glm::dvec3 scaling(const JsonValue& value) {
    const glm::dvec3 scale =
        value.is_number() ? glm::dvec3(value.number_in(-FLT_MAX, FLT_MAX)) : value.dvec3();
    const glm::vec3 rounded = scale;
    if (rounded.x == 0.0f || rounded.y == 0.0f || rounded.z == 0.0f)
        value.fail("a number or an array of 3 numbers, none of them 0");
    return scale;
}

// Four rows of four numbers, as matrices are written; the last row is 0 0 0 1.
glm::dmat4 matrix(const JsonValue& value) {
    const auto rows = value.items();
    if (rows.size() != 4) value.fail("an array of 4 rows");
    glm::dmat4 result(1.0);
    for (int row = 0; row < 4; ++row) {
        const auto numbers = rows[row].numbers(4);
        for (int column = 0; column < 4; ++column) result[column][row] = numbers[column];
    }
    if (glm::dvec4(result[0][3], result[1][3], result[2][3], result[3][3]) !=
        glm::dvec4(0, 0, 0, 1))
        rows[3].fail("[0, 0, 0, 1]");
    if (!(glm::determinant(glm::dmat3(result)) != 0.0)) value.fail("a matrix with an inverse");
    return result;
}

glm::dmat4 step(const JsonValue& value) {
    value.allow_keys({"translate", "rotate", "scale", "matrix"});
    if (value.keys().size() != 1)
        value.fail("one of translate, rotate, scale, matrix per step");
    const glm::dmat4 identity(1.0);
    if (auto v = value.find("translate")) return glm::translate(identity, v->dvec3());
    if (auto v = value.find("rotate")) return glm::mat4_cast(quaternion(rotation(*v)));
    if (auto v = value.find("scale")) return glm::scale(identity, scaling(*v));
    return matrix(value.member("matrix"));
}

RigidKey rigid_key(const JsonValue& value) {
    value.allow_keys({"time", "translate", "rotate", "scale"});
    RigidKey key;
    key.time = key_time(value);
    if (auto v = value.find("translate")) key.translate = v->dvec3();
    if (auto v = value.find("rotate")) key.rotate = rotation(*v);
    if (auto v = value.find("scale"))
        key.scale = static_cast<float>(v->number_in(1e-30, kLargest));
    return key;
}

}  // namespace

glm::dmat4 transform(const JsonValue& value) {
    if (value.is_object()) return step(value);
    glm::dmat4 whole(1.0);
    for (const JsonValue& item : value.items()) whole = step(item) * whole;
    return whole;
}

double key_time(const JsonValue& key) {
    return key.member("time").number_in(-kLargest, kLargest);
}

std::vector<RigidKey> rigid_keys(const JsonValue& value) {
    return ascending_keys<RigidKey>(value, rigid_key);
}

}  // namespace render
