#include "device/programs/programs.hpp"

#include <chrono>

#include "device/error.hpp"
#include "device/programs/kernel_source.hpp"

namespace rsh {
namespace {

// A program that took longer than this to compile is compiled again at once. Where that takes
// less than half as long, the driver keeps what it compiles, and the program is not stored:
// handing it out may cost more than it saves. PoCL compiles every kernel once more for that, two
// seconds for the traversal's.
constexpr double kSlowSeconds = 0.2;

template <class Work>
double seconds_of(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

// One built program and its idle kernels. Built under its own mutex: a second thread that needs
// the same program waits, one that needs another does not.
struct Programs::Program {
    std::mutex mutex;
    cl::Program program;
    std::map<std::string, IdleKernels> idle;
};

cl::Kernel IdleKernels::take(const cl::Program& program, const char* name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (idle_.empty()) {
        idle_.reserve(made_ + 1);
        cl::Kernel kernel(program, name);
        ++made_;
        return kernel;
    }
    cl::Kernel kernel = std::move(idle_.back());
    idle_.pop_back();
    return kernel;
}

void IdleKernels::give_back(cl::Kernel kernel) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(kernel));
}

Programs::Programs(cl::Context context, cl::Device device, const DeviceCaps& caps,
                   const Log& log, std::string options, std::string cache_folder,
                   std::string kernel_folder)
    : log_(log),
      context_(std::move(context)),
      device_(std::move(device)),
      identity_(caps.identity),
      options_(std::move(options)),
      kernel_folder_(std::move(kernel_folder)),
      cache_(std::move(cache_folder)) {}

Programs::~Programs() = default;

Programs::Program& Programs::program(const KernelName& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::unique_ptr<Program>& found = programs_[std::string(name.program) + ' ' + name.options];
    if (!found) found = std::make_unique<Program>();
    return *found;
}

BorrowedKernel Programs::borrow(const KernelName& name) {
    Program& entry = program(name);
    const std::lock_guard<std::mutex> lock(entry.mutex);
    if (!entry.program()) entry.program = make(name);
    IdleKernels& idle = entry.idle[name.kernel];
    return {idle, idle.take(entry.program, name.kernel)};
}

cl::Program Programs::make(const KernelName& name) {
    const std::string source = kernel_source(name.program, kernel_folder_);
    const std::string options = options_ + ' ' + name.options;
    const std::string key =
        std::to_string(RSH_VERSION) + '\n' + identity_ + '\n' + options + '\n' + source;
    cl::Program program = load(key, options);
    if (program()) {
        log_(std::string(name.program) + ".cl: taken from the disk cache");
        return program;
    }
    const auto build = [&] { program = compile(name, source, options); };
    ++built_;
    const double seconds = seconds_of(build);
    log_(std::string(name.program) + ".cl: compiled in " + std::to_string(seconds) +
         " s with " + options);
    if (seconds > kSlowSeconds && seconds_of(build) > seconds / 2) store(key, program);
    return program;
}

// A binary that the driver refuses, or builds into nothing, is as good as none.
cl::Program Programs::load(const std::string& key, const std::string& options) {
    const auto binary = cache_.load(key);
    if (!binary) return {};
    try {
        cl::Program program(context_, {device_}, cl::Program::Binaries{*binary});
        program.build({device_}, options.c_str());
        ++loaded_;
        return program;
    } catch (const std::exception&) {
        return {};
    }
}

cl::Program Programs::compile(const KernelName& name, const std::string& source,
                              const std::string& options) {
    cl::Program program(context_, source);
    cl_int failed = CL_SUCCESS;
    try {
        program.build({device_}, options.c_str());
        return program;
    } catch (const cl::BuildError& error) {
        failed = error.err();
    }
    const char* const code = opencl_error_name(failed);
    throw Error(RSH_BUILD_FAILED, name.program, ".cl (", options, "): ", code ? code : "", '\n',
                program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device_));
}

// Failing to store costs the next process a compilation, and this one nothing.
void Programs::store(const std::string& key, const cl::Program& program) const {
    try {
        const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
        const auto devices = program.getInfo<CL_PROGRAM_DEVICES>();
        for (size_t i = 0; i < devices.size(); ++i)
            if (devices[i]() == device_()) cache_.store(key, binaries[i]);
    } catch (const std::exception&) {
        return;
    }
}

}  // namespace rsh
