// counts.cpp - a layer that counts what a program asks OpenCL for: counts.hpp. An object is alive
// until its caller has released it as often as it made and retained it, a buffer also while a
// sub-buffer of it is. Leaves images, pipes and shared virtual memory out.
#include "support/layers/counts.hpp"

#include <cstdlib>

#include "support/layers/count_calls.hpp"
#include "support/layers/objects.hpp"

namespace {

using namespace layer;

cl_mem CL_API_CALL create_buffer(cl_context context, cl_mem_flags flags, size_t bytes,
                                 void* host, cl_int* status) {
    const cl_mem made = below.clCreateBuffer(context, flags, bytes, host, status);
    if (made) objects().add_buffer(made, bytes);
    return made;
}

cl_mem CL_API_CALL create_buffer_with_properties(cl_context context,
                                                 const cl_mem_properties* properties,
                                                 cl_mem_flags flags, size_t bytes, void* host,
                                                 cl_int* status) {
    const cl_mem made =
        below.clCreateBufferWithProperties(context, properties, flags, bytes, host, status);
    if (made) objects().add_buffer(made, bytes);
    return made;
}

cl_mem CL_API_CALL create_sub_buffer(cl_mem buffer, cl_mem_flags flags,
                                     cl_buffer_create_type type, const void* what,
                                     cl_int* status) {
    const cl_mem made = below.clCreateSubBuffer(buffer, flags, type, what, status);
    if (made) objects().add_sub_buffer(made, buffer);
    return made;
}

cl_program CL_API_CALL create_from_binary(cl_context context, cl_uint count,
                                          const cl_device_id* devices, const size_t* lengths,
                                          const unsigned char** binaries, cl_int* each,
                                          cl_int* status) {
    const cl_program made = below.clCreateProgramWithBinary(context, count, devices, lengths,
                                                            binaries, each, status);
    if (made) objects().add(made, Kind::binary_program);
    return made;
}

void count_build(bool of_binaries) {
    objects().count(of_binaries ? &rsh_counts::binary_builds : &rsh_counts::compiles);
}

cl_int CL_API_CALL build(cl_program program, cl_uint count, const cl_device_id* devices,
                         const char* options, void(CL_CALLBACK* notify)(cl_program, void*),
                         void* user) {
    count_build(objects().is_binary(program));
    return below.clBuildProgram(program, count, devices, options, notify, user);
}

cl_int CL_API_CALL compile(cl_program program, cl_uint count, const cl_device_id* devices,
                           const char* options, cl_uint header_count, const cl_program* headers,
                           const char** names, void(CL_CALLBACK* notify)(cl_program, void*),
                           void* user) {
    count_build(objects().is_binary(program));
    return below.clCompileProgram(program, count, devices, options, header_count, headers,
                                  names, notify, user);
}

cl_program CL_API_CALL link(cl_context context, cl_uint count, const cl_device_id* devices,
                            const char* options, cl_uint input_count, const cl_program* inputs,
                            void(CL_CALLBACK* notify)(cl_program, void*), void* user,
                            cl_int* status) {
    bool of_binaries = true;
    for (cl_uint i = 0; i < input_count; ++i) of_binaries &= objects().is_binary(inputs[i]);
    count_build(of_binaries);
    const cl_program made = below.clLinkProgram(context, count, devices, options, input_count,
                                                inputs, notify, user, status);
    if (made) objects().add(made, of_binaries ? Kind::binary_program : Kind::program);
    return made;
}

cl_int CL_API_CALL create_kernels(cl_program program, cl_uint room, cl_kernel* kernels,
                                  cl_uint* count) {
    cl_uint made = 0;
    const cl_int status = below.clCreateKernelsInProgram(program, room, kernels, &made);
    if (count) *count = made;
    for (cl_uint i = 0; status == CL_SUCCESS && kernels && i < made; ++i)
        objects().add(kernels[i], Kind::kernel);
    return status;
}

void change_objects(cl_icd_dispatch& calls) {
    calls.clCreateBuffer = create_buffer;
    calls.clCreateBufferWithProperties = create_buffer_with_properties;
    calls.clCreateSubBuffer = create_sub_buffer;
    calls.clCreateProgramWithBinary = create_from_binary;
    calls.clBuildProgram = build;
    calls.clCompileProgram = compile;
    calls.clLinkProgram = link;
    calls.clCreateKernelsInProgram = create_kernels;
}

}  // namespace

void layer::change(cl_icd_dispatch& calls) {
    change_objects(calls);
    count_calls(calls);
}

extern "C" void rsh_read_counts(rsh_counts* counts) {
    *counts = objects().counts();
}

extern "C" void rsh_restart_peak() {
    objects().restart_peak();
}

// After the destructors of the program, which release what it holds.
__attribute__((destructor)) static void write_counts() {
    const char* const path = std::getenv("RSH_COUNTS");
    if (path) objects().write(path);
}
