// frame_rows.cpp - what is measured, row by row.
#include "frame/frame_rows.hpp"

#include <fmt/format.h>

namespace bench {
namespace {

struct RoomSize {
    int64_t triangles;
    const char* name;
};
constexpr RoomSize kRooms[] = {{10000, "10k"},   {20000, "20k"},   {80000, "80k"},
                               {300000, "300k"}, {700000, "700k"}, {2300000, "2300k"}};

struct ReflectorKinds {
    Reflector reflector;
    const char* name;
    std::vector<RayKind> kinds;
};

const std::vector<ReflectorKinds>& reflectors() {
    using K = RayKind;
    static const std::vector<ReflectorKinds> all = {
        {Reflector::kSphere, "sphere", {K::kReflection, K::kShadow, K::kDiffuse}},
        {Reflector::kFloor, "floor", {K::kReflection, K::kShadow, K::kDiffuse, K::kShuffled}},
        {Reflector::kFloor45, "floor45", {K::kReflection, K::kShadow}},
        {Reflector::kSeveral, "several", {K::kReflection, K::kSecond}},
        {Reflector::kGlass, "glass", {K::kRefraction, K::kSecond}}};
    return all;
}

bool is_quick(Reflector reflector, int64_t triangles, Size size, RayKind kind) {
    if (size.width != 512) return false;
    if (triangles == 80000)
        return reflector == Reflector::kSphere ||
               (reflector == Reflector::kGlass && kind == RayKind::kRefraction);
    if (triangles == 700000)
        return reflector == Reflector::kFloor &&
               (kind == RayKind::kReflection || kind == RayKind::kShadow);
    return triangles == 20000 && reflector == Reflector::kFloor45 &&
           kind == RayKind::kReflection;
}

void add_room(std::vector<FrameRow>& rows, const ReflectorKinds& one, const RoomSize& room) {
    const SceneSpec scene = {fmt::format("room-{}-{}", one.name, room.name), one.reflector,
                             room.triangles, "", false};
    for (const cl_uint side : {512u, 1024u})
        for (const RayKind kind : one.kinds) {
            const Size size{side, side};
            rows.push_back(
                {scene, size, kind, is_quick(one.reflector, room.triangles, size, kind)});
        }
    // The series over the number of pixels.
    if (one.reflector == Reflector::kFloor && room.triangles == 80000)
        for (const cl_uint side : {128u, 256u, 2048u})
            rows.push_back({scene, {side, side}, RayKind::kReflection, false});
}

void add_file(std::vector<FrameRow>& rows, const char* name, bool is_rigid,
              const std::vector<RayKind>& kinds) {
    const SceneSpec scene = {name, Reflector::kFile, 0,
                             std::string(RSH_SCENE_FILES "/") + name + ".json", is_rigid};
    for (const cl_uint side : {512u, 1024u})
        for (const RayKind kind : kinds) rows.push_back({scene, {side, side}, kind, false});
}

// The query refuses a bound that the engine does not take.
bool takes(const Device& device, cl_uint engine, cl_uint bound) {
    rsh_traverse_desc desc{};
    desc.struct_size = sizeof desc;
    desc.geometry.vertex_count = 3;
    desc.geometry.triangle_count = 1;
    desc.width = 1;
    desc.engine = engine;
    desc.shape = bound;
    rsh_sizes sizes{};
    sizes.struct_size = sizeof sizes;
    return rsh_traverse_query(device.rsh(), &desc, &sizes) == RSH_SUCCESS;
}

}  // namespace

std::string FrameRow::name() const {
    return fmt::format("frame/scene:{}/size:{}x{}/rays:{}", scene.name, size.width, size.height,
                       name_of(rays));
}

std::vector<FrameRow> frame_rows() {
    using K = RayKind;
    std::vector<FrameRow> rows;
    for (const RoomSize& room : kRooms)
        for (const ReflectorKinds& one : reflectors()) add_room(rows, one, room);
    add_file(rows, "conference", false, {K::kReflection, K::kShadow, K::kDiffuse});
    add_file(rows, "kitchen", false,
             {K::kReflection, K::kRefraction, K::kShadow, K::kSecond, K::kDiffuse});
    add_file(rows, "museum5", false, {K::kReflection, K::kShadow, K::kSecond, K::kDiffuse});
    add_file(rows, "fox_run", false, {K::kReflection, K::kShadow});
    add_file(rows, "dragon_871k", true, {K::kReflection, K::kShadow, K::kDiffuse});
    add_file(rows, "large", true, {K::kReflection, K::kShadow});
    return rows;
}

std::vector<FrameRow> device_rows() {
    std::vector<FrameRow> rows;
    for (const cl_uint side : {512u, 1024u, 2048u, 4096u})
        for (const RoomSize& room : kRooms)
            if (room.triangles == 20000 || room.triangles >= 700000)
                rows.push_back({{fmt::format("room-floor-{}", room.name), Reflector::kFloor,
                                 room.triangles, "", false},
                                {side, side},
                                RayKind::kReflection,
                                true});
    return rows;
}

std::vector<Column> frame_columns(const Device& device) {
    std::vector<Column> columns;
    for (cl_uint engine = 1; rsh_engine_name(engine); ++engine)
        for (cl_uint bound = 1; rsh_shape_name(bound); ++bound)
            if (engine != RSH_ENGINE_BRUTE_FORCE && takes(device, engine, bound))
                columns.push_back(
                    {engine, bound, rsh_engine_name(engine), rsh_shape_name(bound)});
    columns.push_back({RSH_ENGINE_TILES, RSH_SHAPE_BOX, rsh_engine_name(RSH_ENGINE_TILES),
                       rsh_shape_name(RSH_SHAPE_BOX), true});
    return columns;
}

std::vector<Column> with_widths(const std::vector<Column>& columns,
                                const std::vector<cl_uint>& widths) {
    if (widths.empty()) return columns;
    std::vector<Column> all;
    for (const Column& column : columns)
        for (const cl_uint width : widths) {
            all.push_back(column);
            all.back().vector_width = width;
        }
    return all;
}

// A breadth-first stream of pairs of incoherent rays takes minutes per frame.
bool is_measured(const FrameRow& row, const Column& column) {
    const bool is_stream = column.engine_name.rfind("paper", 0) == 0;
    const bool is_coherent = row.rays != RayKind::kDiffuse && row.rays != RayKind::kShuffled;
    return !is_stream || is_coherent ||
           (row.size.width <= 512 && row.scene.triangles > 0 && row.scene.triangles <= 20000);
}

std::string case_name(const FrameRow& row, const Column& column) {
    return fmt::format("{}/{}", row.name(), column.name());
}

}  // namespace bench
