/* edge_values.h - differences and sums that mesh/intersect.h makes of a triangle's corners: exact
 * in sign, or the same bits for any order of the corners. What underflows is its affair. */
#ifndef RSH_MESH_EDGE_VALUES_H
#define RSH_MESH_EDGE_VALUES_H

#include "lanes/sixteen.h"

/* a*b - c*d within 1.5 ulp (Kahan): `error` is the rounding of c*d, exactly. */
static floatv difference_of_products(floatv a, floatv b, floatv c, floatv d)
{
    const floatv cd = c * d;
    const floatv error = fma(-c, d, cd);
    return fma(a, b, -cd) + error;
}

/* |a*b - c*d|, the same bits as |c*d - a*b|: swapped products change the sign of both differences,
 * exactly. Within 3u of itself (u = 2^-24), no more than difference_of_products. With the exact
 * products ab + e and cd + f: where ab and cd differ by more than a factor of 2, the three
 * roundings of (ab - cd) + (e - f) err by 2u, as e and f are u of the products. Otherwise ab - cd is
 * exact, and if g is an ulp of the smaller product, it is a multiple of g, e - f at most 1.5 g
 * and rounded by u g at most, and not rounded at all up to g, as products have 48 bits: the sum
 * is at least g / 2 where it is. */
static floatv size_of_difference(floatv a, floatv b, floatv c, floatv d)
{
    const floatv ab = a * b;
    const floatv cd = c * d;
    return fabs((ab - cd) + (fma(a, b, -ab) + fma(-c, d, cd)));
}

/* The same bits in whatever order the terms come: the largest is added last. */
static floatv sum_in_any_order(floatv x, floatv y, floatv z)
{
    const floatv larger = greater(x, y);
    return (lesser(x, y) + lesser(larger, z)) + greater(larger, z);
}

#endif
