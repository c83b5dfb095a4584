#include "device/programs/variants.hpp"

#include "device/error.hpp"

namespace rsh {

KernelName general_of(const KernelName& variant) {
    return {variant.program, variant.kernel};
}

KernelName Variants::for_call(const KernelName& name) {
    if (!name.is_variant || programs_.is_built(name)) return name;
    const KernelName general = general_of(name);
    return general_serves(general) || !takes_place(name) ? general : name;
}

KernelName Variants::in_advance(const KernelName& name) {
    return !name.is_variant || takes_place(name) ? name : general_of(name);
}

void Variants::allow_general(const KernelName& variant) {
    const std::lock_guard<std::mutex> lock(mutex_);
    files_[variant.program].allows_general = true;
}

bool Variants::is_to_follow(const KernelName& name) {
    if (!name.is_variant || programs_.is_built(name) || !takes_place(name)) return false;
    const std::lock_guard<std::mutex> lock(mutex_);
    File& file = files_[name.program];
    return file.allows_general && file.followed.insert(name.options).second;
}

size_t Variants::made() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    size_t count = 0;
    for (const auto& [program, file] : files_)
        for (const std::string& options : file.placed)
            count += programs_.is_built({program.c_str(), "", options});
    return count;
}

// Whoever comes first has it, for good.
bool Variants::takes_place(const KernelName& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::set<std::string>& placed = files_[name.program].placed;
    if (placed.size() < most_) placed.insert(name.options);
    return placed.count(name.options) != 0;
}

// Not under the lock: others need not wait for the compiler.
bool Variants::general_serves(const KernelName& general) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!files_[general.program].allows_general) return false;
    }
    if (guarded([&] { programs_.ensure(general); }) == RSH_SUCCESS) return true;
    log_(general.program, ".cl: the general program fails; variants are compiled when needed");
    const std::lock_guard<std::mutex> lock(mutex_);
    files_[general.program].allows_general = false;
    return false;
}

}  // namespace rsh
