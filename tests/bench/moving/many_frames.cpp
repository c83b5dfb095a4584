#include "moving/many_frames.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "scene/device_structs.hpp"
#include "timing.hpp"

namespace bench::moving {
namespace {

constexpr double kMostGrownKib = 10e6 / 1024;

// Of this program, in KiB; 0 where the system does not tell.
double resident_kib() {
    long pages = 0, resident = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
        std::fclose(file);
    }
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1024;
}

// Bounds made once and refitted, one reflection, all lights with shadow.
class Frames {
public:
    Frames(const Device& device, const ManyFrames& asked)
        : device_(device),
          host_({"room", Reflector::kSphere, asked.triangles, "", false}),
          scene_(device, host_),
          colour_(device.context(), CL_MEM_READ_WRITE,
                  asked.size.pixels() * sizeof(cl_float4)) {
        desc_.struct_size = sizeof desc_;
        desc_.scene = &scene_.scene();
        desc_.camera =
            device_camera(host_.camera(), float(asked.size.width) / float(asked.size.height));
        desc_.width = asked.size.width;
        desc_.height = asked.size.height;
        desc_.bounces = 1;
        desc_.colour = colour_();
        desc_.mode = RSH_BOUND_QUALITY;
        make_bounds_buffer();
    }

    double render(double time) {
        return milliseconds([&] {
            scene_.move(time);
            rsh::check(rsh_frame(device_.rsh(), device_.queue()(), &desc_, 0, nullptr, nullptr),
                       "rsh_frame");
            device_.queue().finish();
            desc_.mode = RSH_BOUND_REFIT;
        });
    }

private:
    void make_bounds_buffer() {
        rsh_bound_desc bound{};
        bound.struct_size = sizeof bound;
        bound.geometry = scene_.geometry();
        rsh_sizes sizes{};
        sizes.struct_size = sizeof sizes;
        rsh::check(rsh_bound_query(device_.rsh(), &bound, &sizes), "rsh_bound_query");
        bounds_ = cl::Buffer(device_.context(), CL_MEM_READ_WRITE, sizes.output_bytes);
        desc_.bounds = bounds_();
    }

    const Device& device_;
    FrameScene host_;
    SceneOnDevice scene_;
    cl::Buffer colour_, bounds_;
    rsh_frame_desc desc_{};
};

}  // namespace

std::string ManyFrames::case_name() const {
    return fmt::format("moving/frames:{}/triangles:{}/size:{}x{}", frames, triangles,
                       size.width, size.height);
}

nlohmann::json ManyFrames::params() const {
    return {{"frames", frames},
            {"triangles", triangles},
            {"width", size.width},
            {"height", size.height}};
}

Case measure(const Device& device, const ManyFrames& asked) {
    Frames frames(device, asked);
    std::vector<double> ms;
    double before = 0;
    for (size_t frame = 0; frame < asked.frames; ++frame) {
        ms.push_back(frames.render(0.05 * double(frame)));
        if (frame == asked.frames / 10) before = resident_kib();
    }
    const double grown = resident_kib() - before, first = ms[0];
    const Spread time = spread({ms.begin() + 2, ms.end()});
    return {asked.case_name(),
            asked.params(),
            {{"ms", time.median},
             {"ms_low", time.low},
             {"ms_high", time.high},
             {"first_ms", first},
             {"grown_kib", grown},
             {"is_within", grown <= kMostGrownKib}},
            true};
}

std::string as_text(const ManyFrames& asked, const Case& c) {
    const auto number = [&](const char* name) { return c.metrics.at(name).get<double>(); };
    return fmt::format(
        "{:.2f} ms a frame, the first one {:.0f}; {} frames grew by {:.0f} KiB: {}",
        number("ms"), number("first_ms"), asked.frames, number("grown_kib"),
        c.metrics.at("is_within").get<bool>() ? "within" : "beyond what is promised");
}

}  // namespace bench::moving
