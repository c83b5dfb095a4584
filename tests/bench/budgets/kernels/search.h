/* search.h - looks for the input of the largest error: a work-item goes on from the worst input that
 * it has, changed at random, and now and then from another one. Behind the library's kernels, whose
 * functions the errors are of. */
#ifndef BUDGETS_SEARCH_H
#define BUDGETS_SEARCH_H

#define UNIT 0x1p-24

static uint next_random(uint* random) {
    *random = *random * 747796405u + 2891336453u; /* PCG (O'Neill 2014) */
    const uint word = ((*random >> ((*random >> 28) + 4)) ^ *random) * 277803737u;
    return (word >> 22) ^ word;
}

static uint below(uint* random, uint limit) {
    return next_random(random) % limit;
}
static bool chance(uint* random, uint one_in) {
    return below(random, one_in) == 0;
}
static float unit_random(uint* random) {
    return (float)(next_random(random) >> 8) * 0x1p-24f;
}
static float signed_random(uint* random) {
    return 2.0f * unit_random(random) - 1.0f;
}
static float power_random(uint* random, int least, int most) {
    return ldexp(1.0f, least + (int)below(random, (uint)(most - least + 1)));
}

/* A number whose mantissa is random, nearly 1 or 2, or of few bits. */
static float hard_random(uint* random) {
    const uint kind = below(random, 4), bits = next_random(random);
    const uint few = 1u << below(random, 23);
    const uint mantissa = kind == 0   ? bits
                          : kind == 1 ? bits & 15u
                          : kind == 2 ? ~(bits & 15u)
                                      : few | (bits & 3u);
    return as_float(0x3f800000u | (bits & 0x80000000u) | (mantissa & 0x007fffffu));
}

/* Changes a number a little or much; `other`: one of the same input. */
static float varied(uint* random, float value, float other) {
    const uint bits = next_random(random);
    switch (below(random, 8)) {
        case 0:
            return as_float(as_uint(value) + 1u);
        case 1:
            return as_float(as_uint(value) - 1u);
        case 2:
            return as_float(as_uint(value) ^ (bits & 31u));
        case 3:
            return as_float(as_uint(value) ^ (bits & ((1u << below(random, 23)) - 1u)));
        case 4:
            return value * (1.0f + signed_random(random) * power_random(random, -20, -1));
        case 5:
            return bits & 1u ? other : -value;
        case 6:
            return bits & 1u ? 2.0f * value : 0.5f * value;
        default:
            return fabs(value) * hard_random(random);
    }
}

static void vary(uint* random, float* input, uint count) {
    do {
        const uint i = below(random, count);
        input[i] = varied(random, input[i], input[below(random, count)]);
    } while (chance(random, 2));
}

/* A kernel that calls NAME_input(random, input) and NAME_error(input, most), negative where the
 * bound does not apply; `most` lets it stop where the error is less than that.
 *   worst, inputs  in/out  largest error of each work-item, or -1, and what it is of
 *   evaluated      out     how often the bound applied */
#define DEFINE_SEARCH(name, count)                                                  \
    __kernel void search_##name(uint seed, uint steps, __global float* worst,       \
                                __global float* inputs, __global uint* evaluated) { \
        const uint me = get_global_id(0);                                           \
        uint random = (seed ^ me * 0x9e3779b9u) * 0x85ebca6bu;                      \
        float best[count], tried[count], most = worst[me];                          \
        uint valid = 0;                                                             \
        for (uint i = 0; i < count; ++i) best[i] = inputs[count * me + i];          \
        for (uint step = 0; step < steps; ++step) {                                 \
            if (most < 0.0f || chance(&random, 8)) {                                \
                name##_input(&random, tried);                                       \
            } else {                                                                \
                for (uint i = 0; i < count; ++i) tried[i] = best[i];                \
                vary(&random, tried, count);                                        \
            }                                                                       \
            float error = name##_error(tried, most);                                \
            if (error != error) error = INFINITY;                                   \
            if (error < 0.0f) continue;                                             \
            ++valid;                                                                \
            if (!(error > most)) continue;                                          \
            most = error;                                                           \
            for (uint i = 0; i < count; ++i) best[i] = tried[i];                    \
        }                                                                           \
        worst[me] = most;                                                           \
        evaluated[me] = valid;                                                      \
        for (uint i = 0; i < count; ++i) inputs[count * me + i] = best[i];          \
    }

#endif
