#include "batches/batch_feed.hpp"

#include <algorithm>

#include "device/error.hpp"

namespace rsh {
namespace {

constexpr size_t kTurns = 2;
constexpr cl_uint kCorners = 3;

void check_filled(const rsh_batch& batch, cl_uint most) {
    if (batch.triangle_count < 1 || batch.triangle_count > most)
        throw Error(RSH_INVALID_VALUE, "batch.triangle_count: is ", batch.triangle_count,
                    ", must be 1 .. ", most, " from triangle ", batch.first_triangle, " on");
    if (batch.vertex_count > batch.vertex_capacity)
        throw Error(RSH_INVALID_VALUE, "batch.vertex_count: is ", batch.vertex_count,
                    ", must be at most ", batch.vertex_capacity);
}

}  // namespace

BatchFeed::BatchFeed(Recorder& recorder, const BatchNeeds& needs, const BatchMemory& memory,
                     BeforeBatch before_batch)
    : recorder_(recorder),
      source_(*needs.source),
      memory_(memory),
      before_batch_(std::move(before_batch)),
      positions_(array_of(memory.positions, 12, kCorners * memory.triangles)),
      indices_(array_of(memory.indices, 12, memory.triangles)),
      normals_(array_of(memory.normals, 12, kCorners * memory.triangles)),
      texcoords_(array_of(memory.texcoords, 8, kCorners * memory.triangles)),
      material_ids_(array_of(memory.material_ids, 4, memory.triangles)) {}

void BatchFeed::for_each(const UseBatch& use) {
    if (recorder_.only_notes()) return use(stand_in(), true);
    for (cl_uint first = 0; first < source_.triangle_count;) {
        before_batch_();
        const bool is_new = !whole_;
        const SceneBatch batch = whole_ ? *whole_ : next(first);
        use(batch, is_new);
        recorder_.flush();
        if (batch.geometry.triangle_count == source_.triangle_count) whole_ = batch;
        first += batch.geometry.triangle_count;
    }
}

BatchFeed::Array BatchFeed::array_of(cl_mem on_device, size_t bytes_per_item,
                                     cl_uint items) const {
    Array array = {on_device, bytes_per_item, {}};
    if (!on_device || recorder_.only_notes()) return array;
    for (size_t i = 0; i < kTurns; ++i) array.on_host.emplace_back(items * bytes_per_item);
    return array;
}

// NULL: the source is not to write it.
void* BatchFeed::filled(Array& array) const {
    if (!array.on_device) return nullptr;
    HostWrite& host = array.on_host[turn_];
    if (host.is_under_way()) recorder_.count([](rsh_statistics& sums) { ++sums.host_waits; });
    return host.filled_anew();
}

void BatchFeed::upload(Array& array, cl_uint items) {
    if (array.on_device && items)
        recorder_.write(RSH_STAGE_OTHER, array.on_host[turn_], array.on_device,
                        items * array.bytes_per_item);
}

SceneBatch BatchFeed::next(cl_uint first_triangle) {
    const rsh_batch filled = ask(first_triangle);
    upload(positions_, filled.vertex_count);
    upload(indices_, filled.triangle_count);
    upload(normals_, filled.vertex_count);
    upload(texcoords_, filled.vertex_count);
    upload(material_ids_, filled.triangle_count);
    turn_ = (turn_ + 1) % kTurns;
    return batch_of(filled);
}

rsh_batch BatchFeed::ask(cl_uint first_triangle) {
    rsh_batch batch = {};
    batch.struct_size = sizeof batch;
    batch.first_triangle = first_triangle;
    batch.triangle_capacity = memory_.triangles;
    batch.vertex_capacity = kCorners * memory_.triangles;
    batch.positions = static_cast<float*>(filled(positions_));
    batch.indices = static_cast<cl_uint*>(filled(indices_));
    batch.normals = static_cast<float*>(filled(normals_));
    batch.texcoords = static_cast<float*>(filled(texcoords_));
    batch.material_ids = static_cast<cl_uint*>(filled(material_ids_));
    rsh_batch answer = batch;
    if (source_.fill(&answer, source_.user))
        throw Error(RSH_CANCELLED, "batches.fill: asked to stop at triangle ", first_triangle);
    batch.triangle_count = answer.triangle_count;
    batch.vertex_count = answer.vertex_count;
    check_filled(batch, std::min(memory_.triangles, source_.triangle_count - first_triangle));
    return batch;
}

SceneBatch BatchFeed::batch_of(const rsh_batch& filled) const {
    SceneBatch batch = {filled.first_triangle, {}};
    batch.geometry.vertices = memory_.positions;
    batch.geometry.vertex_count = filled.vertex_count;
    batch.geometry.indices = memory_.indices;
    batch.geometry.triangle_count = filled.triangle_count;
    return batch;
}

// For a call that only notes its programs.
SceneBatch BatchFeed::stand_in() const {
    rsh_batch batch = {};
    batch.triangle_count = memory_.triangles;
    batch.vertex_count = kCorners * memory_.triangles;
    return batch_of(batch);
}

}  // namespace rsh
