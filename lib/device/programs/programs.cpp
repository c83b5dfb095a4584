#include "device/programs/programs.hpp"

#include <ctime>

#include <algorithm>
#include <new>

#include "device/error.hpp"
#include "device/programs/kernel_source.hpp"

namespace rsh {
namespace {

// A program that takes longer than this to compile is worth storing, unless the driver itself keeps
// what it compiles: handing it out may then cost more than it saves. PoCL compiles every kernel
// once more for that, two seconds for the traversal's.
constexpr double kSlowSeconds = 0.2;

// The driver keeps what it compiles where a second build takes less than this share of the first one.
// The first one of a process may include half a second in which the compiler itself starts.
constexpr double kKeptShare = 0.25;

double seconds_by(clockid_t clock) {
    timespec now = {};
    clock_gettime(clock, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

// Those that the calling thread computed, lest a program seem slow because others are busy; by the
// clock where a driver compiles elsewhere and the thread waits.
template <class Work>
double seconds_of(Work work) {
    const double start = seconds_by(CLOCK_MONOTONIC);
    const double computing_start = seconds_by(CLOCK_THREAD_CPUTIME_ID);
    work();
    const double seconds = seconds_by(CLOCK_MONOTONIC) - start;
    const double computing = seconds_by(CLOCK_THREAD_CPUTIME_ID) - computing_start;
    return computing > 0.05 * seconds ? computing : seconds;
}

cl_int build(cl_program program, cl_device_id device, const std::string& options) {
    return opencl(program).clBuildProgram(program, 1, &device, options.c_str(), nullptr,
                                          nullptr);
}

// What the compiler says, if anything.
std::string build_log(cl_program program, cl_device_id device) {
    size_t bytes = 0;
    opencl(program).clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr,
                                          &bytes);
    std::string log(bytes, '\0');
    if (opencl(program).clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, bytes,
                                              &log[0], nullptr) != CL_SUCCESS)
        return "";
    log.resize(std::min(log.find('\0'), log.size()));
    return log;
}

// One per device of the program, empty for those that it is not built for.
std::vector<std::vector<unsigned char>> binaries_of(cl_program program) {
    std::vector<std::vector<unsigned char>> binaries;
    for (const size_t bytes : info_list<size_t>(program, CL_PROGRAM_BINARY_SIZES))
        binaries.emplace_back(bytes);
    std::vector<unsigned char*> places;
    for (auto& binary : binaries) places.push_back(binary.empty() ? nullptr : binary.data());
    require_success(opencl(program).clGetProgramInfo(program, CL_PROGRAM_BINARIES,
                                                     places.size() * sizeof places[0],
                                                     places.data(), nullptr),
                    "clGetProgramInfo");
    return binaries;
}

}  // namespace

// One built program and its idle kernels. Built under its own mutex: a second thread that needs
// the same program waits, one that needs another does not.
struct Programs::Program {
    std::mutex mutex;
    BuiltProgram program;
    std::atomic<bool> is_built{false};
    std::map<std::string, IdleKernels> idle;
};

Kernel IdleKernels::take(cl_program program, const char* name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (idle_.empty()) {
        idle_.reserve(made_ + 1);
        cl_int status = CL_SUCCESS;
        Kernel kernel(opencl(program).clCreateKernel(program, name, &status));
        require_success(status, "clCreateKernel");
        ++made_;
        return kernel;
    }
    Kernel kernel = std::move(idle_.back());
    idle_.pop_back();
    return kernel;
}

void IdleKernels::give_back(Kernel kernel) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    idle_.push_back(std::move(kernel));
}

Programs::Programs(cl_context context, cl_device_id device, const DeviceCaps& caps,
                   const Log& log, std::string options, ProgramFolders folders)
    : log_(log),
      context_(context),
      device_(device),
      identity_(caps.identity),
      options_(std::move(options)),
      kernel_folder_(std::move(folders.kernels)),
      cache_(std::move(folders.cache), log, folders.cache_bytes) {}

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
    ensure(entry, name);
    IdleKernels& idle = entry.idle[name.kernel];
    return {idle, idle.take(entry.program.get(), name.kernel)};
}

void Programs::ensure(const KernelName& name) {
    Program& entry = program(name);
    const std::lock_guard<std::mutex> lock(entry.mutex);
    ensure(entry, name);
}

bool Programs::is_built(const KernelName& name) {
    return program(name).is_built;
}

// Under the entry's lock.
void Programs::ensure(Program& entry, const KernelName& name) {
    if (!entry.program) entry.program = make(name);
    entry.is_built = true;
}

BuiltProgram Programs::make(const KernelName& name) {
    const std::string source = kernel_source(name.program, kernel_folder_);
    const std::string options = options_ + ' ' + name.options;
    const std::string key =
        std::to_string(RSH_VERSION) + '\n' + identity_ + '\n' + options + '\n' + source;
    BuiltProgram program = load(key, options);
    if (program) {
        log_(name.program, ".cl: taken from the disk cache");
        return program;
    }
    const auto build = [&] { program = compile(name, source, options); };
    ++built_;
    const double seconds = seconds_of(build);
    log_(name.program, ".cl: compiled in ", seconds, " s with ", options);
    if (seconds > kSlowSeconds && must_store(seconds, [&] { return seconds_of(build); }))
        store(key, program.get());
    return program;
}

// Asks the driver once: what is true of a program that took `seconds` is true of all.
template <class Rebuild>
bool Programs::must_store(double seconds, Rebuild seconds_again) {
    if (keeper_ != Keeper::kUnknown) return keeper_ == Keeper::kNobody;
    const double again = seconds_again();
    if (again < kKeptShare * seconds)
        keeper_ = Keeper::kDriver;
    else if (again > kSlowSeconds)
        keeper_ = Keeper::kNobody;
    return keeper_ == Keeper::kNobody;
}

// A binary that the driver refuses, or builds into nothing, is as good as none.
BuiltProgram Programs::load(const std::string& key, const std::string& options) {
    const auto binary = cache_.load(key);
    if (!binary) return {};
    const unsigned char* bytes = binary->data();
    const size_t size = binary->size();
    cl_int status = CL_SUCCESS;
    BuiltProgram program(opencl(context_).clCreateProgramWithBinary(
        context_, 1, &device_, &size, &bytes, nullptr, &status));
    if (status != CL_SUCCESS || build(program.get(), device_, options) != CL_SUCCESS) return {};
    ++loaded_;
    return program;
}

BuiltProgram Programs::compile(const KernelName& name, const std::string& source,
                               const std::string& options) {
    const char* text = source.data();
    const size_t size = source.size();
    cl_int status = CL_SUCCESS;
    BuiltProgram program(
        opencl(context_).clCreateProgramWithSource(context_, 1, &text, &size, &status));
    require_success(status, "clCreateProgramWithSource");
    status = build(program.get(), device_, options);
    if (status == CL_SUCCESS) return program;
    const std::string log = build_log(program.get(), device_);
    const char* const code = opencl_error_name(status);
    throw Error(RSH_BUILD_FAILED, name.program, ".cl (", options, "): ", code ? code : "", '\n',
                log);
}

// Failing to store costs the next process a compilation, and this one nothing.
void Programs::store(const std::string& key, cl_program program) {
    try {
        const auto devices = info_list<cl_device_id>(program, CL_PROGRAM_DEVICES);
        const auto binaries = binaries_of(program);
        for (size_t i = 0; i < devices.size() && i < binaries.size(); ++i)
            if (devices[i] == device_) cache_.store(key, binaries[i]);
    } catch (const Error&) {
        return;
    } catch (const std::bad_alloc&) {
        return;
    }
}

}  // namespace rsh
