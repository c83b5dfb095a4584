// programs.hpp - kernels by name. Builds a program on first use, from the disk cache or from
// source, and lends out kernel objects: clSetKernelArg on a shared kernel is not thread-safe,
// so no two calls ever hold the same one.
#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "device/cl/device_caps.hpp"
#include "device/log.hpp"
#include "device/objects/handle.hpp"
#include "device/programs/binary_cache.hpp"

namespace rsh {

// Which kernel: file stem, kernel name, compile-time parameters ("-D RSH_WORDS=2"). A variant: the
// program without them does the same, see variants.hpp.
struct KernelName {
    const char* program;
    const char* kernel;
    std::string options = {};
    bool is_variant = false;
};

// Where programs come from and are kept.
struct ProgramFolders {
    std::string cache;     // "": none
    uint64_t cache_bytes;  // see BinaryCache
    std::string kernels;   // "": the embedded files
};

using BuiltProgram = Handle<cl_program>;

// Kernel objects of one kernel that no call holds at the moment.
class IdleKernels {
public:
    Kernel take(cl_program program, const char* name);
    void give_back(Kernel kernel) noexcept;

private:
    std::mutex mutex_;
    std::vector<Kernel> idle_;  // has room for all that were made
    size_t made_ = 0;
};

// A kernel object of one's own for a while.
class BorrowedKernel {
public:
    BorrowedKernel(IdleKernels& home, Kernel kernel)
        : home_(home), kernel_(std::move(kernel)) {}
    ~BorrowedKernel() { home_.give_back(std::move(kernel_)); }
    BorrowedKernel(const BorrowedKernel&) = delete;
    BorrowedKernel& operator=(const BorrowedKernel&) = delete;

    cl_kernel get() const { return kernel_.get(); }

private:
    IdleKernels& home_;
    Kernel kernel_;
};

class Programs {
public:
    Programs(cl_context context, cl_device_id device, const DeviceCaps& caps, const Log& log,
             std::string options, ProgramFolders folders);
    ~Programs();

    BorrowedKernel borrow(const KernelName& name);
    // BLOCKS until the program is there.
    void ensure(const KernelName& name);
    // Whether it is: does not wait for one that is being compiled.
    bool is_built(const KernelName& name);

    unsigned built() const { return built_; }
    unsigned loaded() const { return loaded_; }

private:
    struct Program;
    Program& program(const KernelName& name);
    void ensure(Program& entry, const KernelName& name);
    BuiltProgram make(const KernelName& name);
    BuiltProgram load(const std::string& key, const std::string& options);
    BuiltProgram compile(const KernelName& name, const std::string& source,
                         const std::string& options);
    // Who has what the driver compiled when the next process asks for it.
    enum class Keeper { kUnknown, kDriver, kNobody };
    template <class Rebuild>
    bool must_store(double seconds, Rebuild seconds_again);
    void store(const std::string& key, cl_program program);

    const Log& log_;
    cl_context context_;  // of the Context's
    cl_device_id device_;
    std::string identity_;
    std::string options_;
    std::string kernel_folder_;
    BinaryCache cache_;
    std::mutex mutex_;
    std::map<std::string, std::unique_ptr<Program>> programs_;  // by stem and options
    std::atomic<Keeper> keeper_{Keeper::kUnknown};
    std::atomic<unsigned> built_{0};
    std::atomic<unsigned> loaded_{0};
};

}  // namespace rsh
