// room_on_device.hpp - a room of mirrors traced by rsh_traverse and rsh_spawn, with the device's
// default engine. Every engine finds the same bits, see the suite stability.
#pragma once

#include "device.hpp"
#include "oracle/mirrors/waves.hpp"

namespace bench::mirrors {

class RoomOnDevice final : public oracle::Tracer {
public:
    RoomOnDevice(const Device& device, const oracle::MirrorRoom& room);

    std::vector<rsh_hit> closest(const std::vector<rsh_ray>& rays,
                                 const std::vector<uint32_t>& skip) override;
    oracle::Wave mirrored(const oracle::Wave& wave) override;

private:
    const Device& device_;
    cl::Buffer vertices_, indices_, normals_, materials_;
    rsh_scene scene_{};
};

}  // namespace bench::mirrors
