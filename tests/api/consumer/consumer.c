/* consumer.c - finds a device, makes a context and packs a stream, in C99 and nothing but rsh's
 * and OpenCL's installed headers. Ends with 0 when the result is right. */
#include <rsh/rsh.h>
#include <stdio.h>

static int fail(const char* what) {
    fprintf(stderr, "%s: %s\n", what, rsh_last_error());
    return 1;
}

/* Keeps 1, 3 and 5 of 0 .. 5. */
static int pack(rsh_context rsh, cl_context context, cl_command_queue queue) {
    cl_uint input[6] = {0, 1, 2, 3, 4, 5};
    cl_uchar flags[6] = {0, 1, 0, 1, 0, 1};
    cl_uint output[6] = {9, 9, 9, 9, 9, 9};
    cl_uint count = 0;
    const cl_mem_flags copy = CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR;
    rsh_reduce_desc desc = {0};
    desc.struct_size = sizeof desc;
    desc.element_bytes = 4;
    desc.count = 6;
    desc.input = clCreateBuffer(context, copy, sizeof input, input, NULL);
    desc.flags = clCreateBuffer(context, copy, sizeof flags, flags, NULL);
    desc.output = clCreateBuffer(context, copy, sizeof output, output, NULL);
    desc.output_count = clCreateBuffer(context, CL_MEM_READ_WRITE, sizeof count, NULL, NULL);

    if (rsh_reduce(rsh, queue, &desc, 0, NULL, NULL) != RSH_SUCCESS) return fail("rsh_reduce");
    clEnqueueReadBuffer(queue, desc.output, CL_TRUE, 0, sizeof output, output, 0, NULL, NULL);
    clEnqueueReadBuffer(queue, desc.output_count, CL_TRUE, 0, sizeof count, &count, 0, NULL,
                        NULL);
    clReleaseMemObject(desc.input);
    clReleaseMemObject(desc.flags);
    clReleaseMemObject(desc.output);
    clReleaseMemObject(desc.output_count);
    printf("kept %u: %u %u %u\n", count, output[0], output[1], output[2]);
    return !(count == 3 && output[0] == 1 && output[1] == 3 && output[2] == 5 &&
             output[3] == 9);
}

int main(void) {
    cl_platform_id platform = NULL;
    rsh_context_desc desc = {0};
    rsh_context rsh = NULL;
    cl_command_queue queue;
    int wrong;
    desc.struct_size = sizeof desc;
    if (rsh_version() != RSH_VERSION) return fail("header and library differ");
    if (rsh_find_device(NULL, &platform, &desc.device) != RSH_SUCCESS)
        return fail("rsh_find_device");
    desc.context = clCreateContext(NULL, 1, &desc.device, NULL, NULL, NULL);
    queue = clCreateCommandQueue(desc.context, desc.device, 0, NULL);
    if (rsh_create_context(&desc, &rsh) != RSH_SUCCESS) return fail("rsh_create_context");
    wrong = pack(rsh, desc.context, queue);
    rsh_release_context(rsh);
    clReleaseCommandQueue(queue);
    clReleaseContext(desc.context);
    return wrong;
}
