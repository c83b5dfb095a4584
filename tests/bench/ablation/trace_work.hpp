// trace_work.hpp - rays through a mesh by rsh_trace, with the features that it is told.
#pragma once

#include <functional>

#include "ablation/work.hpp"
#include "stability/family.hpp"

namespace bench::ablation {

struct TraceSetup {
    cl_uint query = RSH_QUERY_CLOSEST;
    bool is_soup = false;         // without indices
    bool is_packed = false;       // rays as 6 floats each, without tmin and tmax
    bool has_normals = false;     // asked for
    bool has_ids = false;         // likewise
    bool is_list = false;         // not a grid
    bool has_list_count = false;  // how many rays the list has is on the device
    std::vector<rsh_mesh_range> ranges = {};
    std::vector<cl_uint> masks = {}, skip = {};  // per ray; empty: NULL
    cl_uint cull = RSH_CULL_NONE;
};

// The outputs of one call; those that nobody asks for are empty.
struct Traced {
    cl::Buffer hits, occlusion, counts, offsets, normals, ids;
};

class TraceWork final : public Work {
public:
    // most_hits: room of RSH_QUERY_ALL.
    TraceWork(const Device& device, const stability::Scene& scene, const TraceSetup& setup,
              size_t most_hits);

    void run(rsh_context context) override;
    void prepare(rsh_context context) const override;
    std::vector<uint8_t> answer() const override { return answer_of(traced_, rays()); }
    bool is_right(rsh_context context) const override;
    std::string programs() const override;

private:
    size_t rays() const { return size_t{desc_.width} * desc_.height; }
    void place(const test::Mesh& mesh);
    void place_rays(const std::vector<rsh_ray>& rays);
    Traced outputs_for(size_t rays, const std::function<cl::Buffer(size_t)>& make) const;
    void trace(rsh_context context, const rsh_trace_desc& desc) const;
    std::vector<uint8_t> answer_of(const Traced& traced, size_t rays) const;

    const TraceSetup setup_;
    const size_t most_hits_;
    cl::Buffer vertices_, indices_, ranges_, ray_buffer_, masks_, skip_, list_count_, scratch_;
    Traced traced_;
    rsh_trace_desc desc_{};
};

}  // namespace bench::ablation
