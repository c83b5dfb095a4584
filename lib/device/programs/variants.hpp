// variants.hpp - programs of one file that are compiled for what a scene has, at most so many of a file,
// and the general one, which asks the scene instead: slower, but it does the work of each of them with
// the same bits. Says which of them a call takes; compiles and keeps none, programs.hpp does.
#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>

#include "device/log.hpp"
#include "device/programs/programs.hpp"

namespace rsh {

// The program of that file without options.
KernelName general_of(const KernelName& variant);

class Variants {
public:
    // At most `most` of a file.
    Variants(Programs& programs, const Log& log, size_t most)
        : programs_(programs), log_(log), most_(most) {}

    // What a call takes for `name`. BLOCKS where that is a general program which is not there yet.
    KernelName for_call(const KernelName& name);
    // What is compiled beforehand for `name`: itself, or the general program where it is one too many.
    KernelName in_advance(const KernelName& name);
    // From now on calls take the general program until the variant that they need is there; if it does
    // not compile, no longer.
    void allow_general(const KernelName& variant);
    // Whether `name` is missing and is to be compiled while the general program serves: true once.
    bool is_to_follow(const KernelName& name);

    // Variants compiled or loaded so far.
    size_t made() const;

private:
    struct File {
        bool allows_general = false;
        std::set<std::string> placed;    // options of those that may be compiled
        std::set<std::string> followed;  // of those that is_to_follow named
    };
    bool takes_place(const KernelName& name);
    bool general_serves(const KernelName& general);

    Programs& programs_;
    const Log& log_;
    const size_t most_;
    mutable std::mutex mutex_;
    std::map<std::string, File> files_;
};

}  // namespace rsh
