struct Params {
    origin_size: vec4<f32>,
    dims_levels: vec4<u32>,
    levels: array<vec4<u32>, 10>,
    cones: array<vec4<f32>, 16>,
    beyond: vec4<f32>,
    camera: vec4<f32>,
    cone_count: u32, direction_count: u32, count: u32, seed: u32,
    spread: f32, step: f32, offset: f32, clearance: f32,
}
struct Facet {
    position: vec3<f32>, area: f32,
    normal: vec3<f32>, voxel: u32,
    albedo: vec3<f32>, pad0: u32,
    emission: vec3<f32>, pad1: u32,
}
struct Surfel {
    position: vec3<f32>, primitive: u32,
    normal: vec3<f32>, distance: f32,
    geometric_normal: vec3<f32>, front: u32,
    albedo: vec3<f32>, material: u32,
    emission: vec3<f32>, error: f32,
}

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage> cells: array<u32>;
@group(0) @binding(2) var<storage> facet_bits: array<u32>;
@group(0) @binding(3) var<storage> facets: array<Facet>;
@group(0) @binding(4) var<storage> radiance: array<vec4<f32>>;
@group(0) @binding(5) var<storage> odd: array<vec4<f32>>;
@group(0) @binding(6) var<storage> even: array<vec4<f32>>;
@group(0) @binding(7) var<storage> surfels: array<Surfel>;
@group(0) @binding(8) var<storage, read_write> result: array<vec4<f32>>;

fn facets_seen(first: u32, count: u32, looking: vec3<f32>) -> vec4<f32> {
    if (params.direction_count == 1u) {
        var sum = vec4<f32>(0.0);
        for (var f = first; f < first + count; f++) {
            sum += vec4<f32>(max(radiance[2u * f].xyz, radiance[2u * f + 1u].xyz), 1.0) * length(facets[f].normal);
        }
        return sum;
    }
    var front = vec4<f32>(0.0);
    var back = vec4<f32>(0.0);
    for (var f = first; f < first + count; f++) {
        let towards = -dot(looking, facets[f].normal);
        if (towards > 0.0) {
            front += vec4<f32>(radiance[2u * f].xyz, 1.0) * towards;
        } else {
            back -= vec4<f32>(radiance[2u * f + 1u].xyz, 1.0) * towards;
        }
    }
    if (back.w > front.w) { return front + back * ((back.w - front.w) / back.w); }
    return front;
}

fn record(level: u32, i: u32) -> vec4<f32> {
    if ((level & 1u) == 1u) { return odd[i]; }
    return even[i];
}

fn voxel(level: u32, cell: u32, bit: u32, word: u32, looking: vec3<f32>) -> vec4<f32> {
    let below = (1u << bit) - 1u;
    if (level == 0u) {
        var first = cells[2u * cell + 1u];
        var count = 0u;
        for (var kind = 0u; kind < 6u; kind++) {
            let bits = facet_bits[6u * cell + kind];
            first += countOneBits(bits & below);
            count += (bits >> bit) & 1u;
        }
        return facets_seen(first, count, looking);
    }
    let i = cells[2u * cell + 1u] + countOneBits(word & below);
    if (params.direction_count == 1u) { return record(level, i); }
    let at = 6u * i;
    return record(level, at + u32(looking.x < 0.0)) * abs(looking.x)
        + record(level, at + 2u + u32(looking.y < 0.0)) * abs(looking.y)
        + record(level, at + 4u + u32(looking.z < 0.0)) * abs(looking.z);
}

// Trilinear sample of one level.
fn sample_level(level: u32, position: vec3<f32>, looking: vec3<f32>) -> vec4<f32> {
    let level_table = params.levels[level];
    let dims = vec3<i32>((params.dims_levels.xyz + ((1u << level) - 1u)) >> vec3<u32>(level));
    let x = position / f32(1u << level) - 0.5;
    let base = floor(x);
    let fraction = x - base;
    let corner = vec3<i32>(base);
    var sum = vec4<f32>(0.0);
    for (var k = 0u; k < 8u; k++) {
        let step = vec3<u32>(k & 1u, (k >> 1u) & 1u, k >> 2u);
        let at = corner + vec3<i32>(step);
        if (any(at < vec3<i32>(0)) || any(at >= dims)) { continue; }
        let share = select(1.0 - fraction, fraction, step == vec3<u32>(1u));
        let weight = share.x * share.y * share.z;
        let v = vec3<u32>(at);
        let cell = level_table.z + (v.x >> 2u) + level_table.x * (v.y >> 2u) + level_table.y * (v.z >> 1u);
        let bit = (v.x & 1u) | ((v.y & 1u) << 1u) | ((v.z & 1u) << 2u) | ((v.x & 2u) << 2u) | ((v.y & 2u) << 3u);
        let word = cells[2u * cell];
        if (weight > 0.0 && ((word >> bit) & 1u) == 1u) {
            sum += voxel(level, cell, bit, word, looking) * weight;
        }
    }
    return sum;
}

// Between the two levels whose voxels are nearest to a footprint.
fn sample_pyramid(position: vec3<f32>, size: f32, looking: vec3<f32>) -> vec4<f32> {
    let exponent = i32(bitcast<u32>(size) >> 23u) - 127;
    let coarsest = params.dims_levels.w - 1u;
    let level = min(u32(max(exponent, 0)), coarsest);
    let unit = 1.0 / f32(1u << level);
    let fraction = size * unit - 1.0;
    if (level == coarsest || fraction <= 0.0) { return sample_level(level, position, looking) * unit; }
    let coarse = sample_level(level + 1u, position, looking);
    if (coarse.w <= 0.0) { return vec4<f32>(0.0); }
    let fine = sample_level(level, position, looking);
    return fine * ((1.0 - fraction) * unit) + coarse * (fraction * 0.5 * unit);
}

fn leave(origin: f32, direction: f32, size: f32) -> f32 {
    if (abs(direction) < 1e-9) { return 3.4e38; }
    return (select(0.0, size, direction > 0.0) - origin) / direction;
}

fn leave_box(origin: vec3<f32>, direction: vec3<f32>, size: vec3<f32>) -> f32 {
    let x = leave(origin.x, direction.x, size.x);
    let y = leave(origin.y, direction.y, size.y);
    let z = leave(origin.z, direction.z, size.z);
    return max(min(min(x, y), z), 0.0);
}

// Size of the voxels to read at a distance: the cone's width, or less near the surface that it leaves.
fn voxel_size(t: f32, spread: f32, clear: vec2<f32>) -> f32 {
    return max(min(spread * t, clear.x + clear.y * t), 1.0);
}

fn cone(origin: vec3<f32>, direction: vec3<f32>, spread: f32, clear: vec2<f32>) -> vec4<f32> {
    let size = vec3<f32>(params.dims_levels.xyz);
    let margin = 1.5 * voxel_size(leave_box(origin, direction, size), spread, clear);
    let end = leave_box(origin + margin, direction, size + 2.0 * margin);
    var light = vec3<f32>(0.0);
    var reaching = 1.0;
    var covered = 0.0;
    var t = 0.0;
    for (var k = 0u; k < 2048u; k++) {
        if (t >= end || reaching * (1.0 - covered) < 1e-3) { break; }
        let length = params.step * voxel_size(t, spread, clear);
        let middle = t + 0.5 * length;
        let seen = sample_pyramid(origin + direction * middle, voxel_size(middle, spread, clear), direction);
        let coverage = seen.w * length;
        if (coverage > 0.0) {
            let fresh = min(coverage, 1.0 - covered);
            light += seen.xyz * (length * reaching * fresh / coverage);
            covered += fresh;
        } else {
            reaching *= 1.0 - covered;
            covered = 0.0;
        }
        t += length;
    }
    return vec4<f32>(light, reaching * (1.0 - covered));
}

@compute @workgroup_size(64)
fn cone_glossy(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x + id.y * 2097152u;
    if (i >= arrayLength(&result)) { return; }
    let surfel = surfels[i];
    if (surfel.primitive == 0xffffffffu) {
        result[i] = vec4<f32>(0.0);
        return;
    }
    let to_viewer = normalize(params.camera.xyz - surfel.position);
    let mirrored = reflect(-to_viewer, surfel.normal);
    let start = (surfel.position - params.origin_size.xyz) / params.origin_size.w + surfel.geometric_normal * params.offset;
    let rise = max(dot(mirrored, surfel.geometric_normal), 0.0);
    let found = cone(start, mirrored, 2.0 * params.camera.w, params.clearance * vec2<f32>(params.offset, rise));
    result[i] = vec4<f32>(found.xyz + params.beyond.xyz * found.w, found.w);
}
