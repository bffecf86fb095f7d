//! Compiled kernels in a wgpu program of its own: a triangle is voxelized (`voxel_mark`, `voxel_union`) and its occupancy
//! mipmapped (`voxel_coarsen`). Of this crate it uses the manifest reader alone, of the others records and the grid's layout.

use interreflect::exec::manifest::Manifest;
use interreflect_kernels::voxel::{grid, tile::GridTriangle};
use interreflect_shared::{scene::SceneTriangle, voxel::FACET_KINDS, voxel::VoxelParams};
use wgpu::{BufferUsages as Usage, util::BufferInitDescriptor, util::DeviceExt};

struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    manifest: Manifest,
}

impl Gpu {
    fn buffer(&self, words: &[u32], usage: Usage) -> wgpu::Buffer {
        let contents = bytemuck::cast_slice(words);
        self.device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage: usage | Usage::COPY_DST })
    }

    fn storage(&self, words: &[u32]) -> wgpu::Buffer {
        self.buffer(words, Usage::STORAGE | Usage::COPY_SRC)
    }

    /// Runs a kernel; `buffers` are those after the uniform. Module, bindings and workgroups come from the manifest.
    fn run(&self, entry: &str, params: &VoxelParams, count: u32, buffers: &[&wgpu::Buffer]) -> anyhow::Result<()> {
        let kernel = self.manifest.kernel(entry)?;
        let source = wgpu::ShaderSource::SpirV(self.manifest.spirv(entry)?.into());
        let module = &self.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(entry), source });
        let pipeline = self.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(entry),
            layout: None,
            module,
            entry_point: Some(entry),
            compilation_options: Default::default(),
            cache: None,
        });
        let uniform = self.buffer(bytemuck::cast_slice(std::slice::from_ref(params)), Usage::UNIFORM);
        // The manifest lists bindings in the order of the declaration: the uniform first.
        let buffers = std::iter::once(&uniform).chain(buffers.iter().copied());
        let bound = buffers.zip(&kernel.bindings).map(|(buffer, b)| (b.binding, buffer.as_entire_binding()));
        let entries: Vec<_> = bound.map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
        let (label, layout) = (None, &pipeline.get_bind_group_layout(0));
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor { label, layout, entries: &entries });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &group, &[]);
        let [x, y, z] = self.manifest.workgroups(kernel, count);
        pass.dispatch_workgroups(x, y, z);
        drop(pass);
        self.queue.submit([encoder.finish()]);
        Ok(())
    }

    fn read(&self, buffer: &wgpu::Buffer) -> anyhow::Result<Vec<u32>> {
        let copy = self.buffer(&vec![0; buffer.size() as usize / 4], Usage::MAP_READ);
        let mut encoder = self.device.create_command_encoder(&Default::default());
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, buffer.size());
        self.queue.submit([encoder.finish()]);
        copy.slice(..).map_async(wgpu::MapMode::Read, |_| {});
        self.device.poll(wgpu::PollType::wait_indefinitely())?;
        Ok(bytemuck::pod_collect_to_vec(&copy.slice(..).get_mapped_range()?))
    }
}

fn main() -> anyhow::Result<()> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = pollster::block_on(instance.request_adapter(&Default::default()))?;
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;
    let gpu = Gpu { device, queue, manifest: Manifest::embedded()? };
    let (v0, v1, v2) = ([0.1, 0.2, 0.1], [0.9, 0.5, 0.2], [0.3, 0.6, 0.9]);
    let triangle = SceneTriangle { v0, material: 0, v1, flags: 0, v2, source: 0 };
    let mut params = grid::pyramid(glam::Vec3::ZERO, 1.0 / 64.0, glam::UVec3::splat(64));
    params.triangle_count = 1;

    // Voxelize: one invocation per tile of a triangle; its first tile is the 0th.
    let (triangles, first_tile) = (gpu.storage(bytemuck::cast_slice(&[triangle])), gpu.storage(&[0]));
    let facet_bits = gpu.storage(&vec![0; (params.levels[0].w * FACET_KINDS) as usize]);
    params.tile_count = GridTriangle::new(&params, &triangle).tiles();
    gpu.run("voxel_mark", &params, params.tile_count, &[&triangles, &first_tile, &facet_bits])?;

    // Mipmap: the levels of even and odd number lie in two buffers.
    let odd_cells = grid::cell_count(&params) - params.even_cells;
    let levels = [params.even_cells, odd_cells].map(|cells| gpu.storage(&vec![0; cells as usize]));
    for level in 0..params.dims_levels.w {
        let table = params.levels[level as usize];
        let first = table.z - (level & 1) * params.even_cells;
        let pass = VoxelParams { level, first, count: table.w, ..params };
        let (entry, source) = match level {
            0 => ("voxel_union", &facet_bits),
            _ => ("voxel_coarsen", &levels[1 - (level & 1) as usize]),
        };
        gpu.run(entry, &pass, table.w, &[source, &levels[(level & 1) as usize]])?;
        let cells = &gpu.read(&levels[(level & 1) as usize])?[first as usize..(first + table.w) as usize];
        println!("level {level}: {} occupied voxels", cells.iter().map(|word| word.count_ones()).sum::<u32>());
    }
    Ok(())
}
