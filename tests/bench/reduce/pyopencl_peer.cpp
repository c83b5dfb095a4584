#include "reduce/pyopencl_peer.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace bench {
namespace {

namespace fs = std::filesystem;

// The first Python that has the package; Debian's is not always the first in the path. None where
// rsh-bench came without its script.
std::string find_python() {
    if (!fs::exists(RSH_PYOPENCL_PEER)) return "";
    for (const char* python : {"python3", "/usr/bin/python3"})
        if (std::system(
                fmt::format("{} -c 'import pyopencl, numpy' 2>/dev/null", python).c_str()) == 0)
            return python;
    return "";
}

}  // namespace

PyopenclPeer::PyopenclPeer(const Device& device)
    : python_(find_python()),
      folder_(fs::temp_directory_path() / fmt::format("rsh-bench-{}", getpid())),
      platform_(device.description()["platform"]),
      device_(device.description()["name"]) {
    fs::create_directories(folder_);
}

PyopenclPeer::~PyopenclPeer() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

bool PyopenclPeer::takes(const StreamSpec& spec) {
    return spec.bytes != 12 && spec.count <= 1u << 24;
}

void PyopenclPeer::add(const Stream& stream, const Case& named) {
    const std::string path = fmt::format("{}/{}.bin", folder_, jobs_.size());
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(stream.words.data()),
               std::streamsize(stream.bytes()));
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
    jobs_.push_back({{"file", path}, {"bytes", stream.spec.bytes}});
    cases_.push_back(named);
}

std::vector<Case> PyopenclPeer::run(double budget_ms, const Limit& limit, Results& results) {
    if (limit.has_passed()) {
        for (const Case& c : cases_) results.leave_out(c.name, limit.when_passed());
        return {};
    }
    if (cases_.empty()) return {};
    const std::string request = folder_ + "/request.json", reply = folder_ + "/reply.json";
    std::ofstream(request) << nlohmann::json{{"platform", platform_},
                                             {"device", device_},
                                             {"budget_ms", budget_ms},
                                             {"jobs", jobs_}};
    const std::string command =
        fmt::format("{} {} {} {}", python_, RSH_PYOPENCL_PEER, request, reply);
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    const nlohmann::json replies = nlohmann::json::parse(std::ifstream(reply));
    for (size_t i = 0; i < cases_.size(); ++i) {
        cases_[i].ok = replies[i]["ok"];
        if (cases_[i].ok) cases_[i].metrics = replies[i]["metrics"];
    }
    return cases_;
}

}  // namespace bench
