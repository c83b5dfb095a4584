// plugins.hpp - contenders out of shared objects: rsh_bench_plugin.h. They stay loaded until the process
// ends.
#pragma once

#include <map>

#include "reduce/contender.hpp"
#include "reduce/plugins/rsh_bench_plugin.h"

namespace bench {

class Plugins {
public:
    // Throws std::runtime_error, which names file and fault, for one that is none, of another version,
    // or of a name that is taken.
    explicit Plugins(const std::vector<std::string>& files);

    const std::vector<std::string>& names() const {
        return names_;
    }  // "peer:NAME", in the order of the files
    bool has(const std::string& name) const { return by_name_.count(name) > 0; }

    // Throws std::runtime_error with what the plug-in says; `refusal` is that, and the contender null,
    // where it does not take such streams.
    std::unique_ptr<Contender> make(const std::string& name, const Device& device,
                                    const DeviceStream& stream, std::string& refusal) const;

private:
    void add(const std::string& file);

    std::map<std::string, const rsh_bench_plugin*> by_name_;
    std::vector<std::string> names_;
};

}  // namespace bench
