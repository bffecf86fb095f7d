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
    return finer[record * 6u + direction];
}

fn over(front: vec4<f32>, back: vec4<f32>) -> vec4<f32> {
    let free = 1.0 - front.w;
    if (back.w <= free) { return front + back; }
    return front + back * (free / back.w);
}

// Both ways along an axis: `step` is the distance of a pair's voxels, `a` to `d` are the four near voxels.
fn along(bits: u32, first: u32, axis: u32, step: u32, a: u32, b: u32, c: u32, d: u32, i: u32) {
    let forth = 2u * axis;
    let back = forth + 1u;
    result[6u * i + forth] = 0.25 * (
        over(voxel(bits, a, first, forth), voxel(bits, a + step, first, forth)) +
        over(voxel(bits, b, first, forth), voxel(bits, b + step, first, forth)) +
        over(voxel(bits, c, first, forth), voxel(bits, c + step, first, forth)) +
        over(voxel(bits, d, first, forth), voxel(bits, d + step, first, forth)));
    result[6u * i + back] = 0.25 * (
        over(voxel(bits, a + step, first, back), voxel(bits, a, first, back)) +
        over(voxel(bits, b + step, first, back), voxel(bits, b, first, back)) +
        over(voxel(bits, c + step, first, back), voxel(bits, c, first, back)) +
        over(voxel(bits, d + step, first, back), voxel(bits, d, first, back)));
}

@compute @workgroup_size(64)
fn voxel_mip(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x + id.y * 2097152u;
    if (i >= params.count) { return; }
    let record = params.first + i;
    let child = children[record];
    let shift = 8u * (child & 3u);
    let word = cells[2u * (child >> 2u)];
    let bits = word >> shift;
    let first = cells[2u * (child >> 2u) + 1u] + countOneBits(word & ((1u << shift) - 1u));
    along(bits, first, 0u, 1u, 0u, 2u, 4u, 6u, record);
    along(bits, first, 1u, 2u, 0u, 1u, 4u, 5u, record);
    along(bits, first, 2u, 4u, 0u, 1u, 2u, 3u, record);
}
