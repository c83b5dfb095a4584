#include "loaders/second_loader.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace loaders {
namespace {

void* open_second() {
    const char* const path = std::getenv("RSH_SECOND_LOADER");
    if (!path) throw std::runtime_error("RSH_SECOND_LOADER names no library");
    void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::runtime_error(dlerror());
    return library;
}

template <class Function>
void load(void* library, const char* name, Function& function, Function linked) {
    void* const found = dlsym(library, name);
    if (!found) throw std::runtime_error(std::string("the second loader has no ") + name);
    std::memcpy(&function, &found, sizeof function);
    if (function == linked)
        throw std::runtime_error(std::string(name) +
                                 " is the linked loader's, must be another");
}

cl_icd_dispatch loaded() {
    void* const library = open_second();
    cl_icd_dispatch functions = {};
#define RSH_LOAD(name) load<decltype(&::name)>(library, #name, functions.name, &::name);
    RSH_LOAD(clGetPlatformIDs)
    RSH_LOAD(clGetDeviceIDs)
    RSH_LOAD(clCreateContext)
    RSH_LOAD(clReleaseContext)
    RSH_LOAD(clCreateCommandQueue)
    RSH_LOAD(clReleaseCommandQueue)
    RSH_LOAD(clFinish)
    RSH_LOAD(clCreateBuffer)
    RSH_LOAD(clReleaseMemObject)
    RSH_LOAD(clEnqueueReadBuffer)
    RSH_LOAD(clCreateUserEvent)
    RSH_LOAD(clSetUserEventStatus)
    RSH_LOAD(clWaitForEvents)
    RSH_LOAD(clReleaseEvent)
#undef RSH_LOAD
    return functions;
}

}  // namespace

void require(cl_int status, const char* call) {
    if (status != CL_SUCCESS)
        throw std::runtime_error(std::string(call) +
                                 " by the second loader: " + std::to_string(status));
}

const cl_icd_dispatch& second() {
    static const cl_icd_dispatch functions = loaded();
    return functions;
}

SecondDevice::SecondDevice() {
    cl_platform_id platform = nullptr;
    cl_int status = CL_SUCCESS;
    require(second().clGetPlatformIDs(1, &platform, nullptr), "clGetPlatformIDs");
    require(second().clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1, &device_, nullptr),
            "clGetDeviceIDs");
    context_ = second().clCreateContext(nullptr, 1, &device_, nullptr, nullptr, &status);
    require(status, "clCreateContext");
    queue_ =
        second().clCreateCommandQueue(context_, device_, CL_QUEUE_PROFILING_ENABLE, &status);
    require(status, "clCreateCommandQueue");
}

SecondDevice::~SecondDevice() {
    second().clFinish(queue_);
    for (cl_mem memory : buffers_) second().clReleaseMemObject(memory);
    second().clReleaseCommandQueue(queue_);
    second().clReleaseContext(context_);
}

cl_mem SecondDevice::buffer(size_t bytes, const void* contents) {
    cl_int status = CL_SUCCESS;
    const cl_mem_flags flags = CL_MEM_READ_WRITE | (contents ? CL_MEM_COPY_HOST_PTR : 0);
    cl_mem made =
        second().clCreateBuffer(context_, flags, bytes, const_cast<void*>(contents), &status);
    require(status, "clCreateBuffer");
    buffers_.push_back(made);
    return made;
}

void SecondDevice::read(cl_mem memory, size_t bytes, void* to) {
    require(second().clEnqueueReadBuffer(queue_, memory, CL_TRUE, 0, bytes, to, 0, nullptr,
                                         nullptr),
            "clEnqueueReadBuffer");
}

}  // namespace loaders
