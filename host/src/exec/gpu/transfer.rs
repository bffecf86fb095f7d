//! Staging buffers and the device's clock, made once and used again.

/// Largest piece that is copied back at once, in bytes.
const MAX_STAGING_BYTES: u64 = 64 << 20;
/// Smallest staging buffer, in bytes.
const MIN_STAGING_BYTES: u64 = 64 << 10;

/// A buffer that the host can read, grown when needed.
#[derive(Default)]
pub(super) struct Readback(Option<wgpu::Buffer>);

impl Readback {
    /// Size of the staging buffer.
    pub(super) fn bytes(&self) -> u64 {
        self.0.as_ref().map_or(0, wgpu::Buffer::size)
    }

    /// A staging buffer for `bytes`, or for a piece of them where they are many.
    pub(super) fn staging(&mut self, device: &wgpu::Device, bytes: u64) -> wgpu::Buffer {
        let size = bytes.clamp(MIN_STAGING_BYTES, MAX_STAGING_BYTES).next_power_of_two();
        match &self.0 {
            Some(buffer) if buffer.size() >= size => buffer.clone(),
            _ => self.0.insert(staging_buffer(device, size)).clone(),
        }
    }
}

fn staging_buffer(device: &wgpu::Device, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("readback"),
        size,
        usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// The device's own timestamps at the start and the end of a stage.
pub(super) struct DeviceClock {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    staging: wgpu::Buffer,
    ns_per_tick: f64,
}

const TIMESTAMPS_BYTES: u64 = 16;

impl DeviceClock {
    /// A clock where the device has one.
    pub(super) fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Option<Self> {
        let ns_per_tick = f64::from(queue.get_timestamp_period());
        if !device.features().contains(wgpu::Features::TIMESTAMP_QUERY) || ns_per_tick <= 0.0 {
            return None;
        }
        Some(Self {
            queries: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("stage"),
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            }),
            resolved: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: TIMESTAMPS_BYTES,
                usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
            staging: staging_buffer(device, TIMESTAMPS_BYTES),
            ns_per_tick,
        })
    }

    /// Records the stage's start: after all that was recorded before.
    pub(super) fn start(&self, encoder: &mut wgpu::CommandEncoder) {
        self.stamp(encoder, 0);
    }

    /// Records the stage's end and gives the buffer that will hold both timestamps.
    pub(super) fn stop(&self, encoder: &mut wgpu::CommandEncoder) -> wgpu::Buffer {
        self.stamp(encoder, 1);
        encoder.resolve_query_set(&self.queries, 0..2, &self.resolved, 0);
        encoder.copy_buffer_to_buffer(&self.resolved, 0, &self.staging, 0, TIMESTAMPS_BYTES);
        self.staging.clone()
    }

    /// An empty pass: the one place where every adapter with timestamps can take one.
    fn stamp(&self, encoder: &mut wgpu::CommandEncoder, index: u32) {
        drop(encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: None,
            timestamp_writes: Some(wgpu::ComputePassTimestampWrites {
                query_set: &self.queries,
                beginning_of_pass_write_index: (index == 0).then_some(0),
                end_of_pass_write_index: (index == 1).then_some(1),
            }),
        }));
    }

    /// Milliseconds between two timestamps; nothing where the driver did not write them.
    pub(super) fn milliseconds(&self, timestamps: &[u8]) -> Option<f64> {
        let ticks: Vec<u64> = timestamps.as_chunks::<8>().0.iter().map(|&t| u64::from_le_bytes(t)).collect();
        let elapsed = ticks[1].checked_sub(ticks[0]).filter(|_| ticks[0] != 0)?;
        Some(elapsed as f64 * self.ns_per_tick * 1e-6)
    }
}
