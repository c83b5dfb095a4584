/* shade.cl - this renderer's own shading of rsh's hits: interpolates its own vertices, lights them by its own
 * lamps where rsh found no shadow. The same model as rsh_shade's, without textures and spots, so that the
 * two can be compared; a renderer would write its own here. Compiled behind the text of rsh_types.h.
 */
typedef struct surface {
    float3 point, geometric, normal; /* the normals are unit, turned to the viewer */
} surface;

/* Six floats per vertex: position, normal. */
surface find_surface(__global const float* vertices, __global const uint* indices, rsh_hit hit,
                     float3 origin, float3 direction) {
    const uint3 corner = 2 * vload3(hit.primitive, indices);
    const float3 a = vload3(corner.x, vertices), b = vload3(corner.y, vertices),
                 c = vload3(corner.z, vertices);
    const float3 normal = fast_normalize(
        (1.0f - hit.u - hit.v) * vload3(corner.x + 1, vertices) +
        hit.u * vload3(corner.y + 1, vertices) + hit.v * vload3(corner.z + 1, vertices));
    const float3 geometric = cross(b - a, c - a);
    const float side = dot(geometric, direction) > 0.0f ? -1.0f : 1.0f;
    surface at;
    at.point = origin + hit.t * direction;
    at.geometric = side * geometric;
    at.normal = dot(normal, at.geometric) < 0.0f ? -normal : normal;
    return at;
}

/* base^exponent, by squares. */
float whole_power(float base, uint exponent) {
    float power = 1.0f;
    for (; exponent; exponent >>= 1, base *= base)
        if (exponent & 1) power *= base;
    return power;
}

/* Highlights have whole exponents: exp2 and log2 took half of this kernel's time. */
float3 light_sent_back(surface at, __global const rsh_material* material,
                       __global const rsh_light* light, float3 to_viewer) {
    const float3 path = light->position.xyz - at.point;
    const float3 to_light = fast_normalize(path);
    const float cosine = dot(at.normal, to_light);
    if (cosine <= 0.0f || dot(at.geometric, to_light) <= 0.0f) return (float3)(0.0f);
    const float distance = fast_length(path);
    const float4 fall = light->attenuation;
    const float share = 1.0f / (fall.x + distance * (fall.y + distance * fall.z));
    const float halfway = dot(at.normal, fast_normalize(to_light + to_viewer));
    const float highlight = whole_power(fmax(halfway, 0.0f), (uint)material->specular.w);
    return share * light->colour.xyz *
           (cosine * material->diffuse.xyz + highlight * material->specular.xyz);
}

/* count: how many rays there are, of `most`; NULL: all. weights NULL: all 1. */
__kernel void shade(uint most, __global const uint* count, __global const float* vertices,
                    __global const uint* indices, __global const uint* material_ids,
                    __global const rsh_ray* rays, __global const rsh_hit* hits,
                    __global const float4* weights, __global const uint* occlusion,
                    __global const rsh_material* materials, __global const rsh_light* lights,
                    uint light_count, float4 ambient, float4 environment,
                    __global float4* colour) {
    const uint i = get_global_id(0);
    if (i >= (count ? min(*count, most) : most)) return;
    const rsh_hit hit = hits[i];
    const bool is_hit = hit.primitive != RSH_NO_HIT;
    float3 seen = environment.xyz;
    if (is_hit) {
        const float3 direction = rays[i].direction_tmax.xyz;
        __global const rsh_material* material = materials + material_ids[hit.primitive];
        const surface at =
            find_surface(vertices, indices, hit, rays[i].origin_tmin.xyz, direction);
        seen = material->emission.xyz + material->ambient.xyz * ambient.xyz;
        for (uint k = 0; k < light_count; ++k)
            if (!(occlusion[i] >> k & 1))
                seen += light_sent_back(at, material, lights + k, -direction);
    }
    colour[i] = (float4)((weights ? weights[i].xyz : (float3)(1.0f)) * seen, is_hit);
}
