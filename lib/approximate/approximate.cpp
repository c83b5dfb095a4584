#include "approximate/approximate.hpp"

#include "mesh/mesh.hpp"
#include "shade/wave.hpp"

namespace rsh {
namespace {

KernelName kernel(const char* name) {
    return {"programs/approximate", name};
}

wave_part cells_of(const pixel_grid& grid) {
    return whole_wave(grid.columns, grid.rows);
}

}  // namespace

pixel_grid grid_of(cl_uint width, cl_uint height, cl_uint step) {
    return {width, height, step, (width + step - 1) / step, (height + step - 1) / step};
}

void take_pixels(Recorder& recorder, const PixelPass& pass) {
    recorder.launch(RSH_STAGE_OTHER, kernel("rsh_take_pixels"),
                    recorder.stream_range(pass.count), pass.grid, pass.pixels, pass.count,
                    pass.screen_rays, pass.screen_hits, pass.rays, pass.hits);
}

void put_pixels(Recorder& recorder, const PixelPass& pass) {
    recorder.launch(RSH_STAGE_OTHER, kernel("rsh_put_pixels"),
                    recorder.stream_range(pass.count), pass.grid, pass.pixels, pass.count,
                    pass.colour, pass.picture);
}

void blend_pixels(Recorder& recorder, const BlendPass& pass) {
    const rsh_scene& scene = *pass.scene;
    const wave_part cells = cells_of(pass.grid);
    recorder.launch(RSH_STAGE_SHADE, kernel("rsh_blend_pixels"),
                    recorder.stream_range(cells.count), mesh_view_of(scene), scene.material_ids,
                    scene.material_count, pass.grid, cells, pass.tolerance, pass.hits,
                    pass.picture, pass.listed);
}

cl_uint listed_words(const pixel_grid& grid) {
    return RSH_BESIDES * cells_of(grid).count;
}

}  // namespace rsh
