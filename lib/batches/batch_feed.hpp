// batch_feed.hpp - brings the batches of a scene to the device, one after the other: the source fills memory
// of the host's while the device works on the batch before.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "batches/batch_memory.hpp"
#include "batches/seen_triangles.hpp"
#include "device/cl/recorder.hpp"
#include "device/objects/host_write.hpp"

namespace rsh {

class BatchFeed {
public:
    // Called before each batch; throws to stop.
    using BeforeBatch = std::function<void()>;
    // is_new: it was not there before, so that its bounds are to be made.
    using UseBatch = std::function<void(const SceneBatch& batch, bool is_new)>;

    BatchFeed(Recorder& recorder, const BatchNeeds& needs, const BatchMemory& memory,
              BeforeBatch before_batch);

    // Once through the scene. A batch that is all of it stays where it is. BLOCKS, see rsh_batch_source.
    void for_each(const UseBatch& use);

private:
    // An array of a batch: two pieces of the host's memory, filled in turn, and one of the device's.
    struct Array {
        cl_mem on_device;
        size_t bytes_per_item;
        std::vector<HostWrite> on_host;
    };
    Array array_of(cl_mem on_device, size_t bytes_per_item, cl_uint items) const;
    void* filled(Array& array) const;
    void upload(Array& array, cl_uint items);

    SceneBatch next(cl_uint first_triangle);
    SceneBatch stand_in() const;
    rsh_batch ask(cl_uint first_triangle);
    SceneBatch batch_of(const rsh_batch& filled) const;

    Recorder& recorder_;
    const rsh_batch_source& source_;
    const BatchMemory memory_;
    const BeforeBatch before_batch_;
    Array positions_, indices_, normals_, texcoords_, material_ids_;
    size_t turn_ = 0;
    std::optional<SceneBatch> whole_;  // on the device: all of the scene
};

}  // namespace rsh
