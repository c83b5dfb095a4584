#include "moving/object_in_room.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <ctime>

#include "frame/rsh_tracer.hpp"
#include "timing.hpp"

namespace bench::moving {
namespace {

constexpr double kMostBoundRatio = 1.5, kMostBoundMs = 0.15, kMostTraverseRatio = 1.15;

// A torus of 2 * rings^2 triangles about the place that the room leaves free.
void add_object(render::Mesh& mesh, int64_t triangles) {
    const auto rings = static_cast<uint32_t>(std::lround(std::sqrt(double(triangles) / 2)));
    const auto first = static_cast<uint32_t>(mesh.positions.size());
    const double turn = 2 * std::acos(-1.0) / rings;
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t k = 0; k < rings; ++k) {
            const double around = 0.7 + 0.25 * std::cos(turn * k);
            mesh.positions.emplace_back(around * std::cos(turn * i),
                                        1.2 + around * std::sin(turn * i),
                                        0.25 * std::sin(turn * k));
            if (!mesh.normals.empty()) mesh.normals.emplace_back(0.0f);
        }
    const auto at = [&](uint32_t i, uint32_t k) {
        return first + i % rings * rings + k % rings;
    };
    for (uint32_t i = 0; i < rings; ++i)
        for (uint32_t k = 0; k < rings; ++k) {
            mesh.triangles.emplace_back(at(i, k), at(i + 1, k), at(i + 1, k + 1));
            mesh.triangles.emplace_back(at(i, k), at(i + 1, k + 1), at(i, k + 1));
            mesh.material_ids.insert(mesh.material_ids.end(), 2, 0);
        }
}

struct Room {
    size_t still_vertices, still_triangles;
    FrameScene scene;
};

Room make_scene(const ObjectInRoom& asked) {
    StillScene still = make_still_room({"room", Reflector::kSphere, asked.still, "", false});
    const size_t vertices = still.mesh.positions.size(),
                 triangles = still.mesh.triangles.size();
    add_object(still.mesh, asked.moving);
    return {vertices, triangles, FrameScene(std::move(still), vertices)};
}

rsh_geometry with_still(rsh_geometry geometry, size_t triangles) {
    geometry.still_triangles = static_cast<cl_uint>(triangles);
    return geometry;
}

rsh_geometry without(rsh_geometry geometry, size_t triangles) {
    geometry.indices_offset += triangles * sizeof(glm::uvec3);
    geometry.triangle_count -= static_cast<cl_uint>(triangles);
    return geometry;
}

Column kept_tiles() {
    return {RSH_ENGINE_TILES, RSH_SHAPE_BOX, rsh_engine_name(RSH_ENGINE_TILES),
            rsh_shape_name(RSH_SHAPE_BOX), true};
}

// Times of two ways, round by round.
struct Pair {
    std::vector<double> ms, base_ms, cpu, base_cpu;

    static Spread ratio(const std::vector<double>& of, const std::vector<double>& base) {
        std::vector<double> ratios;
        for (size_t i = 0; i < of.size(); ++i) ratios.push_back(of[i] / base[i]);
        return spread(ratios);
    }
};

double cpu_ms(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
}

class Measured {
public:
    Measured(const Device& device, const ObjectInRoom& asked)
        : room_(make_scene(asked)),
          scene_(device, room_.scene),
          rays_(device, asked.size),
          both_(device, with_still(scene_.geometry(), room_.still_triangles), asked.size,
                RSH_QUERY_CLOSEST, kept_tiles()),
          one_(device, scene_.geometry(), asked.size, RSH_QUERY_CLOSEST, kept_tiles()),
          alone_(device, without(scene_.geometry(), room_.still_triangles), asked.size,
                 RSH_QUERY_CLOSEST, kept_tiles()) {
        for (RshTracer* tracer : {&both_, &one_, &alone_}) tracer->allocate();
        for (RshTracer* tracer : {&both_, &one_, &alone_}) tracer->bound();
    }

    // Whoever comes first finds cold caches, so they take turns.
    void run_round(size_t round) {
        scene_.move(0.1 * double(round));
        rays_.make(scene_, RayKind::kReflection);
        for (const size_t turn : {round, round + 1}) {
            let_threads_sleep();
            if (turn % 2)
                add_bound(alone_, bound_.base_ms, bound_.base_cpu);
            else
                add_bound(both_, bound_.ms, bound_.cpu);
        }
        for (const size_t turn : {round, round + 1}) {
            let_threads_sleep();
            if (turn % 2)
                add_traversal(one_, traverse_.base_ms, traverse_.base_cpu);
            else
                add_traversal(both_, traverse_.ms, traverse_.cpu);
        }
    }

    size_t count_differing() const {
        const std::vector<rsh_hit> hits = both_.hits(), expected = one_.hits();
        size_t count = 0;
        for (size_t i = 0; i < hits.size(); ++i)
            count += std::memcmp(&hits[i], &expected[i], sizeof hits[i]) != 0;
        return count;
    }

    const Pair& bounds() const { return bound_; }
    const Pair& traversals() const { return traverse_; }

private:
    static void add_bound(RshTracer& tracer, std::vector<double>& ms,
                          std::vector<double>& cpu) {
        cpu.push_back(cpu_ms([&] { ms.push_back(tracer.bound()); }));
    }

    void add_traversal(RshTracer& tracer, std::vector<double>& ms, std::vector<double>& cpu) {
        const double bound = cpu_ms([&] { tracer.bound(); });
        const double frame =
            cpu_ms([&] { ms.push_back(tracer.trace(rays_.buffer()).traverse); });
        cpu.push_back(frame - bound);  // with the nodes over the rays, the same for both
    }

    Room room_;
    SceneOnDevice scene_;
    RayMaker rays_;
    RshTracer both_, one_, alone_;
    Pair bound_, traverse_;
};

void add_ratio(nlohmann::json& metrics, const std::string& name, const Spread& ratio) {
    metrics[name] = ratio.median;
    metrics[name + "_low"] = ratio.low;
    metrics[name + "_high"] = ratio.high;
}

bool is_within(const nlohmann::json& metrics) {
    const double bound = metrics.at("bound_ms"), alone = metrics.at("alone_ms");
    return (metrics.at("bound_ratio") <= kMostBoundRatio || bound - alone <= kMostBoundMs) &&
           metrics.at("traverse_ratio") <= kMostTraverseRatio;
}

nlohmann::json times_of(const Pair& bounds, const Pair& traversals) {
    nlohmann::json metrics = {{"bound_ms", spread(bounds.ms).median},
                              {"alone_ms", spread(bounds.base_ms).median},
                              {"traverse_ms", spread(traversals.ms).median},
                              {"one_tree_ms", spread(traversals.base_ms).median}};
    add_ratio(metrics, "bound_ratio", Pair::ratio(bounds.ms, bounds.base_ms));
    add_ratio(metrics, "traverse_ratio", Pair::ratio(traversals.ms, traversals.base_ms));
    metrics["bound_cpu_ratio"] = Pair::ratio(bounds.cpu, bounds.base_cpu).median;
    metrics["traverse_cpu_ratio"] = Pair::ratio(traversals.cpu, traversals.base_cpu).median;
    metrics["is_within"] = is_within(metrics);
    return metrics;
}

}  // namespace

std::string ObjectInRoom::case_name() const {
    return fmt::format("moving/still:{}/moving:{}/size:{}x{}", still, moving, size.width,
                       size.height);
}

nlohmann::json ObjectInRoom::params() const {
    return {
        {"still", still}, {"moving", moving}, {"width", size.width}, {"height", size.height}};
}

Case measure(const Device& device, const ObjectInRoom& asked) {
    Measured measured(device, asked);
    size_t differ = 0;
    for (size_t round = 0; round < asked.rounds; ++round) {
        measured.run_round(round);
        if (round == 0 || round + 1 == asked.rounds) differ += measured.count_differing();
    }
    Case done = {asked.case_name(), asked.params(), {{"differ", differ}}, differ == 0};
    if (done.ok) done.metrics.update(times_of(measured.bounds(), measured.traversals()));
    return done;
}

std::string as_text(const ObjectInRoom&, const Case& c) {
    const nlohmann::json& m = c.metrics;
    if (!c.ok) return fmt::format("{} hits differ", m.at("differ").get<size_t>());
    const auto number = [&](const char* name) { return m.at(name).get<double>(); };
    return fmt::format(
        "bounds {:.3f} ms, the object alone {:.3f} (ratio {:.2f}, of CPU time {:.2f}); "
        "traversal "
        "{:.2f} ms, one tree {:.2f} (ratio {:.2f}, of CPU time {:.2f}): {}",
        number("bound_ms"), number("alone_ms"), number("bound_ratio"),
        number("bound_cpu_ratio"), number("traverse_ms"), number("one_tree_ms"),
        number("traverse_ratio"), number("traverse_cpu_ratio"),
        m.at("is_within").get<bool>() ? "within" : "beyond what is promised");
}

}  // namespace bench::moving
