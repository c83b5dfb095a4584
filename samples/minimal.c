/* minimal.c - one ray, one triangle: the smallest program that uses rsh.
 *
 * Prints where the ray hits, and fails unless that is where it must be. Renders no picture.
 *
 *   cc -std=c99 minimal.c -lrsh -lOpenCL
 */
#include <rsh/rsh.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* rsh never prints and never exits: that is the caller's choice. */
static void require(rsh_status status, const char* call) {
    if (status == RSH_SUCCESS) return;
    fprintf(stderr, "%s: %s: %s\n", call, rsh_status_string(status), rsh_last_error());
    exit(EXIT_FAILURE);
}

static cl_mem make_buffer(cl_context context, size_t bytes, const void* contents) {
    cl_int status = CL_SUCCESS;
    const cl_mem_flags flags =
        CL_MEM_READ_WRITE | (contents ? CL_MEM_COPY_HOST_PTR : (cl_mem_flags)0);
    /* clCreateBuffer copies; it takes a pointer to non-const for the sake of other flags. */
    cl_mem buffer = clCreateBuffer(context, flags, bytes, (void*)contents, &status);
    require(status, "clCreateBuffer");
    return buffer;
}

int main(void) {
    /* A triangle in the plane z = 0 and a ray that looks along -z from above its inside. The
     * ray starts at t = 0 and has no end; its direction need not have length 1. */
    static const cl_float vertices[9] = {0, 0, 0, 4, 0, 0, 0, 4, 0};
    static const rsh_ray ray = {{{1, 2, 5, 0}}, {{0, 0, -1, INFINITY}}};

    /* OpenCL belongs to the caller. rsh_find_device is a convenience: with NULL it takes the
     * device named by RSH_DEVICE, or the first one there is. */
    cl_platform_id platform;
    cl_device_id device;
    require(rsh_find_device(NULL, &platform, &device), "rsh_find_device");
    cl_int status;
    cl_context context = clCreateContext(NULL, 1, &device, NULL, NULL, &status);
    require(status, "clCreateContext");
    cl_command_queue queue = clCreateCommandQueue(context, device, 0, &status);
    require(status, "clCreateCommandQueue");

    /* A context of rsh holds compiled programs and scratch memory for one device. Every struct
     * starts with its size; members that are left 0 take their defaults. */
    rsh_context_desc context_desc = {.struct_size = sizeof context_desc};
    context_desc.context = context;
    context_desc.device = device;
    rsh_context rsh;
    require(rsh_create_context(&context_desc, &rsh), "rsh_create_context");

    /* The hierarchy over the rays. The library says how many bytes it takes, the caller
     * allocates them. */
    rsh_build_desc build = {.struct_size = sizeof build};
    build.rays = make_buffer(context, sizeof ray, &ray);
    build.width = 1;
    rsh_sizes sizes = {.struct_size = sizeof sizes};
    require(rsh_build_query(rsh, &build, &sizes), "rsh_build_query");
    build.nodes = make_buffer(context, sizes.output_bytes, NULL);
    require(rsh_build(rsh, queue, &build, 0, NULL, NULL), "rsh_build");

    /* Without indices, three vertices in a row are a triangle. As `bounds` is NULL, the call
     * makes the scene's bounds itself; rsh_bound makes some that several traversals share. As
     * `scratch` is NULL, memory for it comes from the context's pool. */
    rsh_traverse_desc traverse = {.struct_size = sizeof traverse};
    traverse.geometry.vertices = make_buffer(context, sizeof vertices, vertices);
    traverse.geometry.vertex_count = 3;
    traverse.geometry.triangle_count = 1;
    traverse.rays = build.rays;
    traverse.nodes = build.nodes;
    traverse.width = 1;
    traverse.hits = make_buffer(context, sizeof(rsh_hit), NULL);
    require(rsh_traverse(rsh, queue, &traverse, 0, NULL, NULL), "rsh_traverse");

    /* Both calls only enqueued; the queue is in order, so this read comes after them and blocks
     * until the hit is there. */
    rsh_hit hit;
    require(
        clEnqueueReadBuffer(queue, traverse.hits, CL_TRUE, 0, sizeof hit, &hit, 0, NULL, NULL),
        "clEnqueueReadBuffer");
    printf("triangle %u at t = %g, u = %g, v = %g\n", hit.primitive, hit.t, hit.u, hit.v);

    /* While a renderer is developed, it may turn on an audit: some rays of each frame are traced
     * again by brute force, on the device, and answers that differ are counted. `sample` says how
     * many, `seed` which ones: the number of the frame, for instance. */
    rsh_audit_desc audit = {.struct_size = sizeof audit};
    audit.geometry = traverse.geometry;
    audit.rays = traverse.rays;
    audit.ray_count = 1;
    audit.hits = traverse.hits;
    audit.sample = 1;
    audit.report = make_buffer(context, sizeof(rsh_audit_report), NULL);
    require(rsh_audit(rsh, queue, &audit, 0, NULL, NULL), "rsh_audit");
    rsh_audit_report report;
    require(clEnqueueReadBuffer(queue, audit.report, CL_TRUE, 0, sizeof report, &report, 0,
                                NULL, NULL),
            "clEnqueueReadBuffer");
    printf("%lu of %lu hits differ: %u missed, %u spurious, %u wrong\n",
           (unsigned long)report.differences, (unsigned long)report.rays, report.missed,
           report.spurious, report.wrong);

    rsh_release_context(rsh);
    clReleaseMemObject(audit.report);
    clReleaseMemObject(traverse.hits);
    clReleaseMemObject(traverse.geometry.vertices);
    clReleaseMemObject(build.nodes);
    clReleaseMemObject(build.rays);
    clReleaseCommandQueue(queue);
    clReleaseContext(context);

    /* The ray meets the plane at (1, 2, 0): t = 5, a quarter along the first edge, half along
     * the second. All of these are exact in binary. */
    const int is_right = hit.primitive == 0 && hit.t == 5 && hit.u == 0.25f && hit.v == 0.5f;
    return is_right && report.rays == 1 && report.differences == 0 ? EXIT_SUCCESS
                                                                   : EXIT_FAILURE;
}
