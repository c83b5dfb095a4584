/* screen_order.h - in which order the rays of a screen go on into a packed wave: along Hilbert's
 * curve through each of its squares. Whichever rays are left out, those that follow each other are
 * close together on the screen. Rays in Morton's order, which jumps, meet 1.2 times as many nodes of
 * the engine paper_faithful (a room with two mirrors).
 */
#ifndef RSH_SHADE_SCREEN_ORDER_H
#define RSH_SHADE_SCREEN_ORDER_H

#include "rays/types.h"
#include "shade/types.h"
#include "surface/surface.h"

typedef struct cells {
    uintv x, y;
} cells;

/* The cells at places of the curve, in squares that grow from 2 x 2: each turns what is below it. */
static cells hilbert_cells(uintv place)
{
    cells at = {(uintv)(0u), (uintv)(0u)};
    for (uint side = 1; side < RSH_SCREEN_SQUARE; side *= 2, place = place >> 2) {
        const uintv right = place >> 1 & 1u, up = (place ^ right) & 1u;
        const intv is_back = right != (uintv)(0u), is_up = up != (uintv)(0u);
        const cells turned = {select(at.y, side - 1u - at.y, is_back),
                              select(at.x, side - 1u - at.x, is_back)};
        at.x = select(turned.x, at.x, is_up) + side * right;
        at.y = select(turned.y, at.y, is_up) + side * up;
    }
    return at;
}

/* The cells of a screen at RSH_WIDTH places. They lie in one square or two, and may be outside. */
static cells cells_at_places(wave_part screen, uintv place, uint first)
{
    const uint square = RSH_SCREEN_SQUARE * RSH_SCREEN_SQUARE;
    const uint columns = (screen.width + RSH_SCREEN_SQUARE - 1) / RSH_SCREEN_SQUARE;
    const uint one = first / square, two = one + 1;
    const intv in_two = place >= (uintv)(two * square);
    const uintv column = select((uintv)(one % columns), (uintv)(two % columns), in_two);
    const uintv row = select((uintv)(one / columns), (uintv)(two / columns), in_two);
    const cells at = hilbert_cells(place % square);
    return (cells){column * RSH_SCREEN_SQUARE + at.x, row * RSH_SCREEN_SQUARE + at.y};
}

/* The rays at RSH_WIDTH places of a wave; RSH_NO_RAY: from `end` on, or that part of a square lies
 * outside of the screen. */
RSH_CALLED static void rays_at_places(wave_part wave, uint first, uint end, uint* index)
{
    number_lanes(first, end, index);
    if (wave.height == 1) return;
    const uintv place = load_lanes(index);
    const cells at = cells_at_places(wave, place, first);
    const intv is_inside = (place != (uintv)(RSH_NO_RAY)) & (at.x < (uintv)(wave.width)) &
                           (at.y < (uintv)(wave.height));
    store_lanes(select((uintv)(RSH_NO_RAY), at.y * wave.width + at.x, is_inside), index);
}

#endif
