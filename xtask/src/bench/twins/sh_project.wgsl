struct Params { element_count: u32, sample_count: u32, order: u32, weight: f32 }

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage> basis: array<f32>;
@group(0) @binding(2) var<storage> radiance: array<f32>;
@group(0) @binding(3) var<storage, read_write> coefs: array<f32>;

// Four coefficients of three channels per invocation; elements in tiles of 64.
@compute @workgroup_size(64)
fn sh_project(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x + id.y * 2097152u;
    let bands = min(params.order, 9u) + 1u;
    let blocks = (bands * bands + 3u) / 4u;
    let tiles = (params.element_count + 63u) / 64u;
    let plane = tiles * blocks * 64u;
    if (i >= plane) { return; }

    let row = i / 64u;
    let tile = row / blocks;
    let block = row - tile * blocks;
    let samples = params.sample_count;
    let basis_plane = blocks * samples;
    var light = tile * samples * 192u + (i & 63u);
    var y_at = block * samples;
    var red = vec4<f32>(0.0);
    var green = vec4<f32>(0.0);
    var blue = vec4<f32>(0.0);
    for (var s = 0u; s < samples; s++) {
        let y = vec4<f32>(
            basis[y_at],
            basis[y_at + basis_plane],
            basis[y_at + 2u * basis_plane],
            basis[y_at + 3u * basis_plane],
        );
        red += radiance[light] * y;
        green += radiance[light + 64u] * y;
        blue += radiance[light + 128u] * y;
        light += 192u;
        y_at += 1u;
    }
    red *= params.weight;
    green *= params.weight;
    blue *= params.weight;
    coefs[i] = red.x;
    coefs[plane + i] = red.y;
    coefs[2u * plane + i] = red.z;
    coefs[3u * plane + i] = red.w;
    coefs[4u * plane + i] = green.x;
    coefs[5u * plane + i] = green.y;
    coefs[6u * plane + i] = green.z;
    coefs[7u * plane + i] = green.w;
    coefs[8u * plane + i] = blue.x;
    coefs[9u * plane + i] = blue.y;
    coefs[10u * plane + i] = blue.z;
    coefs[11u * plane + i] = blue.w;
}
