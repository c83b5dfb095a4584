// describe.hpp - what describe_interface.cmake writes its tables with: sizes and kinds come from the
// compiler, and a type that was read wrongly from a header does not compile.
#pragma once

#include <rsh/rsh_interface.h>

#include <iterator>
#include <type_traits>

namespace rsh::describe {

template <class Type>
constexpr cl_uint kind_of() {
    if (std::is_void_v<Type>) return RSH_KIND_VOID;
    if (std::is_same_v<Type, char>) return RSH_KIND_TEXT;
    if (std::is_same_v<Type, rsh_float4> || std::is_floating_point_v<Type>)
        return RSH_KIND_FLOAT;
    if (std::is_pointer_v<Type>) return RSH_KIND_POINTER;
    if (std::is_class_v<Type>) return RSH_KIND_STRUCT;
    static_assert(std::is_void_v<Type> || std::is_same_v<Type, rsh_float4> ||
                      std::is_arithmetic_v<Type> || std::is_pointer_v<Type> ||
                      std::is_class_v<Type>,
                  "rsh_interface.h has no RSH_KIND_... for this type");
    return std::is_signed_v<Type> ? RSH_KIND_SIGNED : RSH_KIND_UNSIGNED;
}

// `Declared` as in the header, with the bounds of an array; `type` as a text without them.
template <class Declared>
constexpr rsh_field_info value(const char* name, const char* type) {
    using Element = std::remove_extent_t<Declared>;
    static_assert(std::rank_v<Declared> <= 1, "rsh_interface.h has no arrays of arrays");
    if constexpr (std::is_void_v<Declared>) {
        return {name, type, 0, 0, 0, RSH_KIND_VOID};
    } else {
        constexpr size_t kScalars = std::is_same_v<Element, rsh_float4> ? 4 : 1;
        constexpr size_t kCount = sizeof(Declared) / sizeof(Element) * kScalars;
        return {
            name, type, 0, sizeof(Declared), static_cast<cl_uint>(kCount), kind_of<Element>()};
    }
}

template <class Real, class Declared>
constexpr rsh_field_info field(const char* name, const char* type, size_t offset) {
    static_assert(std::is_same_v<Real, Declared>, "the header was read wrongly");
    rsh_field_info info = value<Declared>(name, type);
    info.offset = offset;
    return info;
}

template <class Value>
constexpr rsh_constant_info constant(const char* name, Value value) {
    static_assert(std::is_integral_v<Value> || std::is_enum_v<Value>,
                  "rsh_interface.h has constants only of integers");
    return {name, static_cast<cl_long>(value)};
}

}  // namespace rsh::describe
