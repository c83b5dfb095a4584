/* rsh_bench_plugin.h - how somebody else's stream reduction takes part in rsh-bench reduce: as a shared
 * object that exports rsh_bench_get_plugin, given by --plugin FILE.so. Needs OpenCL's header and nothing
 * of rsh. example_plugin.c is one; it is compiled by
 *
 *     cc -shared -fPIC -o example_plugin.so example_plugin.c -lOpenCL
 */
#ifndef RSH_BENCH_PLUGIN_H
#define RSH_BENCH_PLUGIN_H

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever anything below changes. */
#define RSH_BENCH_PLUGIN_VERSION 1u

/* What tells that element i is kept. */
enum {
    RSH_BENCH_KEEP_FLAGS = 0,    /* byte i of `flags` is not 0                 */
    RSH_BENCH_KEEP_NOT_NULL = 1, /* its first 4 bytes are not 0xffffffff       */
    RSH_BENCH_KEEP_BITS = 2      /* bit i % 8 of byte i / 8 of `flags` is set  */
};

/* What to reduce: the kept elements of `input` to the front of `output`, and how many there are to
 * `output_count`. All objects are the caller's, and live as long as the state made for the stream. */
typedef struct rsh_bench_stream {
    cl_context context;
    cl_device_id device;
    cl_command_queue queue; /* in order                                          */
    cl_uint element_bytes;  /* 4, 8, 12 or 16                                    */
    cl_uint count;          /* elements of `input`, at least 1                   */
    cl_uint keep;           /* RSH_BENCH_KEEP_...                                */
    cl_mem input;           /* in: must stay as it is                            */
    cl_mem flags;           /* in: NULL with RSH_BENCH_KEEP_NOT_NULL             */
    cl_mem output;          /* out: room for `count` elements                    */
    cl_mem output_count;    /* out: one cl_uint                                  */
} rsh_bench_stream;

/* What create and run return; every other value is a failure. */
enum {
    RSH_BENCH_DONE = 0,
    RSH_BENCH_REFUSED = 1 /* create: it does not take such streams, which are left out then */
};

/* All calls come from one thread. */
typedef struct rsh_bench_plugin {
    cl_uint version;  /* RSH_BENCH_PLUGIN_VERSION; the first member in every version          */
    const char* name; /* of letters, digits and _: results have it as peer:NAME               */
    cl_bool
        is_stable; /* keeps the order of the input; else any order is right                */

    /* Everything that is done once for a stream: programs, memory of its own. Not timed. */
    int (*create)(const rsh_bench_stream* stream, void** state);
    /* Reduces the stream: enqueues on its queue. Timed from the call to the end of the queue, for
     * which the caller waits. Checked the first time, then called again and again. */
    int (*run)(void* state);
    /* After a create that returned RSH_BENCH_DONE, with nothing left on the queue. */
    void (*destroy)(void* state);
    /* Why the last create or run did not return RSH_BENCH_DONE. */
    const char* (*error)(void); /* NOLINT(modernize-redundant-void-arg): this is C */
} rsh_bench_plugin;

/* What the shared object exports. NULL is a failure. */
const rsh_bench_plugin* rsh_bench_get_plugin(void);

#ifdef __cplusplus
}
#endif

#endif
