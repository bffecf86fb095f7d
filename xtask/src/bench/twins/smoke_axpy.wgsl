struct Params { count: u32, seed: u32, scale: f32, pad: u32 }

@group(0) @binding(0) var<uniform> params: Params;
@group(0) @binding(1) var<storage> x: array<f32>;
@group(0) @binding(2) var<storage> y: array<f32>;
@group(0) @binding(3) var<storage, read_write> result: array<f32>;

@compute @workgroup_size(64)
fn smoke_axpy(@builtin(global_invocation_id) id: vec3<u32>) {
    let i = id.x + id.y * 2097152u;
    if (i < arrayLength(&result)) {
        result[i] = params.scale * x[i] + y[i];
    }
}
