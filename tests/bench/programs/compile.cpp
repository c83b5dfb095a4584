#include "programs/compile.hpp"

#include "programs/library_programs.hpp"
#include "programs/ptxas_log.hpp"
#include "timing.hpp"

namespace bench {
namespace {

using nlohmann::json;

std::string first_lines(const std::string& log) {
    constexpr size_t kMost = 1000;
    return log.size() > kMost ? log.substr(0, kMost) + " ..." : log;
}

// The extension of an option that the compiler would refuse if it did not have it.
bool has_verbose_option(const cl::Device& device) {
    return device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_nv_compiler_options") !=
           std::string::npos;
}

void add_figures(const PtxasFigures& figures, json& kernel) {
    kernel.update({{"registers", figures.registers},
                   {"stack_bytes", figures.stack_bytes},
                   {"spill_bytes", figures.spill_store_bytes},
                   {"spill_load_bytes", figures.spill_load_bytes},
                   {"shared_bytes", figures.shared_bytes}});
}

}  // namespace

Compiler::Compiler(const Device& device, cl_uint width)
    : device_(device),
      width_(width > 0 ? width : default_vector_width(device.device()())),
      tells_registers_(has_verbose_option(device.device())),
      options_(base_options(device.device()(), width_) +
               (tells_registers_ ? " -cl-nv-verbose" : "")) {}

json Compiler::compile(const ProgramName& name) const {
    try {
        return build(name);
    } catch (const cl::BuildError& error) {
        const auto logs = error.getBuildLog();
        return {{"error", first_lines(logs.empty() ? error.what() : logs.front().second)}};
    } catch (const std::exception& error) {  // no such file, or the driver gave up
        return {{"error", describe_error(error)}};
    }
}

json Compiler::build(const ProgramName& name) const {
    const std::string source = program_source(name.stem);
    cl::Program program(device_.context(), source);
    const std::string options = options_ + ' ' + name.options;
    const double ms = milliseconds([&] { program.build({device_.device()}, options.c_str()); });
    return {{"seconds", ms * 1e-3}, {"kernels", kernels_of(program)}};
}

json Compiler::kernels_of(const cl::Program& program) const {
    const cl::Device& device = device_.device();
    const auto figures = read_ptxas_log(
        tells_registers_ ? program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device) : std::string());
    cl::vector<cl::Kernel> kernels;
    cl::Program(program).createKernels(&kernels);
    json list = json::array();
    for (const cl::Kernel& kernel : kernels) {
        const std::string name = kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
        json one = {
            {"name", name},
            {"private_bytes", kernel.getWorkGroupInfo<CL_KERNEL_PRIVATE_MEM_SIZE>(device)},
            {"local_bytes", kernel.getWorkGroupInfo<CL_KERNEL_LOCAL_MEM_SIZE>(device)},
            {"group_size", kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device)},
            {"group_multiple",
             kernel.getWorkGroupInfo<CL_KERNEL_PREFERRED_WORK_GROUP_SIZE_MULTIPLE>(device)}};
        const auto found = figures.find(name);
        if (found != figures.end()) add_figures(found->second, one);
        list.push_back(one);
    }
    return list;
}

}  // namespace bench
