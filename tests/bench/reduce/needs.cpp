#include "reduce/needs.hpp"

namespace bench {
namespace {

// Peers have none, or none that could be asked for.
size_t scratch_bytes(const Heat& heat, const std::string& name, rsh_context rsh) {
    if (name.rfind("peer:", 0) == 0) return 0;
    rsh_reduce_desc desc{};
    desc.struct_size = sizeof desc;
    desc.keep = id_of(heat.keep);
    desc.element_bytes = heat.stream.bytes;
    desc.count = heat.stream.count;
    rsh::check(rsh_strategy_from_name(name.c_str(), &desc.strategy), "rsh_strategy_from_name");
    rsh_sizes sizes{};
    sizes.struct_size = sizeof sizes;
    rsh::check(rsh_reduce_query(rsh, &desc, &sizes), "rsh_reduce_query");
    return sizes.scratch_bytes;
}

}  // namespace

std::vector<NamedBytes> buffers_of(const Heat& heat, const std::string& name, rsh_context rsh) {
    const size_t count = heat.stream.count, bytes = count * heat.stream.bytes;
    std::vector<NamedBytes> all = {{"the input", bytes},
                                   {"the output", bytes},
                                   {"the copy", bytes},
                                   {"the scratch memory", scratch_bytes(heat, name, rsh)}};
    if (heat.keep == Keep::kFlags) all.push_back({"the flags", count});
    if (heat.keep == Keep::kBits) all.push_back({"the bits", (count + 7) / 8});
    return all;
}

// Elements, flags, and the output read back; on the host, std::copy_if has both once more.
size_t host_bytes_of(const Heat& heat, const std::string& name) {
    const size_t count = heat.stream.count, bytes = count * heat.stream.bytes;
    const bool is_host = name == "peer:std_copy_if" || name == "peer:parallel_copy_if";
    return count + (is_host ? 4 : 2) * bytes;
}

}  // namespace bench
