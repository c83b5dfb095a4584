// opencl.cpp - the only place that names OpenCL's functions to the linker.
#include "device/objects/opencl.hpp"

namespace rsh {
namespace {

cl_icd_dispatch functions_of_loader() noexcept {
    cl_icd_dispatch functions = {};
#define RSH_LINKED(name) functions.name = name;
    RSH_LINKED(clGetPlatformIDs)
    RSH_LINKED(clGetPlatformInfo)
    RSH_LINKED(clGetDeviceIDs)
    RSH_LINKED(clGetDeviceInfo)
    RSH_LINKED(clRetainContext)
    RSH_LINKED(clReleaseContext)
    RSH_LINKED(clGetContextInfo)
    RSH_LINKED(clRetainCommandQueue)
    RSH_LINKED(clReleaseCommandQueue)
    RSH_LINKED(clGetCommandQueueInfo)
    RSH_LINKED(clFlush)
    RSH_LINKED(clFinish)
    RSH_LINKED(clCreateBuffer)
    RSH_LINKED(clCreateSubBuffer)
    RSH_LINKED(clRetainMemObject)
    RSH_LINKED(clReleaseMemObject)
    RSH_LINKED(clGetMemObjectInfo)
    RSH_LINKED(clCreateProgramWithSource)
    RSH_LINKED(clCreateProgramWithBinary)
    RSH_LINKED(clBuildProgram)
    RSH_LINKED(clRetainProgram)
    RSH_LINKED(clReleaseProgram)
    RSH_LINKED(clGetProgramInfo)
    RSH_LINKED(clGetProgramBuildInfo)
    RSH_LINKED(clCreateKernel)
    RSH_LINKED(clRetainKernel)
    RSH_LINKED(clReleaseKernel)
    RSH_LINKED(clSetKernelArg)
    RSH_LINKED(clGetKernelInfo)
    RSH_LINKED(clGetKernelWorkGroupInfo)
    RSH_LINKED(clWaitForEvents)
    RSH_LINKED(clRetainEvent)
    RSH_LINKED(clReleaseEvent)
    RSH_LINKED(clGetEventInfo)
    RSH_LINKED(clGetEventProfilingInfo)
    RSH_LINKED(clSetEventCallback)
    RSH_LINKED(clEnqueueNDRangeKernel)
    RSH_LINKED(clEnqueueReadBuffer)
    RSH_LINKED(clEnqueueWriteBuffer)
    RSH_LINKED(clEnqueueFillBuffer)
    RSH_LINKED(clEnqueueCopyBuffer)
    RSH_LINKED(clEnqueueMarkerWithWaitList)
    RSH_LINKED(clEnqueueBarrierWithWaitList)
#undef RSH_LINKED
    return functions;
}

}  // namespace

const cl_icd_dispatch& linked_functions() noexcept {
    static const cl_icd_dispatch functions = functions_of_loader();
    return functions;
}

}  // namespace rsh
