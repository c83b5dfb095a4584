/* rsh.h - ray tracing with a hierarchy over the rays, and stream reduction, in portable OpenCL.
 *
 * rsh_rasterize finds what the camera sees, rsh_spawn makes the secondary rays, rsh_bound bounds
 * the scene, rsh_build the rays, rsh_traverse finds the closest hits by both, rsh_shadow which
 * lights are hidden there, rsh_shade turns hits into colour. rsh_frame is that loop, made of the
 * same calls; rsh_audit checks hits. Two ways to traverse:
 *
 *   tiles   (the default on CPUs) rays in packets of 16 x 16, bounded by the hierarchy over the
 *           rays, go front to back through a 16-wide bounding volume hierarchy (BVH16) of the
 *           scene, which rsh_bound makes anew or refits every frame, in time linear in the
 *           triangles;
 *   paper_faithful   (the default elsewhere) the method of the paper: spheres around the
 *           triangles, no hierarchy on the scene's side; a stream of (triangle, node) pairs goes
 *           down the hierarchy over the rays, with a stream reduction per level.
 *
 * Paper: Roger, Assarsson, Holzschuch, "Whitted Ray-Tracing for Dynamic Scenes using a Ray-Space
 * Hierarchy on the GPU", EGSR 2007; stream reduction: the same authors, "Efficient Stream
 * Reduction on the GPU", GPGPU workshop 2007.
 *
 * Rules for all functions
 *
 *   Ownership  The caller owns cl_context, cl_device_id, cl_command_queue, cl_mem and cl_event.
 *              Buffers are used while the enqueued commands run and must live until then; none
 *              is retained afterwards. To pass a part of a buffer, pass an OpenCL sub-buffer.
 *   Growth     Descriptors, rsh_scene, rsh_sizes, rsh_statistics and rsh_selftest start with
 *              struct_size = sizeof the struct; a member that is zero or NULL takes its default.
 *              They grow only at the end: any size from that of version 0.1 to the library's own
 *              is taken, and members that the caller lacks count as zero. A larger one is
 *              RSH_INVALID_VALUE: the library is older than the header. rsh_geometry and the
 *              structs of rsh_types.h have no struct_size and never change size; their
 *              `reserved` words must be 0. Host data that descriptors point at (a scene, a wait
 *              list) is read before the call returns.
 *              Planned, so that nothing has to move: at the end of rsh_scene offset and stride of
 *              texture coordinates. In reserved words of rsh_geometry 16-bit indices; of rsh_camera,
 *              rsh_material, rsh_light and rsh_texture what stands beside them.
 *   Opaque     The contents of bounds and nodes are the library's alone. Both begin with what
 *              they were made for, and a traversal looks at that on the device. Where bounds or
 *              nodes were made for another shape, another number of triangles (box: or of those
 *              that stand still), a screen or list of another size, or not at all, the traversal
 *              finds no hits, touches nothing else, and leaves a mark that rsh_device_status and
 *              rsh_get_statistics report; rsh_frame returns RSH_INVALID_VALUE where it waits, once
 *              per strip. That vertices or rays have other values by now, or that the caller wrote
 *              into bounds or nodes, is not found out.
 *   Overlap    Memory that a call writes (outputs, scratch) must not overlap other memory that
 *              it reads or writes: RSH_INVALID_VALUE. Sub-buffers are compared by their parent
 *              and range. Members that are marked in/out are one piece of memory.
 *   Async      A function with (wait_count, wait_list, done) only enqueues: it waits for no
 *              event, flushes nothing, reads nothing back. *done, if `done` is not NULL, is a
 *              valid event of the caller's that ends after everything the call enqueued, also
 *              when there was nothing to do; after a failure it is NULL if nothing was
 *              enqueued, else as ever: until then commands use the call's buffers. As in
 *              OpenCL, `done` must not point into wait_list. In-order and out-of-order queues
 *              both work. A wait list with an event that has failed is refused, with
 *              CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST; when one fails later, the call's
 *              commands and *done fail with it. rsh_frame, rsh_trace with batches,
 *              rsh_get_statistics, rsh_device_status, rsh_device_selftest, rsh_create_context,
 *              rsh_prepare, rsh_wait_prepared and rsh_release_context may block, and say so.
 *   Queries    rsh_<call>_query refuses the values that the call refuses, but looks at no
 *              buffer: those may be NULL or too small. It does no device work.
 *   Scratch    rsh_<call>_query says how many bytes `scratch` needs. NULL takes it from the
 *              context's pool, which grows on first use and then stays: a block per in-order
 *              queue in use, and on out-of-order queues one per call under way, but that a call
 *              which waits for the event of another takes over its block. No call waits for
 *              another because of it. Contents are undefined before and after; one scratch
 *              buffer serves one call at a time.
 *   Errors     Every argument is checked before anything is enqueued; a status other than
 *              RSH_SUCCESS means that outputs are unchanged, except after an OpenCL failure, a
 *              kernel too large for the device (RSH_UNSUPPORTED), RSH_CANCELLED or a wrong answer of
 *              an rsh_batch_fill in the middle of a call, when they are undefined and *done tells
 *              when their memory is free again. rsh_last_error() says more. No exception leaves a function, and
 *              no failure needs memory to be told, that of memory included: then the call
 *              returns RSH_OUT_OF_MEMORY, and works again when there is some.
 *   Threads    Any function may be called from any thread. Calls on one context run side by
 *              side if their output buffers differ; rsh_release_context must be the last call
 *              on it.
 *   Loaders    A process may hold several loaders of OpenCL (libOpenCL.so.1), as Python's pyopencl
 *              brings its own. Objects of any of them can be passed: rsh calls OpenCL through the
 *              loader that it is linked to, and through the driver itself for objects that this
 *              loader cannot call, those of one from before cl_khr_icd 2.0.0 where it is newer.
 *              Layers (OPENCL_LAYERS) do not see these calls. What rsh returns can be used by
 *              the loader that made the context.
 *   Exactness  Hits do not depend on engine, strategy, budget or the order in which work-items
 *              run: they equal brute force with the same ray-triangle routine, bit for bit. Of
 *              equal t, the lower triangle index wins; coincident triangles have equal t,
 *              whichever corner comes first and whichever way round they are.
 *
 * All calls: since 0.1.
 */
#ifndef RSH_H
#define RSH_H

#include <rsh/rsh_types.h>
#include <stddef.h>

#if defined(RSH_STATIC)
#define RSH_API
#elif defined(_WIN32)
#ifdef RSH_BUILDING
#define RSH_API __declspec(dllexport)
#else
#define RSH_API __declspec(dllimport)
#endif
#else
#define RSH_API __attribute__((visibility("default")))
#endif

#define RSH_VERSION_MAJOR 0
#define RSH_VERSION_MINOR 1
#define RSH_VERSION_PATCH 0
#define RSH_MAKE_VERSION(major, minor, patch) (((major) * 1000000) + ((minor) * 1000) + (patch))
#define RSH_VERSION RSH_MAKE_VERSION(RSH_VERSION_MAJOR, RSH_VERSION_MINOR, RSH_VERSION_PATCH)

#ifdef __cplusplus
extern "C" {
#endif

/* ---- status ---- */

/* 0 is success, OpenCL's own negative codes pass through, rsh's own start at -4096. */
typedef cl_int rsh_status;
enum {
    RSH_SUCCESS = 0,
    RSH_INVALID_VALUE = -4096,    /* a field is wrong; the message names it                   */
    RSH_BUFFER_TOO_SMALL = -4097, /* a buffer holds fewer bytes than the call needs           */
    RSH_NO_DEVICE = -4098,        /* no platform or device: is an OpenCL driver installed?    */
    RSH_BUILD_FAILED = -4099,     /* a kernel did not compile; the message has the log        */
    RSH_UNSUPPORTED = -4100,      /* the device lacks what the call needs                     */
    RSH_OUT_OF_MEMORY = -4101,    /* the host is out of memory                                */
    RSH_CANCELLED = -4102,        /* the progress callback, or a source of batches, asked to stop */
    RSH_INTERNAL_ERROR = -4103    /* a defect of rsh                                          */
};

/* Name and one-line meaning of a status, for any value. Static storage. */
RSH_API const char* rsh_status_string(rsh_status status);

/* What the last failed call of this thread found wrong: field, actual and required value; for
 * RSH_BUILD_FAILED the compiler's log. Cut off after 16 KB. Never NULL; valid until the thread's
 * next rsh call. */
RSH_API const char* rsh_last_error(void);

/* RSH_VERSION of the library at run time; differs from the header's when they do not match. */
RSH_API cl_uint rsh_version(void);

/* ---- context ---- */

/* Programs, kernels and scratch memory for one device of one OpenCL context. */
typedef struct rsh_context_s* rsh_context;

/* Called with one line about what a call does that takes long or falls back: a program compiled
 * or loaded from disk and how long that took, a program on disk that was refused, a strategy that
 * the self-test masked, a variant that failed where a general program serves. From the calling
 * thread, which may be any and several at once, or that of rsh_prepare; must not call rsh on that
 * context. The text is gone when it returns. What it throws, as other callbacks do, ends the call
 * with RSH_INTERNAL_ERROR. */
typedef void (*rsh_log)(const char* message, void* user);

/* The variants that a program has at most, see rsh_create_context; and to do without any. */
#define RSH_MAX_VARIANTS 8u
#define RSH_NO_VARIANTS 0xffffffffu

typedef struct rsh_context_desc {
    size_t struct_size;
    cl_context context;     /* retained until release */
    cl_device_id device;    /* of that context */
    cl_uint vector_width;   /* elements per work-item written out as a vector: 1, 4, 8 or 16;
                               0: what suits the device (1 on GPUs) */
    const char* cache_dir;  /* programs on disk, see rsh_create_context; "": none; NULL: the
                               folder RSH_CACHE_DIR, else rsh in XDG_CACHE_HOME, else .cache/rsh
                               in HOME, from the environment; none without these */
    const char* kernel_dir; /* kernel sources, while developing; NULL: RSH_KERNEL_DIR, else the
                               embedded ones */
    rsh_log log;            /* NULL: silence */
    void* log_user;         /* handed to `log`; must live as long as the context */
    cl_ulong cache_bytes;   /* what programs on disk may take together; 0: 256 MiB */
    cl_uint max_variants;   /* variants that are compiled of one program; 0: RSH_MAX_VARIANTS,
                               which is all; or RSH_NO_VARIANTS */
} rsh_context_desc;

/* Makes a context. Compiles nothing: a program is built by the first call that needs it, which
 * blocks meanwhile.
 *
 * Cache:   what a program compiles to may be kept in a folder, which is made for the user alone
 *          (mode 0700), and is loaded from there by later contexts. As it is code that will run,
 *          folder and file must belong to the process's effective user, root being no exception,
 *          and be writable by nobody else; a file must be a regular one of at most 64 MiB, whose
 *          SHA-256 digest over the binary and what it was made from is the one that it begins
 *          with. A file that is refused is removed and its program compiled anew; with a folder
 *          that is refused all are. The log is told the reason, of the first refusal of a
 *          context. When a program is stored, the files of rsh in the folder that were used least
 *          recently, to store or to load, are removed until all fit into `cache_bytes`; a program
 *          that is larger by itself, or than 64 MiB, is not stored. Any number of contexts, threads
 *          and processes may use a folder at once; each keeps to its own cap.
 * Variants: what shading, spawning and rsh_find_surfaces run is compiled for four features of the
 *          scene, RSH_FEATURE_REFRACTION, _TEXTURE, _SMOOTH_NORMAL and _ENVIRONMENT_IMAGE: 16
 *          variants of one program. The general program asks the scene for them instead: the same
 *          bits, but slower. Calls take it for a variant that is one more than `max_variants`, of
 *          those that calls and rsh_prepare have named so far; and as rsh_prepare says.
 * Errors: RSH_INVALID_VALUE (device is not of the context; max_variants), RSH_UNSUPPORTED (no
 * OpenCL C 1.2, no compiler, big-endian). Cost: microseconds. */
RSH_API rsh_status rsh_create_context(const rsh_context_desc* desc, rsh_context* context);

/* Frees a context made by rsh_create_context, its programs and its scratch memory, once the
 * commands enqueued by its calls have finished; does not wait for them, but BLOCKS for a program that
 * is being compiled in the background, see rsh_prepare. While counting, and after batches, the library must stay loaded
 * until the commands have finished. NULL is ignored. */
RSH_API void rsh_release_context(rsh_context context);

/* Picks a device, for programs that have no context of their own: the first whose name, or
 * whose platform's, contains `name`; with NULL, RSH_DEVICE from the environment; without that,
 * the first device of the first platform that has one. Errors: RSH_NO_DEVICE; the text tells what
 * there is, and of PoCL without a device, which variable of the environment names its cache. */
RSH_API rsh_status rsh_find_device(const char* name, cl_platform_id* platform,
                                   cl_device_id* device);

/* ---- statistics ---- */

/* Where a frame's time goes, in the paper's stages. */
enum {
    RSH_STAGE_RASTERIZE = 0, /* primary rays and hits                              */
    RSH_STAGE_BOUND = 1,     /* bounds of the scene                                */
    RSH_STAGE_SPAWN = 2,     /* secondary and shadow rays                          */
    RSH_STAGE_BUILD = 3,     /* the hierarchy                                      */
    RSH_STAGE_TEST = 4,      /* triangles against nodes                            */
    RSH_STAGE_REDUCE = 5,    /* stream reduction                                   */
    RSH_STAGE_INTERSECT = 6, /* ray-triangle tests; tiles: the whole traversal     */
    RSH_STAGE_SHADE = 7,     /* shading                                            */
    RSH_STAGE_OTHER = 8,     /* clears, reads, and what no other stage claims      */
    RSH_STAGE_COUNT = 9
};

typedef struct rsh_statistics {
    size_t struct_size;
    cl_ulong stage_ns[RSH_STAGE_COUNT]; /* device time; 0 without CL_QUEUE_PROFILING_ENABLE  */
    cl_ulong launches;                  /* commands enqueued                                 */
    cl_ulong host_waits;                /* times a call blocked for the device               */
    cl_ulong programs_built;            /* compiled from source                              */
    cl_ulong programs_loaded;           /* taken from the disk cache                         */
    cl_ulong traversals;
    cl_ulong batches;                   /* ranges of triangles that traversals worked off    */
    cl_ulong pairs_tested[RSH_MAX_LEVELS + 1]; /* (triangle, node) pairs that the streams of
                                                  level l held; [0]: (triangle, ray) pairs   */
    cl_ulong pairs_walked[RSH_MAX_LEVELS + 1]; /* of these, finished depth first because the
                                                  budget was full; what came below them is
                                                  counted nowhere                            */
    cl_ulong peak_pairs;                       /* longest stream that left a reduction       */
    cl_ulong node_tests;                       /* boxes or spheres of the scene tested against
                                                  nodes over the rays or single rays         */
    cl_ulong ray_tests;                        /* triangles intersected with rays            */
    cl_ulong active_rays[RSH_MAX_LEVELS + 1];  /* rsh_frame: rays per bounce; [0]: pixels with
                                                  a primary hit                              */
    cl_ulong shadow_rays[RSH_MAX_LEVELS + 1];  /* rsh_frame: shadow rays cast at the hits of
                                                  that bounce                                */
    cl_ulong scratch_bytes;                    /* in the context's pool                      */
    cl_ulong wrong_buffers;                    /* RSH_WRONG_... bits of all traversals       */
    cl_ulong variants;                         /* compiled or loaded since the context was
                                                  made; see rsh_create_context               */
    cl_ulong general_launches;                 /* of `launches`, kernels of general programs */
} rsh_statistics;

/* Starts (enabled = 1) or stops counting on this context, from zero. Counting keeps the event
 * of every command and reads counts back; without it, neither happens. Does not wait: what was
 * enqueued before is not counted. */
RSH_API rsh_status rsh_count_statistics(rsh_context context, cl_bool enabled);

/* Adds up everything enqueued since rsh_count_statistics. BLOCKS until those commands ended,
 * but not the calls of other threads. Commands that failed count as launches and nothing more.
 * Set statistics->struct_size first. */
RSH_API rsh_status rsh_get_statistics(rsh_context context, rsh_statistics* statistics);

/* RSH_INVALID_VALUE, and a text that says which, when a traversal on this context met bounds or
 * nodes that were not made for it, since the last call of rsh_device_status; else RSH_SUCCESS.
 * BLOCKS until the commands enqueued on `queue` before have ended; traversals on other queues
 * count if they have ended by then. When one of those commands fails meanwhile:
 * CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST. */
RSH_API rsh_status rsh_device_status(rsh_context context, cl_command_queue queue);

/* ---- what a scene needs ---- */

/* Bits of a feature mask: whatever is not set is not compiled, allocated or launched. */
typedef cl_uint rsh_features;
#define RSH_FEATURE_REFLECTION 0x01u
#define RSH_FEATURE_REFRACTION 0x02u
#define RSH_FEATURE_SHADOW 0x04u
#define RSH_FEATURE_TEXTURE 0x08u
#define RSH_FEATURE_SMOOTH_NORMAL 0x10u
#define RSH_FEATURE_ENVIRONMENT_IMAGE 0x20u
#define RSH_FEATURE_ALL 0x3fu

/* Triangles. A triangle with an index out of range or a vertex that is not finite is never hit;
 * nor is one without area, or, as far as floats tell, seen edge-on. Both faces count. */
typedef struct rsh_geometry {
    cl_mem vertices;              /* in: x, y, z as floats [world] at every stride        */
    cl_ulong vertices_offset;     /* bytes before the first x, a multiple of 4            */
    cl_uint vertex_stride;        /* bytes, a multiple of 4; 0: 12, tightly packed        */
    cl_uint vertex_count;
    cl_mem indices;               /* in: three cl_uint per triangle; NULL: triangle i has the
                                     vertices 3i, 3i + 1, 3i + 2                          */
    cl_ulong indices_offset;      /* bytes, a multiple of 4                               */
    cl_uint triangle_count;       /* below 2^28 */
    cl_uint range_count;          /* meshes that the triangles are of; 0: one, with id 0   */
    cl_uint still_triangles;      /* so many, the first ones, stand still while others move: for
                                     bounds that are kept, see RSH_BOUND_REFIT. The same in all
                                     calls that share bounds; 0: none                      */
    cl_uint reserved[5];          /* 0; for 16-bit indices */
    cl_mem ranges;                /* in: range_count x rsh_mesh_range, by first_triangle;
                                     NULL when range_count is 0                           */
    cl_mem reserved_buffers[3];   /* NULL; likewise */
} rsh_geometry;

/* What rsh_frame takes a ray to see that it does not trace. */
enum {
    RSH_CUT_BLACK = 0,      /* nothing                                                        */
    RSH_CUT_AMBIENT = 1,    /* the ambient light                                              */
    RSH_CUT_ENVIRONMENT = 2 /* the environment that lies that way, as if nothing were between */
};

/* Geometry with everything that shading reads. All arrays live in device buffers, so a moving
 * mesh re-uploads its vertices (and normals) only. */
typedef struct rsh_scene {
    size_t struct_size;
    rsh_geometry geometry;
    cl_mem normals;               /* 3 floats per vertex, see normal_stride; NULL: flat    */
    cl_mem texcoords;             /* 2 floats per vertex, packed; NULL: no textures        */
    cl_mem material_ids;          /* cl_uint per triangle; NULL: material 0 everywhere;
                                     out of range: material 0                              */
    cl_mem materials;             /* material_count x rsh_material                         */
    cl_uint material_count;       /* at least 1 */
    cl_mem lights;                /* light_count x rsh_light; may be NULL when there is none */
    cl_uint light_count;          /* at most RSH_MAX_LIGHTS */
    cl_uint shadow_lights;        /* bit k: light k casts shadows; see rsh_find_features   */
    cl_uint positional_lights;    /* bit k: light k is a point or spot light, whose shadow rays
                                     rsh_frame builds as converging. Changes time only     */
    cl_mem textures;              /* texture_count x rsh_texture                           */
    cl_uint texture_count;
    cl_mem texels;                /* what they point into */
    rsh_float4 ambient;           /* rgb of the light from everywhere, w: 0                */
    rsh_float4 environment;       /* rgb that a ray sees which hits nothing; scales the image */
    cl_uint environment_texture;  /* 1 + index of a latitude-longitude image, see rsh_texture;
                                     0: none, the plain colour                             */
    rsh_features features;        /* what shading must support; 0: nothing beyond flat, local
                                     light; see rsh_find_features                          */
    cl_uint cut;                  /* RSH_CUT_..., of rays after the last bounce and of those that
                                     weigh no more than rsh_frame's min_weight             */
    cl_uint normal_stride;        /* bytes, a multiple of 4, at least 12; 0: 12, packed. Normals may
                                     lie between the vertices, in the same buffer          */
    cl_ulong normals_offset;      /* bytes before the first normal, a multiple of 4        */
} rsh_scene;

/* Fills scene->features, shadow_lights and positional_lights with what these materials and
 * lights (host copies of the device arrays) and the buffers present in `scene` need. Call it
 * when they change; leave a bit out to switch a feature off. Without RSH_FEATURE_REFRACTION a
 * material's transmission counts as 0. */
RSH_API rsh_status rsh_find_features(rsh_scene* scene, const rsh_material* materials,
                                     const rsh_light* lights);

/* ---- primary rays ---- */

/* Where the pixels of a call lie in a larger picture; they have its bits, and `camera` is that of the
 * picture. All 0: they are the picture. */
typedef struct rsh_window {
    cl_uint x, y;           /* the first pixel, from the picture's left and top              */
    cl_uint picture_width;  /* pixels, at least x + width, at most 16384; 0: `width`, x is 0 */
    cl_uint picture_height; /* as well                                                       */
} rsh_window;

typedef struct rsh_rasterize_desc {
    size_t struct_size;
    rsh_geometry geometry;
    rsh_camera camera;
    cl_uint width;          /* pixels, 1 .. 16384 */
    cl_uint height;
    cl_mem rays;            /* out: width * height x rsh_ray, row by row from the top       */
    cl_mem hits;            /* out: width * height x rsh_hit                                */
    cl_mem scratch;
    size_t scratch_budget;  /* bytes for the tiles' lists; 0: what usually suffices. With
                               less the call is slower, never wrong                         */
    rsh_window window;
} rsh_rasterize_desc;

typedef struct rsh_sizes {
    size_t struct_size;
    size_t output_bytes;  /* of the call's own output: bounds or nodes */
    size_t scratch_bytes;
} rsh_sizes;

RSH_API rsh_status rsh_rasterize_query(rsh_context context, const rsh_rasterize_desc* desc,
                                       rsh_sizes* sizes);

/* Finds the triangle that each pixel's centre sees, in screen tiles (cf. Laine and Karras
 * 2011).
 *
 * Effect:  rays = the camera's rays with unit directions; hits = their closest hits, the same
 *          bits that rsh_traverse finds for these rays: shared edges neither crack nor overlap.
 * Limits:  one sample per pixel; triangles across the near plane are clipped by tmin.
 * Errors:  RSH_INVALID_VALUE (camera not finite, no direction), RSH_BUFFER_TOO_SMALL.
 * Cost:    O(triangles + pixels * triangles that cover them); three launches. */
RSH_API rsh_status rsh_rasterize(rsh_context context, cl_command_queue queue,
                                 const rsh_rasterize_desc* desc, cl_uint wait_count,
                                 const cl_event* wait_list, cl_event* done);

/* ---- the scene's side ---- */

/* The shape of the nodes over the rays, and with it what they are tested against on the scene's
 * side. */
enum {
    RSH_SHAPE_DEFAULT = 0, /* what the device's default engine takes: box on CPUs, elsewhere
                              cone. In rsh_frame_desc: what the frame's engine takes          */
    RSH_SHAPE_CONE = 1,    /* a cone capped by a sphere (Roger et al. 2007), against spheres
                              around the triangles                                            */
    RSH_SHAPE_BOX = 2      /* a box of origins and a box of directions, against the BVH16 of the
                              scene                                                           */
};

/* How bounds are made. Hits are the same. */
enum {
    RSH_BOUND_FAST = 0,   /* anew, quickly: for one frame                                     */
    RSH_BOUND_REFIT = 1,  /* as made in an earlier frame into the same buffer: which triangles
                             are together stays, the boxes are fitted to where they are now. Made
                             anew, as with QUALITY, where the boxes have grown too much, or were
                             made of another number of triangles. A buffer without bounds gets
                             some as well, and is reported as RSH_WRONG_BOUNDS: begin with
                             QUALITY. With geometry.still_triangles the bounds of these are left
                             alone, neither read nor written, and all this is said of the others.
                             A BVH16 of another still_triangles or triangle_count is reported, too,
                             and left unfit for use. Where all stand still, traversals report it  */
    RSH_BOUND_QUALITY = 2 /* anew, with more care: for bounds that are kept, to be refitted or for
                             many frames of a scene that stands still                         */
};

typedef struct rsh_bound_desc {
    size_t struct_size;
    rsh_geometry geometry;
    cl_uint shape;  /* RSH_SHAPE_... */
    cl_mem bounds;  /* out, with RSH_BOUND_REFIT in/out: rsh_sizes.output_bytes               */
    cl_mem scratch; /* box */
    cl_uint mode;   /* RSH_BOUND_...; cone: of REFIT only that it leaves still triangles alone */
} rsh_bound_desc;

/* Bounds the triangles, rounded outwards. Once per frame, shared by all traversals of that
 * frame.
 *
 * cone:    a sphere per triangle.
 * box:     a BVH16. Triangles are put in the order of a Hilbert curve, large ones first; the
 *          curve is cut into leaves of 8 to 16 where boxes are smallest. Meshes whose triangles
 *          lie close to those before them in the index take two thirds of the time.
 *          FAST: 8 to 16 leaves, or nodes, in a row make a node. QUALITY: leaves are paired with
 *          their nearest neighbours (PLOC, Meister and Bittner 2018), and nodes of 16 are taken
 *          out of that binary tree by their surface; a fourth more time, and rays with little in
 *          common take up to a fifth less. REFIT: two fifths of the time of FAST. The surface of
 *          boxes at up to 320 places, relative to that of their triangles, decides on the device
 *          whether to make them anew in the same call: from 1.2 times what it was.
 *          With still_triangles the BVH is of two trees below one node: those that stand still, and
 *          those that move. FAST and QUALITY make both, one after the other, in twice as many
 *          launches; REFIT the second one alone. Rays visit one node more.
 * Cost:    linear in the triangles, REFIT in those that move. output_bytes of the query: cone 16,
 *          box about 55 per triangle; scratch_bytes: box about 9, 14 with QUALITY and REFIT. */
RSH_API rsh_status rsh_bound_query(rsh_context context, const rsh_bound_desc* desc,
                                   rsh_sizes* sizes);
RSH_API rsh_status rsh_bound(rsh_context context, cl_command_queue queue,
                             const rsh_bound_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done);

/* ---- the hierarchy over the rays ---- */

typedef struct rsh_build_desc {
    size_t struct_size;
    cl_mem rays;      /* in: width * height x rsh_ray                                         */
    cl_uint width;    /* rays in screen order, row by row; a list of `width` rays: height 1 */
    cl_uint height;   /* at most 16384 x 16384 for a grid; 0: 1, a list of at most 2^28       */
    cl_mem nodes;     /* out: rsh_sizes.output_bytes                                          */
    cl_uint converging; /* 1: the rays run towards one point, where t = 1, as shadow rays of a
                         point light do; then nodes bound them from there, backwards, which
                         leaves far fewer pairs. Rays with tmax above 1 are found all the same,
                         slowly. 0: nodes bound them from their origins */
    cl_uint shape;    /* RSH_SHAPE_... */
    cl_mem scratch;   /* box, lists */
    cl_mem list_count; /* in: one cl_uint: how many rays a list has, of `width` at most, where
                          only the device knows; a larger number counts as `width`. NULL: width,
                          and the only choice of a grid                                       */
} rsh_build_desc;

RSH_API rsh_status rsh_build_query(rsh_context context, const rsh_build_desc* desc,
                                   rsh_sizes* sizes);

/* Builds the hierarchy over the rays, bottom-up (Roger et al. 2007, step 2).
 *
 * Effect:  every node contains all active rays below it, rounding included. Lists of box are
 *          sorted by direction and origin where rays that follow each other are no neighbours;
 *          the rays themselves and their answers stay where they are.
 *          list_count: only that many rays are read and bounded; sizes are those of `width`.
 * Cost:    O(rays). cone: one launch per level, 43 bytes per ray; box: one launch, 3.5 bytes,
 *          for a list 7 launches, 7.5 bytes and about 10 of scratch. With list_count as many
 *          launches as `width` needs, whose work-items beyond the count return at once. */
RSH_API rsh_status rsh_build(rsh_context context, cl_command_queue queue,
                             const rsh_build_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done);

/* ---- traversal ---- */

/* How to traverse. */
enum {
    RSH_ENGINE_DEFAULT = 0,        /* auto: what suits the device: tiles on CPUs, elsewhere
                                      paper_faithful; see rsh_default_engine                  */
    RSH_ENGINE_PAPER_FAITHFUL = 1, /* breadth first, a stream of pairs, a reduction per level;
                                      every triangle starts at the root; shape: cone          */
    RSH_ENGINE_BRUTE_FORCE = 2,    /* every ray against every triangle: the yardstick; takes
                                      no bounds and no nodes                                  */
    RSH_ENGINE_TILES = 3,          /* each tile of 256 rays goes through the BVH16 front to back
                                      and stops behind its last hit; shape: box               */
    RSH_ENGINE_PAPER = 4           /* as paper_faithful, tuned: 16 children at a time, a range
                                      of triangles per node, survivors counted before they
                                      are written; shape: box                                 */
};

/* How to reduce a stream; see rsh_reduce. Experimental ones are there to be compared with: they can
 * be named like all others, but auto never picks them. */
enum {
    RSH_STRATEGY_DEFAULT = 0,      /* RSH_STRATEGY_AUTO */
    RSH_STRATEGY_CHUNK = 1,        /* a range of elements per work-item, no barrier; stable   */
    RSH_STRATEGY_SCAN_SCATTER = 2, /* prefix sums in work-groups, then scatter; stable        */
    RSH_STRATEGY_AUTO = 3,         /* what suits device, length and density; stable           */
    RSH_STRATEGY_BLOCK = 4,        /* blocks on their own, then their ranges are moved (Roger
                                      et al. 2007); stable                                    */
    RSH_STRATEGY_BLOCK_SEARCH = 5, /* experimental: the same with the search that stood in for
                                      scattering; stable                                      */
    RSH_STRATEGY_ATOMIC = 6,       /* an atomic increment per kept element; any order         */
    RSH_STRATEGY_ATOMIC_GROUP = 7, /* an atomic addition per tile; any order                  */
    RSH_STRATEGY_COUNT_EMIT = 8,   /* a bit per element and counts, then the output; stable   */
    RSH_STRATEGY_LOOKBACK = 9,     /* one pass, each tile asks the ones before it (Merrill and
                                      Garland 2016); stable                                   */
    RSH_STRATEGY_HORN = 10,        /* experimental: log-step prefix sum, search (Horn 2005);
                                      stable                                                  */
    RSH_STRATEGY_BLELLOCH = 11     /* experimental: work-efficient prefix sum, scatter
                                      (Blelloch 1990); stable                                 */
};

/* What to find. */
enum {
    RSH_QUERY_CLOSEST = 0, /* hits: the closest hit of each ray                               */
    RSH_QUERY_ANY = 1,     /* occlusion: whether anything is hit, one bit per ray             */
    RSH_QUERY_COUNT = 2,   /* the number of triangles that each ray crosses                   */
    RSH_QUERY_ALL = 3      /* these triangles, as a list of hits per ray                      */
};

/* Which sides of triangles are not hit. The front is the side that sees the corners counter-clockwise, in
 * the order of the index: the one that (v1 - v0) x (v2 - v0) points to. */
enum {
    RSH_CULL_NONE = 0,
    RSH_CULL_BACK = 1, /* only fronts are hit */
    RSH_CULL_FRONT = 2 /* only backs are hit  */
};

/* Called on the calling thread before each batch is enqueued; nonzero cancels: the call returns
 * RSH_CANCELLED and outputs are undefined. */
typedef int (*rsh_progress)(cl_uint batch, cl_uint batch_count, void* user);

typedef struct rsh_traverse_desc {
    size_t struct_size;
    rsh_geometry geometry;
    cl_mem bounds;         /* in: from rsh_bound; NULL: made in scratch, which the query counts,
                              so that there it must be NULL, or not, as in the call           */
    cl_mem rays;           /* in: width * height x rsh_ray                                    */
    cl_mem nodes;          /* in: from rsh_build over these rays; unused by brute force       */
    cl_uint width;
    cl_uint height;        /* 0: 1, as in rsh_build_desc                                      */
    cl_uint query;         /* RSH_QUERY_... */
    cl_mem hits;           /* closest: out, with `continued` in/out: width * height x rsh_hit;
                              all: out: hit_capacity x rsh_hit, ray by ray, those of a ray by t, of
                              equal t by primitive. Left alone if there are more than that    */
    cl_mem occlusion;      /* any: in/out: width * height x cl_uint, a mask per ray           */
    cl_uint occlusion_bit; /* any: 0 .. 31: the bit that is set when the ray hits something;
                              other bits, and rays that hit nothing, stay as they are         */
    cl_uint engine;        /* RSH_ENGINE_... */
    cl_uint shape;         /* RSH_SHAPE_... of `bounds` and `nodes`; one the engine takes     */
    cl_uint strategy;      /* RSH_STRATEGY_...; paper_faithful. paper packs by counts of its
                              own and ignores it                                              */
    size_t budget;         /* paper_faithful, paper: bytes for the pair streams; 0: enough for
                              most scenes, at least RSH_MIN_BUDGET otherwise. Changes time,
                              never a hit                                                     */
    cl_mem scratch;
    rsh_progress progress; /* may be NULL */
    void* progress_user;
    cl_mem skip;           /* in: width * height x cl_uint: a triangle that the ray does not hit,
                              such as the one it left, see rsh_spawn_desc; RSH_NO_HIT: none;
                              NULL: none for all rays                                         */
    cl_mem list_count;     /* in: as in rsh_build_desc; the same number, if it took one: nodes
                              of another count as made for another list                       */
    cl_mem tests_per_ray;  /* in/out: width * height x cl_uint, grows by the boxes and triangles that
                              each active ray was tested against, alone or with others of its packet,
                              for maps of where rays are dear. Engines tiles, which compiles a
                              program of its own for it, and brute_force. NULL: not counted    */
    cl_mem hit_counts;     /* count: out: width * height x cl_uint                            */
    cl_mem hit_offsets;    /* all: out: (width * height + 1) x cl_ulong: where the hits of each ray
                              begin, and at the end how many there are, whether they fit or not */
    cl_ulong hit_capacity; /* all: at most 2^31; 0: only hit_offsets are wanted               */
    cl_mem ray_masks;      /* in: width * height x cl_uint: a ray hits a mesh only if its mask and the
                              rsh_mesh_range's have a bit in common; the mask of a geometry without
                              ranges has all bits. NULL: each ray hits every mesh              */
    cl_uint cull;          /* RSH_CULL_...; with it, or with ray_masks, the kernels that intersect are
                              programs of their own                                           */
    cl_uint continued;     /* closest, any: 1: goes on from the answers of other batches of the scene,
                              which `hits` or the bits of `occlusion` hold: see rsh_traverse    */
    cl_uint first_triangle; /* closest, any: number in the scene of the batch's first triangle, by which
                              hits name its triangles                                         */
    cl_mem skip_corners;   /* in: the triangles that rays have left, of any batch: 9 floats each, the
                              corners in the order of the index. `skip` is then a place in here. NULL:
                              `skip` names triangles of the geometry; not with `continued` or
                              `first_triangle`                                                */
    cl_mem skip_numbers;   /* in, with skip_corners: a cl_uint each: its number in the scene    */
    cl_uint skip_count;    /* how many there are; others are none                             */
} rsh_traverse_desc;

#define RSH_MIN_BUDGET 65536

RSH_API rsh_status rsh_traverse_query(rsh_context context, const rsh_traverse_desc* desc,
                                      rsh_sizes* sizes);

/* Intersects scene and hierarchy top-down (Roger et al. 2007, steps 3 and 4).
 *
 * Effect:  paper_faithful: all triangles start as pairs with the root; per level, each pair is
 *          tested against the four children and the survivors are packed; survivors at level 0
 *          are intersected. Triangles are worked off in batches that fit the budget. Pairs that
 *          a level cannot hold are finished depth first by the work-item that meets them, so
 *          that no stream overflows, no pair is lost and no count is read back.
 *          paper: the same with 16 children per node; a level is counted, then written. Nodes
 *          whose survivors do not fit hand their triangles to the tiles of 256 rays below them,
 *          which finish them at once.
 *          tiles: a work-item takes a tile of 256 rays down the BVH16, the nearest boxes first;
 *          what lies behind the tile's farthest hit is never looked at.
 *          skip: a ray with a triangle to skip also does not hit what only rounding would put
 *          in its way: a triangle whose corners are all behind a plane through the origin that
 *          the ray moves away from, parallel to that triangle or to the one skipped; or in the
 *          latter one (kernels/mesh/leaving.h). No true hit is lost by that, but one that only
 *          touches the triangle where the ray starts.
 *          list_count: the answers of a list of that many rays; other hits, masks and counts are
 *          neither read nor written; with all, other rays have no hits. Statistics count the tests of
 *          these rays.
 *          continued: for scenes that come in batches, each a geometry with bounds of its own. Rays end
 *          where they hit a batch before; with any, tiles does not trace those whose bit is set. After all
 *          batches, in whatever order, hits and bits are those of one geometry with all triangles; of
 *          some batches, those of these. The first call has `continued` 0, which writes all hits.
 *          ray_masks, cull: hits of meshes and sides that are hidden from the ray are none: what lies
 *          behind is found. Front and back are told by the signs that decide about the hit, so that on
 *          the way through a closed surface they take turns: with count, fronts less backs is the
 *          winding number of the ray's origin, negative inside.
 *          count, all: every triangle that the ray crosses from tmin to tmax, coincident ones too. A
 *          ray through an edge or a corner crosses what it would cross if it were moved aside by one
 *          and the same vector that is smaller than any number (simulation of simplicity,
 *          Edelsbrunner and Muecke 1990; kernels/mesh/crossing.h): where it goes through a closed
 *          surface, one of the triangles around that point, where it only touches, none or two. So a
 *          point is inside a closed mesh if the count of any ray from it is odd, if it is farther
 *          from the surface than t errs. Needles count, however thin; triangles edge-on do not. The
 *          order of the corners, that of the triangles and the engine change nothing. Where all hits do
 *          not fit, a second call with hit_offsets' last number as hit_capacity gives them.
 * Errors:  a hit is within 47 * 2^-24 of its triangle, in units of the farthest component of a corner
 *          seen from the ray's origin (docs/numerics.md): some tens for a ground of 1e7, farther
 *          along a ray nearly in its plane; what is nearer to it may be seen behind it. A ray that
 *          starts on a triangle, and does not skip it, may find it near t = 0 or not.
 * Limits:  nothing is hit at t above the largest float, nor by a ray whose direction has no
 *          component of more than 2^-128. Where the device flushes denormals (rsh_selftest), the
 *          same may hold of directions without a component of 2^-126, and of those with one above
 *          2^126. May be missed: triangles with a corner 2^126 or more away from the ray's origin
 *          in a component; by closest and any, needles whose area, as the ray sees them, is less
 *          than 2^-62 of the square of their largest edge: they count as seen edge-on. So does a
 *          triangle with one corner near 1 and another beyond 2^62. Counts and lists have these;
 *          the t of such a triangle, where its corners lie far apart, may be any between theirs.
 * Cost:    paper_faithful: O(triangles + pairs); 1 + launches per level * levels, per batch.
 *          paper: the same, 3 or 4 launches per level and half as many levels; beside the
 *          streams about 1 byte per ray.
 *          ray_masks, cull: a look at each hit; 4 bytes per ray, and of the ranges as many as a search
 *          takes.
 *          tiles: one launch; memory beyond bounds, nodes and hits: none.
 *          continued, first_triangle, skip_corners: programs of their own. tiles and paper write only
 *          hits that change; with closest, the other engines take 48 bytes of scratch per ray and two
 *          launches.
 *          count: as closest, but to the end of each ray. all: beside that 24 bytes of scratch and
 *          some 50 of traffic per hit, 6 launches and 12 bytes per ray. Sorting n hits of a ray takes
 *          n^2 steps up to 32, then n log n. */
RSH_API rsh_status rsh_traverse(rsh_context context, cl_command_queue queue,
                                const rsh_traverse_desc* desc, cl_uint wait_count,
                                const cl_event* wait_list, cl_event* done);

/* ---- scenes larger than memory ---- */

/* What the triangles of a batch have beside the positions of their vertices. */
#define RSH_BATCH_INDICES 1u      /* else triangle i has the vertices 3i, 3i + 1, 3i + 2     */
#define RSH_BATCH_NORMALS 2u
#define RSH_BATCH_TEXCOORDS 4u
#define RSH_BATCH_MATERIAL_IDS 8u /* else all are of material 0                              */

/* Part of a scene, which rsh_batch_fill writes into memory of the library's. Arrays of attributes that
 * the source does not have are NULL; their layout is that of rsh_geometry and rsh_scene, packed. */
typedef struct rsh_batch {
    size_t struct_size;
    cl_uint first_triangle;    /* in: number in the scene of the first triangle that is wanted    */
    cl_uint triangle_capacity; /* in: triangles and vertices that there is room for          */
    cl_uint vertex_capacity;
    cl_uint triangle_count;    /* out: at least 1, at most up to the end of the scene             */
    cl_uint vertex_count;      /* out                                                        */
    float* positions;          /* 3 per vertex [world]                                       */
    cl_uint* indices;          /* 3 per triangle, of vertices of this batch; one out of range: the
                                  triangle is never hit                                      */
    float* normals;            /* 3 per vertex                                               */
    float* texcoords;          /* 2 per vertex                                               */
    cl_uint* material_ids;     /* 1 per triangle                                             */
} rsh_batch;

/* Writes triangles from batch->first_triangle on, as many as it likes; wrong counts end the call with
 * RSH_INVALID_VALUE, nonzero with RSH_CANCELLED. On the calling thread, while the device works; must not
 * call rsh on that context. Memory is valid until it returns; it is write-only, and holds anything. */
typedef int (*rsh_batch_fill)(rsh_batch* batch, void* user);

/* The triangles of a scene that is larger than the device's memory, or than the host's. A call goes
 * through them once per wave of rays and shadow light, in each strip of a frame and part of a wave: fewer times
 * with more budget. Triangle i must be the same each time; which come together changes time, never hits. Best
 * are batches of what lies close together. */
typedef struct rsh_batch_source {
    size_t struct_size;
    rsh_batch_fill fill;
    void* user;               /* handed to `fill`                                            */
    cl_uint triangle_count;   /* of the scene, below 2^32 - 2^28                             */
    cl_uint attributes;       /* RSH_BATCH_... bits                                          */
    cl_uint batch_triangles;  /* of a batch at most; 0: 2^18. Fewer where memory does not suffice;
                                 three vertices for each                                     */
} rsh_batch_source;

/* ---- the same in one call ---- */

/* Floats of rays, three or one for each, anywhere in a buffer: arrays of their own, or parts of larger
 * records. Never changes size. */
typedef struct rsh_ray_floats {
    cl_mem buffer;
    cl_ulong offset;  /* bytes before those of ray 0, a multiple of 4                       */
    cl_uint stride;   /* bytes from a ray to the next one, a multiple of 4; 0: 12 for three
                         floats, 4 for one, tightly packed                                  */
    cl_uint reserved; /* 0 */
} rsh_ray_floats;

typedef struct rsh_trace_desc {
    size_t struct_size;
    rsh_geometry geometry;
    cl_mem bounds;             /* in: from rsh_bound, of the shape that the engine takes; NULL: made
                                  in scratch, which the query counts, so that there it must be NULL,
                                  or not, as in the call                                     */
    cl_uint width;             /* a grid or a list of rays, as in rsh_build_desc             */
    cl_uint height;
    cl_mem rays;               /* in: width * height x rsh_ray; NULL: made in scratch from the
                                  arrays below. The query counts that, so that there it must be
                                  NULL, or not, as in the call                               */
    rsh_ray_floats origins;    /* in: x, y, z of each ray. Buffers NULL with `rays`          */
    rsh_ray_floats directions; /* in: likewise                                               */
    rsh_ray_floats tmin;       /* in: a float per ray; buffer NULL: 0 for all                */
    rsh_ray_floats tmax;       /* in: likewise; buffer NULL: infinity                        */
    cl_uint converging;        /* as in rsh_build_desc                                       */
    cl_uint query;             /* RSH_QUERY_...                                              */
    cl_mem hits;               /* as in rsh_traverse_desc                                    */
    cl_mem occlusion;          /* likewise                                                   */
    cl_uint occlusion_bit;     /* likewise                                                   */
    cl_uint engine;            /* likewise                                                   */
    cl_mem hit_counts;         /* likewise                                                   */
    cl_mem hit_offsets;        /* likewise                                                   */
    cl_ulong hit_capacity;     /* likewise                                                   */
    cl_mem normals;            /* closest, all: out: 3 floats per hit, packed: unit normal of the
                                  triangle, (v1 - v0) x (v2 - v0), whichever side the ray comes
                                  from; of a miss 0. NULL: nobody wants them                 */
    cl_mem geometry_ids;       /* closest, all: out: cl_uint per hit: id of the triangle's
                                  rsh_mesh_range; of a miss RSH_NO_HIT. NULL: likewise       */
    cl_uint strategy;          /* as in rsh_traverse_desc                                    */
    size_t budget;             /* likewise                                                   */
    cl_mem scratch;
    rsh_progress progress;     /* likewise                                                   */
    void* progress_user;
    cl_mem skip;               /* likewise                                                   */
    cl_mem list_count;         /* as in rsh_build_desc                                       */
    cl_mem ray_masks;          /* as in rsh_traverse_desc                                    */
    cl_uint cull;              /* likewise                                                   */
    cl_mem points;             /* closest, all: out: 3 floats per hit, packed: where on the triangle
                                  it is, (1 - u - v) v0 + u v1 + v v2, the point of rsh_surface, bit
                                  for bit; of a miss NaN. NULL: nobody wants them            */
    cl_uint continued;         /* as in rsh_traverse_desc                                    */
    cl_uint first_triangle;    /* likewise                                                   */
    cl_mem skip_corners;       /* likewise                                                   */
    cl_mem skip_numbers;       /* likewise                                                   */
    cl_uint skip_count;        /* likewise                                                   */
    const rsh_batch_source* batches; /* closest, any: the triangles, batch by batch. Then counts and buffers
                                  of `geometry`, and all of `bounds`, `continued`, `first_triangle`,
                                  `normals`, `points` and `geometry_ids` are 0. NULL: `geometry` */
    size_t batch_budget;       /* bytes of scratch for a batch and its traversal; 0: so that all of the call
                                  keeps to a quarter of the device's memory and its largest allocation */
} rsh_trace_desc;

RSH_API rsh_status rsh_trace_query(rsh_context context, const rsh_trace_desc* desc,
                                   rsh_sizes* sizes);

/* Finds what rays hit, from triangles and rays: rsh_bound (RSH_BOUND_FAST), rsh_build and rsh_traverse, which
 * the caller could enqueue as well, in the shape that the engine takes.
 *
 * Effect:  the answers of rsh_traverse, bit for bit. Normals err by some ulp, slivers' too; where floats
 *          cannot tell one it is 0.
 *          list_count: normals, points and ids behind it stay as they are. So do all, where hits do not fit.
 *          batches: hits name triangles of the scene, which may be larger than any memory. The progress
 *          callback is called before each batch, with count 0. Where it, or the source, asks to stop, the
 *          answers are those of the batches before, once *done has ended. BLOCKS for the wait list, and
 *          while both pieces of the host's memory are still to be copied.
 * Cost:    what the three calls cost, and what is asked for, each a program of its own that is compiled when
 *          it is first asked for: rays out of arrays a launch and 32 bytes of scratch per ray, read
 *          once more and written; normals, points and ids together a launch. batches: the scene once
 *          through the source, to the device and bounded; per batch a dozen launches and a look at the
 *          nodes over the rays; twice the memory of a batch on the host.
 *          output_bytes of the query: as of rsh_traverse_query. */
RSH_API rsh_status rsh_trace(rsh_context context, cl_command_queue queue,
                             const rsh_trace_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done);

/* ---- is it right? ---- */

typedef struct rsh_audit_desc {
    size_t struct_size;
    rsh_geometry geometry;
    cl_uint ray_count;     /* at most 2^28 */
    cl_mem rays;           /* in: ray_count x rsh_ray                                         */
    cl_uint query;         /* RSH_QUERY_...: what was asked of the traversal                  */
    cl_uint occlusion_bit; /* any: as in rsh_traverse_desc                                    */
    cl_mem hits;           /* closest, all: in: what the traversal answered                   */
    cl_mem occlusion;      /* any: in: likewise; the bit was 0 before                         */
    cl_uint sample;        /* rays to trace again; 0, and more than there are: all            */
    cl_uint seed;          /* which ones: the same seed, the same rays                        */
    cl_mem report;         /* out: one rsh_audit_report                                       */
    cl_mem skip;           /* in: as in the traversal                                         */
    cl_mem list_count;     /* in: as in the traversal: how many of ray_count rays there are   */
    cl_mem hit_counts;     /* count: in: what the traversal answered                          */
    cl_mem hit_offsets;    /* all: in: likewise, with `hits`                                  */
    cl_ulong hit_capacity; /* all: as in the traversal; where the hits did not fit, their number alone
                              is looked at                                                    */
    cl_mem ray_masks;      /* in: as in the traversal                                         */
    cl_uint cull;          /* likewise                                                        */
} rsh_audit_desc;

/* Traces rays again by brute force and counts those whose answers differ in any bit, by kind. Of all
 * hits, the order and a sum of 64-bit digests are compared.
 *
 * Effect:  the rays are cut into `sample` ranges of equal length; of each, the first active ray
 *          is taken from a random place on, round the range's end. Inactive rays, and ranges
 *          without an active one, are left out and not counted.
 * Cost:    O(triangles * sample), and at most a look at every ray; one launch, no scratch. */
RSH_API rsh_status rsh_audit(rsh_context context, cl_command_queue queue,
                             const rsh_audit_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done);

/* ---- secondary rays ---- */

enum {
    RSH_SPAWN_REFLECTION = 0,
    RSH_SPAWN_REFRACTION = 1,
    RSH_SPAWN_SHADOW = 2
};

typedef struct rsh_spawn_desc {
    size_t struct_size;
    const rsh_scene* scene;
    cl_uint kind;            /* RSH_SPAWN_... */
    cl_uint light;           /* shadow: index of the light */
    cl_uint ray_count;       /* at most 2^28 */
    cl_mem rays;             /* in: the rays that hit                                         */
    cl_mem hits;             /* in: their closest hits                                        */
    cl_mem weights;          /* in: float4 per ray, rgb; NULL: all 1; unused for shadow       */
    float min_weight;        /* rays whose largest weight is not above it are not spawned     */
    cl_mem spawned_rays;     /* out: one per ray; inactive where nothing is spawned           */
    cl_mem spawned_weights;  /* out: float4 per ray; unused for shadow                        */
    cl_mem active_count;     /* in/out: one cl_uint, grows by the rays spawned; may be NULL   */
    cl_mem spawned_skip;     /* out: cl_uint per ray, the triangle that it leaves, for
                                rsh_traverse_desc::skip; RSH_NO_HIT where nothing is spawned.
                                NULL: origins keep that triangle off by their distance        */
    cl_mem list_count;       /* in: as in rsh_build_desc: how many of ray_count rays there are;
                                of the others nothing is read or written. NULL: all           */
} rsh_spawn_desc;

/* Makes one secondary ray per hit, tmin 0.
 *
 * Origin  the point where the ray meets the triangle's plane, found in twice the precision of a
 *         float and rounded once, to a float on the side that the new ray leaves to, and as
 *         little beside that ray as such floats allow: it may be one or two ulp of its
 *         coordinates off the surface, however large the triangle is and however far the ray
 *         came (kernels/surface/departure.h). The triangle itself is kept off by its
 *         number: pass spawned_skip to rsh_traverse and rsh_audit. Without spawned_skip the
 *         origin moves off by 2^-18 of the triangle's extent as well, so that shadows and
 *         reflections of what is nearer to a large triangle than that are lost.
 *         Limits: the corners of a triangle are floats, so a surface is where their rounding
 *         puts it: what stands on a turned ground of two triangles is an ulp of its corners too
 *         deep or too high (0.06 at 1e6), and so much of its shadow and image is lost or added;
 *         at an edge, origins within some ulp of it may be beyond the neighbour; of two
 *         surfaces nearer to each other than some ulp of their coordinates either may win;
 *         triangles less than 2^-15 as high as long get their origins within 2^-20 of their
 *         extent.
 *
 * Reflection, refraction  unit direction, tmax infinite; its weight is the ray's weight times
 *         that of rsh_material, w: 0. A direction that an interpolated normal would send to the
 *         wrong side of the triangle is mirrored in the triangle's plane. None is made when the
 *         weight is not finite, or its largest component is not above 0 and min_weight.
 * Shadow  runs from the surface to the light: for a point or spot light t = 1 is the light and
 *         tmax 1 - 2^-16, so that the light itself is outside; for a directional one the
 *         direction is unit and tmax infinite. None is made for a light with casts_shadow = 0,
 *         nor where the light adds nothing: the surface faces away, is outside of its cone,
 *         gets no colour, or has neither diffuse nor specular colour.
 * Nothing is made at rays that are inactive or hit nothing. Where no ray is made, the ray is
 * all 0 but for tmax = -1, and its weight is 0. One launch. */
RSH_API rsh_status rsh_spawn(rsh_context context, cl_command_queue queue,
                             const rsh_spawn_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done);

/* ---- waves of secondary rays ---- */

typedef struct rsh_spawn_wave_desc {
    size_t struct_size;
    const rsh_scene* scene;
    cl_uint width;           /* a grid or a list of rays, as in rsh_build_desc                */
    cl_uint height;
    cl_mem rays;             /* in: a wave: width * height x rsh_ray                          */
    cl_mem hits;             /* in: their closest hits                                        */
    cl_mem weights;          /* in: float4 per ray, rgb; NULL: all 1                          */
    float min_weight;        /* as in rsh_spawn_desc                                          */
    cl_uint capacity;        /* rays that the next wave has room for, at most 2^28            */
    cl_mem branches;         /* out: two cl_uint per ray of the wave: which rays of the next one
                                are its reflected and its refracted ray; RSH_NO_RAY: none     */
    cl_mem spawned_rays;     /* out: the next wave: capacity x rsh_ray                        */
    cl_mem spawned_weights;  /* out: float4 per ray of it                                     */
    cl_mem spawned_skip;     /* out: cl_uint per ray of it, as in rsh_spawn_desc              */
    cl_mem spawned_count;    /* out: two cl_uint: how many rays it holds, for list_count of the
                                calls that take it; and how many it would hold with any capacity */
    cl_mem list_count;       /* in: as in rsh_build_desc                                      */
    cl_mem spawned_parents;  /* out: cl_uint per ray of the next wave: the ray of this one that it
                                comes from; may be NULL                                       */
    cl_mem pixels;           /* in: cl_uint per ray of this wave, any number that its secondary
                                rays inherit; NULL: the ray's own                             */
    cl_mem spawned_pixels;   /* out: those of the next one; may be NULL                       */
    cl_mem scratch;
} rsh_spawn_wave_desc;

RSH_API rsh_status rsh_spawn_wave_query(rsh_context context, const rsh_spawn_wave_desc* desc,
                                        rsh_sizes* sizes);

/* Makes all secondary rays of a wave: those of rsh_spawn, bit for bit, packed.
 *
 * Order:   all reflected rays, then all refracted ones; of each kind, in a list those of earlier rays
 *          first, in a grid square by square of 64 x 64, row by row, and in each along Hilbert's
 *          curve: rays that follow each other come from neighbours. It never differs.
 * Effect:  if there are more rays than `capacity`, none is made: spawned_count is 0 and how many there
 *          are, the other outputs are undefined. Nothing is ever written behind spawned_count.
 *          Kinds that scene->features lacks are not made.
 * Cost:    three launches, and one for parents and pixels; hits that send rays on are found twice.
 *          output_bytes of the query: branches, 8 per ray; scratch_bytes: 8 per 16 rays at most. */
RSH_API rsh_status rsh_spawn_wave(rsh_context context, cl_command_queue queue,
                                  const rsh_spawn_wave_desc* desc, cl_uint wait_count,
                                  const cl_event* wait_list, cl_event* done);

typedef struct rsh_gather_wave_desc {
    size_t struct_size;
    const rsh_scene* scene;  /* as in rsh_spawn_wave_desc */
    cl_uint width;           /* likewise, of the wave before */
    cl_uint height;
    cl_uint capacity;        /* likewise                                                      */
    cl_mem branches;         /* in: as rsh_spawn_wave left them                               */
    cl_mem spawned_count;    /* in: likewise                                                  */
    cl_mem spawned_colour;   /* in: float4 per ray of the next wave                           */
    cl_mem colour;           /* in/out: float4 per ray of the wave before; a is left alone    */
    cl_mem list_count;       /* in: as in rsh_spawn_wave_desc */
} rsh_gather_wave_desc;

/* Adds to the colour of each ray what those see that it sent on: its reflected, then its refracted
 * ray. Without atomics, and in this order: the sums never differ. Adds nothing after an
 * rsh_spawn_wave that found no room. One launch. */
RSH_API rsh_status rsh_gather_wave(rsh_context context, cl_command_queue queue,
                                   const rsh_gather_wave_desc* desc, cl_uint wait_count,
                                   const cl_event* wait_list, cl_event* done);

/* ---- shadows ---- */

typedef struct rsh_shadow_desc {
    size_t struct_size;
    const rsh_scene* scene;
    cl_uint width;        /* a grid or a list of rays, as in rsh_build_desc                   */
    cl_uint height;
    cl_mem rays;          /* in: width * height x rsh_ray                                     */
    cl_mem hits;          /* in: their closest hits                                           */
    cl_mem bounds;        /* in: from rsh_bound; NULL: made in scratch, once for all lights,
                             which the query counts, so that there it must be NULL, or not, as
                             in the call                                                      */
    cl_mem occlusion;     /* out: width * height x cl_uint, a mask per ray for rsh_shade: bit k:
                             light k is hidden                                                */
    cl_uint engine;       /* as in rsh_traverse_desc                                          */
    cl_uint shape;        /* RSH_SHAPE_DEFAULT: what the engine takes                         */
    cl_uint strategy;     /* as in rsh_traverse_desc */
    size_t budget;        /* likewise */
    cl_mem scratch;
    cl_mem list_count;    /* in: as in rsh_build_desc */
    cl_mem active_count;  /* in/out: one cl_uint, grows by the shadow rays of all lights, and wraps
                             above 2^32 of them; may be NULL                                  */
} rsh_shadow_desc;

RSH_API rsh_status rsh_shadow_query(rsh_context context, const rsh_shadow_desc* desc,
                                    rsh_sizes* sizes);

/* Finds which lights are hidden where rays hit: for each light of scene->shadow_lights rsh_spawn,
 * rsh_build and rsh_traverse, which the caller could enqueue as well.
 *
 * Effect:  all masks are overwritten. A bit is 0 where the light reaches the hit, adds nothing to
 *          it, casts no shadow or is not in shadow_lights, and where nothing is hit; all are 0
 *          without RSH_FEATURE_SHADOW. list_count: masks behind it are 0.
 * Cost:    a launch to clear, and per light what the three calls cost; 36 bytes of scratch per ray,
 *          and the nodes. output_bytes of the query: 4 per ray. */
RSH_API rsh_status rsh_shadow(rsh_context context, cl_command_queue queue,
                              const rsh_shadow_desc* desc, cl_uint wait_count,
                              const cl_event* wait_list, cl_event* done);

/* ---- surfaces ---- */

typedef struct rsh_find_surfaces_desc {
    size_t struct_size;
    const rsh_scene* scene;
    cl_uint ray_count; /* at most 2^28 */
    cl_mem rays;       /* in */
    cl_mem hits;       /* in: closest hits of the rays                                        */
    cl_mem surfaces;   /* out: one rsh_surface per ray                                        */
    cl_mem list_count; /* in: one cl_uint: how many rays there are, of ray_count at most, as in
                          rsh_build_desc; surfaces behind them stay as they are. NULL: ray_count */
} rsh_find_surfaces_desc;

/* Finds what the rays hit, for a shading kernel of the caller's: point, normals, material and
 * texture as rsh_shade and rsh_spawn see them, bit for bit.
 *
 * Effect:  one record per ray, see rsh_surface. Features that are left out count as absent: without
 *          RSH_FEATURE_SMOOTH_NORMAL normals are those of the triangles, without
 *          RSH_FEATURE_TEXTURE texture colours are 1.
 * Cost:    one launch; 48 bytes read and 80 written per ray, beside its triangle. rsh's own calls
 *          take no such records: to find a surface again is quicker than to write and read one. */
RSH_API rsh_status rsh_find_surfaces(rsh_context context, cl_command_queue queue,
                                     const rsh_find_surfaces_desc* desc, cl_uint wait_count,
                                     const cl_event* wait_list, cl_event* done);

/* ---- shading ---- */

typedef struct rsh_shade_desc {
    size_t struct_size;
    const rsh_scene* scene;
    cl_uint ray_count; /* at most 2^28 */
    cl_mem rays;      /* in */
    cl_mem hits;      /* in: closest hits of the rays                                         */
    cl_mem weights;   /* in: float4 per ray; NULL: all 1                                      */
    cl_mem occlusion; /* in: mask per ray, bit k: light k is hidden; NULL: no shadows         */
    cl_mem colour;    /* in/out: float4 per ray, linear rgb; a is left alone                  */
    cl_mem list_count; /* in: as in rsh_spawn_desc */
} rsh_shade_desc;

/* Adds weight * (emission + ambient + light that arrives directly) of each active ray's hit,
 * see rsh_material, or weight * environment where it hits nothing, to its colour; adds nothing
 * for inactive rays. What mirrored and refracted rays see is added by shading those. The light of
 * lamps that cast no shadow (rsh_scene, shadow_lights) is summed up with emission and ambient, that
 * of each other one is added behind. One launch. */
RSH_API rsh_status rsh_shade(rsh_context context, cl_command_queue queue,
                             const rsh_shade_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done);

/* ---- the whole frame ---- */

typedef struct rsh_frame_desc {
    size_t struct_size;
    const rsh_scene* scene;
    rsh_camera camera;
    cl_uint width;        /* pixels, 1 .. 16384 */
    cl_uint height;
    cl_uint bounces;      /* longest chain of secondary rays, at most RSH_MAX_LEVELS       */
    float min_weight;     /* secondary rays that weigh no more are left out; 0: only those
                             that cannot matter                                               */
    cl_uint engine;       /* as in rsh_traverse_desc */
    cl_uint shape;        /* RSH_SHAPE_DEFAULT: what the engine takes */
    cl_uint strategy;
    size_t budget;        /* bytes of scratch that it may take; 0: a quarter of the device's
                             memory, or its largest allocation. Too few for 64 rows are an error
                             that names the least                                            */
    cl_mem colour;        /* out: width * height x float4, linear rgb; a = 1 where it sees
                             a triangle, else 0                                               */
    cl_mem scratch;
    rsh_progress progress; /* called before each wave of rays with its number; count 0      */
    void* progress_user;
    cl_mem bounds;        /* in/out: as in rsh_bound_desc, of the scene; NULL: made in scratch,
                             which the query counts, so that there it must be NULL, or not, as
                             in the call. Frames without shadows and bounces leave it alone   */
    cl_uint mode;         /* as in rsh_bound_desc; 0 without `bounds`                         */
    cl_uint audit_rays;   /* `sample` of rsh_audit, for each wave; 0: none is audited         */
    cl_mem audit;         /* out, with audit_rays: one rsh_audit_report, the sum over all waves
                             of rays: those of the camera, secondary and shadow rays          */
    cl_uint audit_seed;   /* `seed` of rsh_audit: another one per frame audits other rays     */
    rsh_window window;
    float tolerance;      /* 0: an exact frame. Above: an approximate one, see below; 0.01 is a
                             difference that is hardly seen. Not NaN, not infinite           */
    const rsh_batch_source* batches; /* the triangles, batch by batch; then the counts of
                             scene->geometry and audit_rays are 0, and its buffers, scene->normals,
                             texcoords and material_ids, and `bounds` NULL. NULL: the scene has all */
} rsh_frame_desc;

RSH_API rsh_status rsh_frame_query(rsh_context context, const rsh_frame_desc* desc,
                                   rsh_sizes* sizes);

/* Renders a frame: rasterize and bound, then per wave of rays: build, traverse, cast shadows,
 * shade, spawn.
 *
 * The rays of a bounce are one wave: all reflections of the wave before, then all its refractions,
 * packed, those of neighbouring pixels close together. A wave costs its rays, not the screen's: with B
 * bounces and S lights that cast shadows a frame traverses S + B (1 + S) times at most. A pixel is
 * the sum of what its ray sees itself, then of what its reflection sees, then its refraction.
 * Memory: the picture is worked off in strips of whole rows, as many as fit into the budget: 48
 * bytes per pixel for the camera's rays, 52 for shadows, 88 per bounce, and the hierarchies. A wave
 * has room for a strip's number of rays. One that would hold more is taken in parts, one after the
 * other with all that comes of it. The picture's bits do not depend on any of that.
 * Approximate: with a tolerance, pixels whose column and row are multiples of 4 are traced as ever.
 * Then each pixel half-way between four of them - in a row, in a column, in the middle - gets the
 * mean of the nearest two or four if all five see the same material or nothing, the square roots of
 * the four's colours differ by `tolerance` at most in each of r, g and b, and 1 / t of its ray by
 * `tolerance` times itself from the mean of theirs; else it is traced. Then the same with multiples
 * of 2. Pixels without four such neighbours are traced, and each 64 rows of the window stand alone.
 * What is traced has the bits of the exact frame; but details smaller than 4 pixels can be lost
 * between pixels that look alike. Takes 72 bytes more per pixel. Pays for large pictures, whose
 * pixels are more alike, and only if rays come after the camera's: without shadows and bounces,
 * tolerance means nothing.
 * Batches: a scene that comes in batches has the bits of one that does not. Each wave of rays, the camera's
 * too, which are traced then, and the shadow rays of each light go through all batches; a scene that fits
 * into one is asked for once. Of each wave the triangles that are hit are kept, up to 104 bytes per
 * pixel. The budget is that of rays and batch together. rsh_find_features looks at buffers that are not
 * there then: RSH_FEATURE_SMOOTH_NORMAL and _TEXTURE are the caller's to add. The progress callback is
 * called before each batch of each wave, with how many there were. Where it, or the source, asks to
 * stop, the strips that were finished are valid. BLOCKS while the host's memory is still to be copied.
 * BLOCKS once per strip where there can be waves after the first one, and per part of a wave, to
 * read how many rays they held: all have been enqueued by then, also those that turn out to be
 * empty. An approximate frame does so for each of three sets of pixels, and BLOCKS twice more to
 * read how many are to be traced. Before it enqueues such waves, it flushes `queue` and BLOCKS for
 * the wait list, and enqueues nothing when an event of it fails. */
RSH_API rsh_status rsh_frame(rsh_context context, cl_command_queue queue,
                             const rsh_frame_desc* desc, cl_uint wait_count,
                             const cl_event* wait_list, cl_event* done);

/* ---- stream reduction ---- */

enum {
    RSH_KEEP_FLAGS = 0,    /* keep element i if byte i of `flags` is not 0                    */
    RSH_KEEP_NOT_NULL = 1, /* keep element i if its first 4 bytes are not RSH_NO_HIT          */
    RSH_KEEP_BITS = 2      /* keep element i if bit i % 8 of byte i / 8 of `flags` is set     */
};

typedef struct rsh_reduce_desc {
    size_t struct_size;
    cl_uint strategy;        /* RSH_STRATEGY_... */
    cl_uint keep;            /* RSH_KEEP_... */
    cl_uint element_bytes;   /* 4, 8, 12 or 16 */
    cl_uint count;           /* elements of input, at most 2^31; with input_count: at most so
                                many                                                          */
    cl_mem input_count;      /* in: one cl_uint on the device, up to `count`; NULL: `count`   */
    cl_mem input;            /* in */
    cl_mem flags;            /* in: RSH_KEEP_FLAGS: a byte per element, RSH_KEEP_BITS: a bit  */
    cl_mem output;           /* out: room for every element kept, at least one             */
    cl_mem output_count;     /* out: one cl_uint, the number kept                             */
    cl_mem scratch;
} rsh_reduce_desc;

RSH_API rsh_status rsh_reduce_query(rsh_context context, const rsh_reduce_desc* desc,
                                    rsh_sizes* sizes);

/* Packs the kept elements of a stream at the front of `output`; nothing is written behind them.
 *
 * Order:   stable strategies keep the order of the input; atomic and atomic_group do not, and
 *          two calls may differ in it. rsh_strategy_is_stable tells which is which.
 * Auto:    looks at the device and at `count`, which the host knows: where a work-item is a
 *          task of a CPU, up to 65536 elements go to chunk, which is then a single launch, more
 *          to lookback; elsewhere scan_scatter. How much is kept it learns on the device, tile
 *          by tile, and reads nothing back: tiles that keep nothing are not read again. It
 *          never picks a strategy that rsh_device_selftest masked.
 * Limits:  input and output must not overlap. No strategy assumes that work-groups wait for
 *          each other: lookback counts a tile itself that says nothing for long.
 * Cost:    in launches and in bytes moved, for n elements of e bytes with f bytes of flags, k
 *          of them kept: chunk 2 launches (1 if short), 2 n f + n e + k e (not NULL: 2 n e + k
 *          e); block 3, and 2 k e more; scan_scatter 3; count_emit 2; lookback and atomic_group
 *          2, n f + n e + k e; atomic 2; horn 2 + log2 n; blelloch 3 + 2 log2 n. */
RSH_API rsh_status rsh_reduce(rsh_context context, cl_command_queue queue,
                              const rsh_reduce_desc* desc, cl_uint wait_count,
                              const cl_event* wait_list, cl_event* done);

/* Whether the strategy keeps the order of the input; CL_FALSE also for values that are none. */
RSH_API cl_bool rsh_strategy_is_stable(cl_uint strategy);

/* What the proofs in kernels/ assume of a device's floats. What is lost where one does not hold: */
enum {
    RSH_ARITHMETIC_ROUNDING = 0,    /* + - * are rounded to nearest, ties to even, in the order
                                       written; else no error bound holds: hits may be missed    */
    RSH_ARITHMETIC_CONTRACTION = 1, /* a * b + c is rounded twice where FP_CONTRACT is OFF; else
                                       engines, strategies and devices may differ in hits        */
    RSH_ARITHMETIC_FMA = 2,         /* fma is rounded once; else rays may slip through edges that
                                       triangles share, and spawned rays err more                */
    RSH_ARITHMETIC_DIVISION = 3,    /* a / b is rounded correctly where the device says so
                                       (CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT), else within 2.5 ulp;
                                       else hits may be missed                                   */
    RSH_ARITHMETIC_SQUARE_ROOT = 4, /* sqrt likewise, else within 3 ulp; else the cones of
                                       RSH_SHAPE_CONE may miss hits, and unit vectors are none   */
    RSH_ARITHMETIC_COMPARISON = 5,  /* < <= > >= == are false of NaN, != is true, fmin and fmax
                                       take the other number, isnan, isinf and isfinite tell; else
                                       invalid rays and triangles may be hit, or hide others     */
    RSH_ARITHMETIC_INFINITY = 6,    /* overflow and division by 0 give infinity, what has no
                                       value NaN; else rays along an axis, and huge or invalid
                                       coordinates, may be hit or missed wrongly                 */
    RSH_ARITHMETIC_UNDERFLOW = 7,   /* below 2^-126 results are the nearest denormals, or 0; and
                                       denormal operands are themselves, or 0; else hits on what
                                       is that small may be missed                               */
    RSH_ARITHMETIC_CONVERSION = 8   /* int to float is rounded to nearest, float to int towards 0,
                                       floor down; else rsh_rasterize may miss hits              */
};

/* Name of such a property ("fma"); NULL when there is none. */
RSH_API const char* rsh_arithmetic_name(cl_uint property);

typedef struct rsh_selftest {
    size_t struct_size;
    cl_uint tested_strategies; /* bit s: the strategy of value s was run                      */
    cl_uint unsafe_strategies; /* bit s: it gave a wrong answer, or did not run; its name:
                                  rsh_strategy_name(s)                                        */
    cl_uint cases;             /* reductions that were compared                               */
    char first_failure[256];   /* strategy, stream, what it gave and what it had to; or ""    */
    cl_uint tested_arithmetic; /* bit p: RSH_ARITHMETIC_... of value p was probed             */
    cl_uint wrong_arithmetic;  /* bit p: it does not hold, or the probes did not run; its name:
                                  rsh_arithmetic_name(p)                                      */
    cl_uint arithmetic_cases;  /* results that were compared                                  */
    cl_bool flushes_denormals; /* floats below 2^-126 are taken for 0, as they may: hits on what
                                  is that small may differ from those of other devices        */
    char arithmetic_failure[256]; /* property, operation, operands, what it gave and what it had
                                     to, of the first that does not hold; or ""               */
} rsh_selftest;

/* Runs every strategy on streams of the kinds that drivers are known to get wrong (work-groups
 * that are not full, scans over several blocks, counts that only the device knows) and compares
 * with the host. The unsafe ones are masked on this context, until the next self-test: calls
 * that name them, and their queries, return RSH_UNSUPPORTED.
 * Then it probes the arithmetic that exactness rests on, one number at a time and in the
 * context's vectors, by numbers at random and those that are hard. What does not hold is only
 * reported: every call works as before, without the promise named above.
 * BLOCKS, for less than a second once the programs are built. Finding a strategy unsafe, or
 * arithmetic wrong, is not an error. Call it before the queries that its outcome may change. */
RSH_API rsh_status rsh_device_selftest(rsh_context context, cl_command_queue queue,
                                       rsh_selftest* report);

/* ---- programs before they are needed ---- */

/* The calls that will be made; of each kind that will not be, NULL. */
typedef struct rsh_prepare_desc {
    size_t struct_size;
    const rsh_rasterize_desc* rasterize;
    const rsh_bound_desc* bound;
    const rsh_build_desc* build;
    const rsh_traverse_desc* traverse;
    const rsh_trace_desc* trace;
    const rsh_audit_desc* audit;
    const rsh_spawn_desc* spawn;
    const rsh_spawn_wave_desc* spawn_wave;
    const rsh_gather_wave_desc* gather_wave;
    const rsh_shadow_desc* shadow;
    const rsh_find_surfaces_desc* find_surfaces;
    const rsh_shade_desc* shade;
    const rsh_frame_desc* frame;
    const rsh_reduce_desc* reduce;
    cl_bool background;    /* CL_TRUE: on a thread of the context's                          */
    rsh_progress progress; /* before each program, with how many are done and how many there
                              are, and after the last one; on the thread that compiles; must
                              not call rsh on that context. Nonzero leaves out the rest:
                              RSH_CANCELLED. NULL: none                                      */
    void* progress_user;   /* in the background it must live until rsh_wait_prepared         */
    cl_bool general;       /* CL_TRUE: general programs too, and first; see rsh_prepare      */
} rsh_prepare_desc;

/* Compiles the programs that these calls will need, or loads them from disk, so that the calls do
 * not: with the same descriptors they build none.
 *
 * Reads:   what a call's query reads, and which optional buffers are NULL; a buffer that is not
 *          made yet stands for itself by any value that is not NULL. Everything is read before
 *          this returns. The descriptors' own `progress` is not called. A strategy that is left to
 *          the library, and what the self-test masked, are as of now.
 * Threads: in the background, programs are compiled one after the other on one thread of the
 *          context's, in the order of the calls of rsh_prepare. Every other call works meanwhile; one
 *          that needs a program that is being compiled waits for it, one whose program is still to come
 *          compiles it itself. rsh_release_context waits for the program that is being compiled and
 *          leaves out the rest; it, or rsh_wait_prepared with no call after it, must have returned
 *          before the process ends.
 * General: with `general`, programs without variants and general ones come first, then the variants.
 *          From then on, with this context, no call waits for a variant: calls take the general
 *          program until the variant that they need is there, and have it compiled in the
 *          background, whether or not it was named here. One that fails there is told to the log
 *          alone, and is left to the general program unless rsh_prepare names it again.
 * Errors:  as the calls' queries, of a struct_size by the member's name. A program that fails to
 *          compile does not keep the others from it; the first failure is returned, in the background
 *          by rsh_wait_prepared, and the call that needs the program meets it again, or takes the
 *          general one. RSH_OUT_OF_MEMORY also where no thread can be started.
 * Cost:    BLOCKS until all are compiled, in the background for less than a millisecond. Some drivers
 *          (PoCL) finish a kernel for a size of work-groups only when it is first launched; that is
 *          left to the call. There the first call that takes a variant is slow all the same, also
 *          with `general`; with RSH_NO_VARIANTS a change of features compiles nothing. */
RSH_API rsh_status rsh_prepare(rsh_context context, const rsh_prepare_desc* desc);

/* BLOCKS until the context's thread has compiled what was left to it; returns its first failure since the
 * last time, or success, also when there was nothing to do. */
RSH_API rsh_status rsh_wait_prepared(rsh_context context);

/* The RSH_SHAPE_... that an engine takes, which rsh_bound and rsh_build must be told as well;
 * RSH_SHAPE_DEFAULT for RSH_ENGINE_DEFAULT, for one that takes none, and for what is none. */
RSH_API cl_uint rsh_engine_shape(cl_uint engine);

/* Name of a strategy ("chunk"), engine ("tiles"; RSH_ENGINE_DEFAULT: "auto") or shape ("box"),
 * and its value for a name; NULL and RSH_INVALID_VALUE when there is none. */
RSH_API const char* rsh_strategy_name(cl_uint strategy);
RSH_API const char* rsh_engine_name(cl_uint engine);
RSH_API const char* rsh_shape_name(cl_uint shape);
RSH_API rsh_status rsh_strategy_from_name(const char* name, cl_uint* strategy);
RSH_API rsh_status rsh_engine_from_name(const char* name, cl_uint* engine);
RSH_API rsh_status rsh_shape_from_name(const char* name, cl_uint* shape);

/* The engine that RSH_ENGINE_DEFAULT stands for on the context's device: tiles where work-items
 * may hold kilobytes of private memory, as on CPUs, else paper_faithful. rsh_engine_shape of it is
 * what RSH_SHAPE_DEFAULT stands for. */
RSH_API rsh_status rsh_default_engine(rsh_context context, cl_uint* engine);

#ifdef __cplusplus
}
#endif

#endif /* RSH_H */
