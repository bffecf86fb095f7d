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

const NONE: u32 = 0xffffffffu;

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage> cells: array<u32>;
@group(0) @binding(2) var<storage> children: array<u32>;
@group(0) @binding(3) var<storage> finer: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> result: array<vec4<f32>>;

// Along one direction; nothing where there is no record.
fn voxel(record: u32, direction: u32) -> vec4<f32> {
    if (record == NONE) { return vec4<f32>(0.0); }
    return finer[record * 6u + direction];
}

fn over(front: vec4<f32>, back: vec4<f32>) -> vec4<f32> {
    let free = 1.0 - front.w;
    if (back.w <= free) { return front + back; }
    return front + back * (free / back.w);
}

fn pairs(front0: u32, back0: u32, front1: u32, back1: u32, front2: u32, back2: u32, front3: u32, back3: u32, d: u32) -> vec4<f32> {
    return 0.25 * (over(voxel(front0, d), voxel(back0, d)) + over(voxel(front1, d), voxel(back1, d)) +
        over(voxel(front2, d), voxel(back2, d)) + over(voxel(front3, d), voxel(back3, d)));
}

// Records of occupied voxels lie side by side.
fn record_of(bits: u32, k: u32, first: u32) -> u32 {
    return select(NONE, first + countOneBits(bits & ((1u << k) - 1u)), ((bits >> k) & 1u) == 1u);
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
    let a = record_of(bits, 0u, first);
    let b = record_of(bits, 1u, first);
    let c = record_of(bits, 2u, first);
    let d = record_of(bits, 3u, first);
    let e = record_of(bits, 4u, first);
    let f = record_of(bits, 5u, first);
    let g = record_of(bits, 6u, first);
    let h = record_of(bits, 7u, first);
    result[6u * record] = pairs(a, b, c, d, e, f, g, h, 0u);
    result[6u * record + 1u] = pairs(b, a, d, c, f, e, h, g, 1u);
    result[6u * record + 2u] = pairs(a, c, b, d, e, g, f, h, 2u);
    result[6u * record + 3u] = pairs(c, a, d, b, g, e, h, f, 3u);
    result[6u * record + 4u] = pairs(a, e, b, f, c, g, d, h, 4u);
    result[6u * record + 5u] = pairs(e, a, f, b, g, c, h, d, 5u);
}
