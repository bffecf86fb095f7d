struct Params {
    origin_size: vec4<f32>,
    dims_levels: vec4<u32>,
    levels: array<vec4<u32>, 10>,
    triangle_count: u32, tile_count: u32, facet_count: u32, direction_count: u32,
    area_scale: f32, emission_scale: f32, emission_weight: f32, even_cells: u32,
    level: u32, first: u32, count: u32, pad: u32,
    environment: vec4<f32>,
    light: vec4<u32>,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage> cells: array<u32>;
@group(0) @binding(2) var<storage> children: array<u32>;
@group(0) @binding(3) var<storage> finer: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> result: array<vec4<f32>>;

// The k-th of eight voxels: records of occupied voxels lie side by side.
fn voxel(bits: u32, k: u32, first: u32, direction: u32) -> vec4<f32> {
    if (((bits >> k) & 1u) == 0u) { return vec4<f32>(0.0); }
    let record = first + countOneBits(bits & ((1u << k) - 1u));
    return finer[record * params.direction_count + direction];
}

fn over(front: vec4<f32>, back: vec4<f32>) -> vec4<f32> {
    let free = 1.0 - front.w;
    if (back.w <= free) { return front + back; }
    return front + back * (free / back.w);
}

fn pair(a: vec4<f32>, b: vec4<f32>, reversed: bool) -> vec4<f32> {
    if (reversed) { return over(b, a); }
    return over(a, b);
}

@compute @workgroup_size(64)
fn voxel_mip(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x + id.y * 2097152u;
    if (i >= params.count) { return; }
    let element = params.first + i;
    let record = element / params.direction_count;
    let direction = element - record * params.direction_count;

    let child = children[record];
    let shift = 8u * (child & 3u);
    let word = cells[2u * (child >> 2u)];
    let bits = word >> shift;
    let first = cells[2u * (child >> 2u) + 1u] + countOneBits(word & ((1u << shift) - 1u));
    let v0 = voxel(bits, 0u, first, direction);
    let v1 = voxel(bits, 1u, first, direction);
    let v2 = voxel(bits, 2u, first, direction);
    let v3 = voxel(bits, 3u, first, direction);
    let v4 = voxel(bits, 4u, first, direction);
    let v5 = voxel(bits, 5u, first, direction);
    let v6 = voxel(bits, 6u, first, direction);
    let v7 = voxel(bits, 7u, first, direction);

    var value: vec4<f32>;
    if (params.direction_count == 1u) {
        value = 0.25 * (((v0 + v1) + (v2 + v3)) + ((v4 + v5) + (v6 + v7)));
        if (value.w > 1.0) { value = value / value.w; }
    } else {
        let back = (direction & 1u) == 1u;
        switch (direction >> 1u) {
            case 0u: { value = pair(v0, v1, back) + pair(v2, v3, back) + pair(v4, v5, back) + pair(v6, v7, back); }
            case 1u: { value = pair(v0, v2, back) + pair(v1, v3, back) + pair(v4, v6, back) + pair(v5, v7, back); }
            default: { value = pair(v0, v4, back) + pair(v1, v5, back) + pair(v2, v6, back) + pair(v3, v7, back); }
        }
        value *= 0.25;
    }
    result[element] = value;
}
