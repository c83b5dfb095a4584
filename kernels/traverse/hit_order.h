/* hit_order.h - the order of the hits of a ray in its list. */
#ifndef RSH_TRAVERSE_HIT_ORDER_H
#define RSH_TRAVERSE_HIT_ORDER_H

#include "rsh/rsh_types.h"

static bool comes_before(rsh_hit a, rsh_hit b)
{
    return a.t < b.t || (a.t == b.t && a.primitive < b.primitive);
}

#endif
