// patterns.hpp - which elements of a stream are kept:
//   random       each one by itself
//   runs         kept and dropped ones in turn, runs of random length, 128 elements on average
//   alternating  as evenly as can be
//   sorted       the first ones
//   mask:NAME    pixels of RSH_SCENES/masks/NAME.pbm, row by row, over and over
//   file:NAME    those of a file, see streams/stream_files.hpp
//   pairs:SCENE:LEVEL  the survivors among a level's tested pairs, see pair_stream.hpp
#pragma once

#include "reduce/stream.hpp"

namespace bench {

// Of the patterns above that need nothing but the spec: all but pairs. Throws std::runtime_error
// for an unknown one, or when there is no such mask.
std::vector<cl_uchar> make_flags(const StreamSpec& spec);

// Names of the masks there are: none without RSH_SCENES.
std::vector<std::string> mask_names();

}  // namespace bench
