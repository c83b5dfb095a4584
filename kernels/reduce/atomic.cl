/* atomic.cl - stream reduction by one atomic counter that every kept element takes its
 * place from. Not stable, and slow where much is kept: it shows what the others save.
 *   input, flags  in   the stream
 *   output        out  its kept elements, in any order
 *   output_count[output_index]  in/out  0, then how many
 */
#include "lanes/stride.h"
#include "reduce/element.h"

__kernel void rsh_reduce_atomic(RSH_STREAM, __global uint* output,
                                volatile __global uint* output_count, uint output_index)
{
    const strided_range mine = my_elements(RSH_LENGTH);
    for (uint i = mine.begin; i < mine.end; i += mine.step)
        if (is_kept(input, flags, i)) {
            const uint at = atomic_inc(output_count + output_index);
            store_element(load_element(i, input), at, output);
        }
}
