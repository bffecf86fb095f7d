struct Params {
    origin_size: vec4<f32>,
    dims_levels: vec4<u32>,
    levels: array<vec4<u32>, 10>,
    cones: array<vec4<f32>, 16>,
    parts: array<vec4<f32>, 16>,
    beyond: vec4<f32>,
    camera: vec4<f32>,
    cone_count: u32, direction_count: u32, count: u32, seed: u32,
    spread: f32, offset: f32, clearance: f32, pad: f32,
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
    var front = vec4<f32>(0.0);
    var back = vec4<f32>(0.0);
    for (var f = first; f < first + count; f++) {
        let towards = -dot(looking, facets[f].normal);
        let a = radiance[2u * f].xyz;
        let b = radiance[2u * f + 1u].xyz;
        if (params.direction_count == 1u) {
            front += vec4<f32>(max(a, b), 1.0) * length(facets[f].normal);
        } else if (towards > 0.0) {
            front += vec4<f32>(a, 1.0) * towards;
        } else {
            back -= vec4<f32>(b, 1.0) * towards;
        }
    }
    if (back.w > front.w) { return front + back * ((back.w - front.w) / back.w); }
    return front;
}

// What a viewer who looks along an axis, or down it, sees of one voxel.
fn voxel(level: u32, cell: u32, bit: u32, word: u32, axis: u32, down: bool) -> vec4<f32> {
    let below = (1u << bit) - 1u;
    if (level == 0u) {
        var first = cells[2u * cell + 1u];
        var count = 0u;
        for (var kind = 0u; kind < 6u; kind++) {
            let bits = facet_bits[6u * cell + kind];
            first += countOneBits(bits & below);
            count += (bits >> bit) & 1u;
        }
        let axes = vec3<f32>(vec3<u32>(axis) == vec3<u32>(0u, 1u, 2u));
        let seen = facets_seen(first, count, select(axes, -axes, down));
        if (seen.w > 1.0) { return vec4<f32>(seen.xyz / seen.w, 1.0); }
        return seen;
    }
    let record = cells[2u * cell + 1u] + countOneBits(word & below);
    let i = select(6u * record + 2u * axis + u32(down), record, params.direction_count == 1u);
    if ((level & 1u) == 1u) { return odd[i]; }
    return even[i];
}

// The two voxels around a coordinate and their weights, zero outside the grid.
struct Tap { first: u32, second: u32, weights: vec2<f32> }

fn tap(x: f32, count: u32) -> Tap {
    let base = floor(x);
    let first = i32(base);
    let last = i32(count) - 1;
    var weight = select(0.0, x - base, first < last);
    if (first < 0) { weight = 1.0; }
    let inside = f32(x >= -0.5 && x <= f32(last) + 0.5);
    return Tap(u32(clamp(first, 0, last)), u32(clamp(first + 1, 0, last)), vec2<f32>(1.0 - weight, weight) * inside);
}

// Bilinear sample of a layer of voxels.
fn crossing(level: u32, axis: u32, layer: i32, down: bool, position: vec3<f32>) -> vec4<f32> {
    let level_table = params.levels[level];
    let dims = (params.dims_levels.xyz + ((1u << level) - 1u)) >> vec3<u32>(level);
    if (layer < 0 || layer >= i32(dims[axis])) { return vec4<f32>(0.0); }
    var x = position / f32(1u << level) - 0.5;
    x[axis] = f32(layer);
    let u = (axis + 1u) % 3u;
    let v = (axis + 2u) % 3u;
    let along_u = tap(x[u], dims[u]);
    let along_v = tap(x[v], dims[v]);
    var sum = vec4<f32>(0.0);
    for (var k = 0u; k < 4u; k++) {
        let weight = along_u.weights[k & 1u] * along_v.weights[k >> 1u];
        var at = vec3<u32>(u32(layer));
        at[u] = select(along_u.first, along_u.second, (k & 1u) == 1u);
        at[v] = select(along_v.first, along_v.second, k >= 2u);
        let cell = level_table.z + (at.x >> 2u) + level_table.x * (at.y >> 2u) + level_table.y * (at.z >> 1u);
        let bit = (at.x & 1u) | ((at.y & 1u) << 1u) | ((at.z & 1u) << 2u) | ((at.x & 2u) << 2u) | ((at.y & 2u) << 3u);
        let word = cells[2u * cell];
        if (weight > 0.0 && ((word >> bit) & 1u) == 1u) {
            sum += voxel(level, cell, bit, word, axis, down) * weight;
        }
    }
    return sum;
}

// The layers that a ray meets along one axis.
struct Layers { origin: f32, slope: f32, level: u32, next: i32, t: f32 }

fn find(layers: Layers, finest: u32) -> Layers {
    var l = layers;
    let count = i32((finest + (1u << l.level) - 1u) >> l.level);
    let outwards = select(l.next >= count, l.next < 0, l.slope < 0.0);
    let middle = (f32(l.next) + 0.5) * f32(1u << l.level);
    l.t = 3.4028235e38;
    if (!outwards && abs(l.slope) >= 1e-6) { l.t = (middle - l.origin) / l.slope; }
    return l;
}

fn start_layers(origin: f32, slope: f32, finest: u32) -> Layers {
    let next = select(i32(floor(origin - 0.5)) + 1, i32(ceil(origin - 0.5)) - 1, slope < 0.0);
    return find(Layers(origin, slope, 0u, next, 0.0), finest);
}

fn advance(layers: Layers, wanted: u32, finest: u32) -> Layers {
    var l = layers;
    let down = l.slope < 0.0;
    let at_border = ((l.next & 1) == 0) == down;
    l.next += select(1, -1, down);
    if (at_border && wanted > l.level) {
        l.level += 1u;
        l.next = l.next >> 1u;
    }
    return find(l, finest);
}

// Size of the voxels to read at a distance: the cone's width, or less near the surface that it leaves.
fn voxel_size(t: f32, spread: f32, clear: vec2<f32>) -> f32 {
    return max(min(spread * t, clear.x + clear.y * t), 1.0);
}

fn cone(origin: vec3<f32>, direction: vec3<f32>, spread: f32, clear: vec2<f32>) -> vec4<f32> {
    let slope = abs(direction);
    let main = select(select(2u, 1u, slope.y >= slope.z), 0u, slope.x >= slope.y && slope.x >= slope.z);
    let dims = params.dims_levels;
    var x = start_layers(origin.x, direction.x, dims.x);
    var y = start_layers(origin.y, direction.y, dims.y);
    var z = start_layers(origin.z, direction.z, dims.z);
    var light = vec3<f32>(0.0);
    var reaching = 1.0;
    var covered = 0.0;
    for (var k = 0u; k < 2048u; k++) {
        var axis = 2u;
        var layer = z;
        if (x.t <= y.t && x.t <= z.t) {
            axis = 0u;
            layer = x;
        } else if (y.t <= z.t) {
            axis = 1u;
            layer = y;
        }
        if (layer.t >= 3.4028235e38 || reaching * (1.0 - covered) < 1e-3) { break; }
        let seen = crossing(layer.level, axis, layer.next, layer.slope < 0.0, origin + direction * layer.t);
        if (seen.w > 0.0) {
            let fresh = min(seen.w, 1.0 - covered);
            light += seen.xyz * (reaching * fresh / seen.w);
            covered += fresh;
        } else if (axis == main) {
            reaching *= 1.0 - covered;
            covered = 0.0;
        }
        let wide = voxel_size(layer.t, spread, clear) * 1.4142135;
        let wanted = min((bitcast<u32>(wide) >> 23u) - 127u, dims.w - 1u);
        if (axis == 0u) {
            x = advance(x, wanted, dims.x);
        } else if (axis == 1u) {
            y = advance(y, wanted, dims.y);
        } else {
            z = advance(z, wanted, dims.z);
        }
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
