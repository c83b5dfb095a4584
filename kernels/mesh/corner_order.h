/* corner_order.h - the order in which mesh/intersect.h takes the corners of a triangle: by x, then
 * y, then z. Coincident triangles are the same numbers to it, whichever corner comes first and
 * whichever way round they are, so that their t are the same bits.
 *
 * u and v are weights of the caller's corners 1 and 2. `places` says where these two went: 0 to 2,
 * in two bits each, that of corner 1 in the lower ones.
 */
#ifndef RSH_MESH_CORNER_ORDER_H
#define RSH_MESH_CORNER_ORDER_H

#include "mesh/triangles.h"

/* Three swaps of neighbours sort three corners, `swaps` has a bit for each that was made. The places
 * that come of them, four bits for each `swaps`; 4 and 5 never come up. */
#define RSH_PLACES 0x12004689u

#define RSH_COMES_BEFORE(ax, ay, az, bx, by, bz) \
    (((ax) < (bx)) | (((ax) == (bx)) & (((ay) < (by)) | (((ay) == (by)) & ((az) < (bz))))))

static void order_two(float3* a, float3* b, uint bit, uint* swaps)
{
    if (!RSH_COMES_BEFORE(b->x, b->y, b->z, a->x, a->y, a->z)) return;
    const float3 first = *b;
    *b = *a;
    *a = first;
    *swaps |= bit;
}

/* Returns the places. */
static uint put_in_order(triangle_points* p)
{
    uint swaps = 0;
    order_two(&p->v0, &p->v1, 1, &swaps);
    order_two(&p->v1, &p->v2, 2, &swaps);
    order_two(&p->v0, &p->v1, 4, &swaps);
    return RSH_PLACES >> 4 * swaps & 15;
}

static uintv order_two_lanes(floatv* a, floatv* b, uint bit)
{
    const intv is_swapped = RSH_COMES_BEFORE(b[0], b[1], b[2], a[0], a[1], a[2]);
    for (uint axis = 0; axis < 3; ++axis) {
        const floatv first = select(a[axis], b[axis], is_swapped);
        b[axis] = select(b[axis], a[axis], is_swapped);
        a[axis] = first;
    }
    return select((uintv)(0u), (uintv)(bit), as_uintv(is_swapped));
}

/* The same, a triangle per lane; corner[3 * i + axis]. */
static uintv put_lanes_in_order(floatv* corner)
{
    const uintv first = order_two_lanes(corner, corner + 3, 1);
    const uintv second = order_two_lanes(corner + 3, corner + 6, 2);
    const uintv swaps = first | second | order_two_lanes(corner, corner + 3, 4);
    return (uintv)(RSH_PLACES) >> (swaps << 2) & 15u;
}

/* weight: of the corners in order. corner: the caller's, 1 or 2. */
static floatv weight_of_corner(const floatv* weight, uint corner, uint places)
{
    const uint place = places >> 2 * (corner - 1) & 3;
    return place == 0 ? weight[0] : place == 1 ? weight[1] : weight[2];
}

#endif
