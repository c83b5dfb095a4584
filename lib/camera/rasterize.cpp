#include "camera/rasterize.hpp"

#include <algorithm>

#include "camera/screen.hpp"
#include "device/cl/scratch.hpp"
#include "mesh/mesh.hpp"

namespace rsh {
namespace {

constexpr cl_uint kMaxRanges = 64;       // 4 bytes per tile each: little beside rays and hits
constexpr cl_uint kRangesPerUnit = 4;    // ranges are unequal work: several per compute unit
constexpr cl_uint kMinRangeLength = 64;  // triangles

// Room by default: small triangles touch 1 to 4 tiles, and a few in each range cover
// everything.
constexpr cl_ulong kEntriesPerTriangle = 4;
constexpr cl_ulong kEntriesPerTile = 4;

constexpr cl_ulong kMaxCapacity =
    0x7fffffff;  // the top bit is RSH_UNLISTED of camera/rasterize.cl

bool is_simt(const Context& context) {
    return context.vector_width == 1;
}

// A SIMT device's work-group is a tile; elsewhere a work-item is.
cl_uint tile_side(const Context& context) {
    if (!is_simt(context)) return 16;
    cl_uint side = 8;
    while (size_t{side} * side > context.caps.max_group_size) side /= 2;
    return side;
}

cl_uint ceil_divide(cl_uint a, cl_uint b) {
    return a / b + (a % b != 0);
}

void set_tiles(screen_setup& screen, const Context& context, const rsh_rasterize_desc& desc) {
    screen.width = desc.width;
    screen.height = desc.height;
    screen.first_x = desc.window.x;
    screen.first_y = desc.window.y;
    screen.picture_width = picture_side(desc.window.picture_width, desc.width);
    screen.picture_height = picture_side(desc.window.picture_height, desc.height);
    screen.tile_columns = ceil_divide(desc.width, tile_side(context));
    screen.tile_count = screen.tile_columns * ceil_divide(desc.height, tile_side(context));
}

void set_ranges(screen_setup& screen, const Context& context, cl_uint triangle_count) {
    screen.triangle_count = triangle_count;
    if (triangle_count == 0) return;
    const cl_uint units = std::min(kMaxRanges, context.caps.compute_units);
    const cl_uint wanted =
        is_simt(context) ? kMaxRanges : std::min(kMaxRanges, kRangesPerUnit * units);
    const cl_uint most = std::min(wanted, ceil_divide(triangle_count, kMinRangeLength));
    screen.range_length = ceil_divide(triangle_count, most);
    screen.range_count = ceil_divide(triangle_count, screen.range_length);
}

// More than a list of everything for every tile is of no use.
void set_capacity(screen_setup& screen, const Context& context, size_t budget) {
    if (screen.range_count == 0) return;
    const cl_ulong length = screen.range_length, tiles = screen.tile_count;
    const cl_ulong usual = kEntriesPerTriangle * length + kEntriesPerTile * tiles;
    const cl_ulong wanted = budget ? budget / sizeof(cl_uint) / screen.range_count : usual;
    const cl_ulong affordable =
        context.caps.max_allocation / 2 / sizeof(cl_uint) / screen.range_count;
    screen.capacity =
        static_cast<cl_uint>(std::min({wanted, length * tiles, affordable, kMaxCapacity}));
}

screen_setup screen_of(const Context& context, const rsh_rasterize_desc& desc) {
    screen_setup screen = {};
    set_camera(screen, desc.camera);
    set_tiles(screen, context, desc);
    set_ranges(screen, context, desc.geometry.triangle_count);
    set_capacity(screen, context, desc.scratch_budget);
    return screen;
}

Layout layout_of(const Context& context, const screen_setup& screen) {
    const size_t ranges = screen.range_count;
    Layout layout(context.caps.alignment);
    layout.add_array<cl_ushort4>("boxes", screen.triangle_count);
    layout.add_array<cl_uint>("ends", ranges * screen.tile_count);
    layout.add_array<cl_uint>("lists", ranges * screen.capacity);
    return layout;
}

}  // namespace

Layout rasterize_scratch(const Context& context, const rsh_rasterize_desc& desc) {
    return layout_of(context, screen_of(context, desc));
}

void rasterize(Recorder& recorder, const rsh_rasterize_desc& desc) {
    const Context& context = recorder.context();
    const screen_setup screen = screen_of(context, desc);
    const Scratch scratch(recorder, layout_of(context, screen), desc.scratch);
    const rsh_geometry& geometry = desc.geometry;
    const mesh_view mesh = mesh_view_of(geometry);
    const cl_uint side = tile_side(context);
    const size_t items_per_tile = is_simt(context) ? size_t{side} * side : 1;
    const auto kernel = [side](const char* name) {
        return KernelName{"camera/rasterize", name, "-D RSH_TILE=" + std::to_string(side)};
    };
    recorder.launch(RSH_STAGE_RASTERIZE, kernel("rsh_rasterize_project"),
                    recorder.stream_range(geometry.triangle_count), screen, mesh,
                    geometry.vertices, geometry.indices, scratch["boxes"]);
    recorder.launch(RSH_STAGE_RASTERIZE, kernel("rsh_rasterize_bin"), {screen.range_count, 1},
                    screen, scratch["boxes"], scratch["ends"], scratch["lists"]);
    recorder.launch(RSH_STAGE_RASTERIZE, kernel("rsh_rasterize_tiles"),
                    {screen.tile_count * items_per_tile, items_per_tile}, screen, mesh,
                    geometry.vertices, geometry.indices, scratch["boxes"], scratch["ends"],
                    scratch["lists"], desc.rays, desc.hits);
}

}  // namespace rsh
