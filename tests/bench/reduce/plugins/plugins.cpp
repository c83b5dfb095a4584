#include "reduce/plugins/plugins.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace bench {
namespace {

static_assert(int(RSH_BENCH_KEEP_FLAGS) == int(RSH_KEEP_FLAGS) &&
                  int(RSH_BENCH_KEEP_NOT_NULL) == int(RSH_KEEP_NOT_NULL) &&
                  int(RSH_BENCH_KEEP_BITS) == int(RSH_KEEP_BITS),
              "plug-ins are told as rsh_reduce is");

constexpr char kSymbol[] = "rsh_bench_get_plugin";

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw std::runtime_error(file + ": " + what);
}

const char* text_or(const char* text, const char* otherwise) {
    return text ? text : otherwise;
}

const rsh_bench_plugin* load(const std::string& file) {
    void* const library =
        dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) fail(file, text_or(dlerror(), "cannot be loaded"));
    void* const symbol = dlsym(library, kSymbol);
    if (!symbol) fail(file, fmt::format("has no symbol {}: see rsh_bench_plugin.h", kSymbol));
    decltype(&rsh_bench_get_plugin) get = nullptr;
    std::memcpy(&get, &symbol, sizeof get);
    const rsh_bench_plugin* const plugin = get();
    if (!plugin) fail(file, fmt::format("{} returns NULL", kSymbol));
    return plugin;
}

bool is_name(const char* name) {
    const auto is_part = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    return name && *name && std::all_of(name, name + std::strlen(name), is_part);
}

// Members behind the version mean nothing before that is right.
void check(const std::string& file, const rsh_bench_plugin& plugin) {
    if (plugin.version != RSH_BENCH_PLUGIN_VERSION)
        fail(file, fmt::format("version is {}, must be {}", plugin.version,
                               RSH_BENCH_PLUGIN_VERSION));
    if (!is_name(plugin.name))
        fail(file, fmt::format("name is \"{}\", must be of letters, digits and _",
                               text_or(plugin.name, "")));
    const std::pair<const char*, bool> functions[] = {{"create", plugin.create != nullptr},
                                                      {"run", plugin.run != nullptr},
                                                      {"destroy", plugin.destroy != nullptr},
                                                      {"error", plugin.error != nullptr}};
    for (const auto& [name, is_there] : functions)
        if (!is_there) fail(file, fmt::format("{} is NULL, must be a function", name));
}

std::string said_by(const rsh_bench_plugin& plugin, const char* call, int result) {
    return fmt::format("{} of the plug-in {} returned {}: {}", call, plugin.name, result,
                       text_or(plugin.error(), "without a word"));
}

class PluginContender final : public Contender {
public:
    // `state`: made by the plug-in for the stream; destroyed here.
    PluginContender(const rsh_bench_plugin& plugin, const Device& device,
                    const DeviceStream& stream, void* state)
        : plugin_(plugin), device_(device), stream_(stream), state_(state) {}
    ~PluginContender() override { plugin_.destroy(state_); }
    PluginContender(const PluginContender&) = delete;
    PluginContender& operator=(const PluginContender&) = delete;

    void run() override {
        const int result = plugin_.run(state_);
        device_.queue().finish();
        if (result != RSH_BENCH_DONE) throw std::runtime_error(said_by(plugin_, "run", result));
    }
    bool is_right() const override {
        cl_uint count = 0;
        device_.queue().enqueueReadBuffer(stream_.count, CL_TRUE, 0, sizeof count, &count);
        return is_output_right(device_, stream_, count, plugin_.is_stable != CL_FALSE);
    }

private:
    const rsh_bench_plugin& plugin_;
    const Device& device_;
    const DeviceStream& stream_;
    void* state_;
};

rsh_bench_stream described(const Device& device, const DeviceStream& stream) {
    return {device.context()(),  device.device()(),  device.queue()(), stream.host.spec.bytes,
            stream.host.count(), id_of(stream.keep), stream.input(),   stream.flags(),
            stream.output(),     stream.count()};
}

}  // namespace

Plugins::Plugins(const std::vector<std::string>& files) {
    for (const std::string& file : files) add(file);
}

void Plugins::add(const std::string& file) {
    const rsh_bench_plugin* const plugin = load(file);
    check(file, *plugin);
    const std::string name = std::string("peer:") + plugin->name;
    std::vector<std::string> taken = peer_names();
    taken.emplace_back("peer:pyopencl");
    taken.insert(taken.end(), names_.begin(), names_.end());
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
        fail(file, fmt::format("name is \"{}\", which another peer has", plugin->name));
    by_name_[name] = plugin;
    names_.push_back(name);
}

std::unique_ptr<Contender> Plugins::make(const std::string& name, const Device& device,
                                         const DeviceStream& stream,
                                         std::string& refusal) const {
    const rsh_bench_plugin& plugin = *by_name_.at(name);
    const rsh_bench_stream what = described(device, stream);
    void* state = nullptr;
    const int result = plugin.create(&what, &state);
    if (result == RSH_BENCH_DONE)
        return std::make_unique<PluginContender>(plugin, device, stream, state);
    refusal = said_by(plugin, "create", result);
    if (result != RSH_BENCH_REFUSED) throw std::runtime_error(refusal);
    return nullptr;
}

}  // namespace bench
