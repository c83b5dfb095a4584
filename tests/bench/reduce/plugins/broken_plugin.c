/* broken_plugin.c - a plug-in with a fault, RSH_FAULT, that rsh-bench reduce must tell of: plugins_test.py.
 */
#include "rsh_bench_plugin.h"

#define IDLE 1    /* writes nothing */
#define VERSION 2 /* is of another version */
#define NAME 3    /* has a name that would spoil those of cases */
#define TAKEN 4   /* has the name of a peer */
#define NO_RUN 5  /* lacks a function */
#define CREATE 6  /* cannot be made */
#define RUN 7     /* cannot run */
#define REFUSE 8  /* takes no stream */
#define NO_PLUGIN 9

static int create(const rsh_bench_stream* stream, void** state) {
    (void)stream;
    *state = NULL;
    return RSH_FAULT == CREATE ? -30 : RSH_FAULT == REFUSE ? RSH_BENCH_REFUSED : RSH_BENCH_DONE;
}

static int run(void* state) {
    (void)state;
    return RSH_FAULT == RUN ? -54 : RSH_BENCH_DONE;
}

static void destroy(void* state) {
    (void)state;
}

static const char* error(void) {
    return "as it was told to";
}

const rsh_bench_plugin* rsh_bench_get_plugin(void) {
    static const rsh_bench_plugin plugin = {
        RSH_FAULT == VERSION ? RSH_BENCH_PLUGIN_VERSION + 1 : RSH_BENCH_PLUGIN_VERSION,
        RSH_FAULT == NAME    ? "a/b"
        : RSH_FAULT == TAKEN ? "copy"
                             : "broken",
        CL_TRUE,
        create,
        RSH_FAULT == NO_RUN ? 0 : run,
        destroy,
        error};
    return RSH_FAULT == NO_PLUGIN ? 0 : &plugin;
}
