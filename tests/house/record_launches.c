/* record_launches.c - preloaded into a program that uses OpenCL, adds a line to the file that
 * RSH_RECORD_LAUNCHES names for every kernel that is launched, in order: its name, its work-items and
 * how many of them are a group. launches.py sums them up. RSH_COMPUTE_UNITS, if set, is how many compute
 * units every device says to have: what it then launches is what one with so many would; see scaling.py.
 */
#define _GNU_SOURCE
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef cl_int (*launch_function)(cl_command_queue, cl_kernel, cl_uint, const size_t*,
                                  const size_t*, const size_t*, cl_uint, const cl_event*,
                                  cl_event*);

typedef cl_int (*info_function)(cl_device_id, cl_device_info, size_t, void*, size_t*);

cl_int clGetDeviceInfo(cl_device_id device, cl_device_info name, size_t size, void* value,
                       size_t* size_of_value) {
    info_function next;
    void* const found = dlsym(RTLD_NEXT, "clGetDeviceInfo");
    const char* const units = getenv("RSH_COMPUTE_UNITS");
    if (!found) {
        fprintf(stderr, "record_launches: needs a program that uses OpenCL\n");
        abort();
    }
    memcpy(&next, &found, sizeof next);
    const cl_int status = next(device, name, size, value, size_of_value);
    if (status == CL_SUCCESS && value && units && name == CL_DEVICE_MAX_COMPUTE_UNITS) {
        const cl_uint wanted = (cl_uint)strtoul(units, NULL, 10);
        if (wanted == 0) {
            fprintf(stderr, "record_launches: RSH_COMPUTE_UNITS is '%s', must be 1 or more\n",
                    units);
            abort();
        }
        *(cl_uint*)value = wanted;
    }
    return status;
}

/* rsh launches in one dimension and names the size of a group always. */
static void write_launch(const char* path, cl_kernel kernel, size_t items, size_t group) {
    char name[256] = "";
    clGetKernelInfo(kernel, CL_KERNEL_FUNCTION_NAME, sizeof name, name, NULL);
    FILE* const file = fopen(path, "a");
    if (!file || fprintf(file, "%s %zu %zu\n", name, items, group) < 0 || fclose(file) != 0) {
        fprintf(stderr, "record_launches: cannot write %s\n", path);
        abort();
    }
}

cl_int clEnqueueNDRangeKernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                              const size_t* offset, const size_t* items, const size_t* group,
                              cl_uint wait_count, const cl_event* waits, cl_event* event) {
    launch_function next;
    void* const found = dlsym(RTLD_NEXT, "clEnqueueNDRangeKernel");
    const char* const path = getenv("RSH_RECORD_LAUNCHES");
    if (!found || !path || dimensions != 1 || !group) {
        fprintf(stderr, "record_launches: needs RSH_RECORD_LAUNCHES and launches of rsh\n");
        abort();
    }
    memcpy(&next, &found, sizeof next);
    write_launch(path, kernel, *items, *group);
    return next(queue, kernel, dimensions, offset, items, group, wait_count, waits, event);
}
