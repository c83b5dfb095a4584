// wave.hpp - from one wave of rays to the next, packed, and the way back of what it saw; see
// kernels/shade/wave.cl.
#pragma once

#include <rsh/rsh.h>

#include "device/cl/recorder.hpp"
#include "device/layout.hpp"
#include "shade/types.h"

namespace rsh {

// Which kinds of rays hits may send on.
cl_uint branch_kinds(const rsh_scene& scene);

// All rays of a wave in screen order, or of a packed one (height 1).
wave_part whole_wave(cl_uint width, cl_uint height);

struct WavePass {
    const rsh_scene* scene;
    wave_part part;
    cl_mem list_count;  // how many of the part's rays there are; NULL: all
    float min_weight;
    cl_mem rays, hits, weights;                          // of the wave; weights NULL: all 1
    cl_mem branches;                                     // two words per ray
    cl_mem counts;                                       // see wave_count_words
    cl_uint bounce;                                      // of the wave
    cl_mem spawned_counts;                               // word `bounce`: rays that are sent on
    cl_uint capacity;                                    // of the next one; if that is less,
    cl_mem next_count;                                   // one word: it has none, else all
    cl_mem spawned_rays, spawned_weights, spawned_skip;  // of the next one
};

// For waves of up to width * height rays.
size_t wave_count_words(const Context& context, cl_uint width, cl_uint height);

// How many rays the part sends on, to spawned_counts.
void count_branches(Recorder& recorder, const WavePass& pass);
// After count_branches: those rays.
void spawn_branches(Recorder& recorder, const WavePass& pass);
// Adds the colours of the next wave to those of the part. next_count: one word, 0: there are none;
// NULL: there are some.
void gather_branches(Recorder& recorder, const WavePass& pass, cl_mem next, cl_mem colour,
                     cl_mem next_count = nullptr);

}  // namespace rsh
