//! What `compare.json` and `report.json` hold. The names and types of the fields are an interface: other programs read
//! them. New fields may come; these stay.

use super::ReportError;
use crate::exec::DeviceInfo;
use crate::methods::{Phase, Settings};
use crate::metrics::{ErrorMetrics, NoiseFloor};
use crate::scene;
use serde::de::{MapAccess, Visitor};
use serde::ser::SerializeMap;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;
use std::marker::PhantomData;

/// `compare.json`: every method against one truth, from one run on one machine.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Comparison {
    /// Built-in name or path of the scene.
    pub scene: String,
    /// The camera.
    pub camera: Camera,
    /// Width and height of the pictures in pixels.
    pub size: [u32; 2],
    /// How good the truth is.
    pub truth: Truth,
    /// Where it ran.
    pub device: Device,
    /// One entry per method and setting.
    pub results: Vec<MethodResult>,
    /// What was simplified, dropped or made up when the scene was loaded.
    #[serde(default)]
    pub notes: Vec<String>,
    /// How the pictures were tone-mapped.
    #[serde(default)]
    pub tone_map: String,
    /// Largest resident memory of the whole run; 0 where the system does not say.
    #[serde(default)]
    pub peak_memory_bytes: u64,
    /// Version of this program.
    #[serde(default = "version")]
    pub version: String,
}

/// `report.json` of one render: one result with what it needs to be understood alone.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct RenderReport {
    /// Built-in name or path of the scene.
    pub scene: String,
    /// The camera.
    pub camera: Camera,
    /// Width and height of the pictures in pixels.
    pub size: [u32; 2],
    /// Where it ran.
    pub device: Device,
    /// The result; its fields stand beside the others. Its error is there when a truth was at hand.
    #[serde(flatten)]
    pub result: MethodResult,
    /// The truth that the error refers to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub truth: Option<Truth>,
    /// What was simplified, dropped or made up when the scene was loaded.
    #[serde(default)]
    pub notes: Vec<String>,
    /// How `full.png` was tone-mapped.
    #[serde(default)]
    pub tone_map: String,
    /// Largest resident memory of the whole run; 0 where the system does not say.
    #[serde(default)]
    pub peak_memory_bytes: u64,
    /// Version of this program.
    #[serde(default = "version")]
    pub version: String,
}

/// The version of this program, for the `version` fields.
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// A pinhole camera, enough to make the same picture elsewhere.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Camera {
    /// Name in the scene.
    pub name: String,
    /// Position in the world, metres.
    pub position: [f64; 3],
    /// Unit view direction.
    pub forward: [f64; 3],
    /// Unit up vector of the picture.
    pub up: [f64; 3],
    /// Vertical field of view in degrees.
    pub fovy_deg: f64,
}

impl Camera {
    /// What is told of a scene's camera.
    pub fn new(scene: &scene::Scene, camera: &scene::Camera) -> Self {
        let exact = |v: glam::Vec3| v.to_array().map(f64::from);
        Self {
            name: camera.name.clone(),
            position: scene.world(camera.position).to_array(),
            forward: exact(camera.forward),
            up: exact(camera.up),
            fovy_deg: f64::from(camera.fovy_rad).to_degrees(),
        }
    }
}

/// How good the truth is.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct Truth {
    /// Relative standard error of its indirect irradiance that it reached.
    pub noise: f64,
    /// Samples per pixel.
    pub spp: u64,
    /// Wall-clock time of rendering it, milliseconds (of the run that made it, if it came from the cache).
    pub ms: f64,
    /// What its noise adds to a perfect method's error.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub noise_floor: Option<NoiseFloor>,
}

/// Where it ran.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Device {
    /// `cpu`, `gpu` (SPIR-V through naga) or `gpu-passthrough`.
    pub backend: String,
    /// Adapter or processor.
    pub adapter: String,
    /// Driver and version, or vector instructions.
    pub driver: String,
    /// Processor and number of threads.
    pub cpu: String,
    /// False for software Vulkan and for the CPU.
    #[serde(default)]
    pub hardware_gpu: bool,
}

impl From<&DeviceInfo> for Device {
    fn from(info: &DeviceInfo) -> Self {
        Self {
            backend: info.backend.clone(),
            adapter: info.adapter.clone(),
            driver: info.driver.clone(),
            cpu: info.cpu.clone(),
            hardware_gpu: info.hardware_gpu,
        }
    }
}

/// One method with one set of settings.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct MethodResult {
    /// Name of the method.
    pub method: String,
    /// Name of this set of settings, where a method appears more than once.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub label: Option<String>,
    /// One sentence on what it is.
    #[serde(default)]
    pub summary: String,
    /// True for what is not a candidate but a yardstick: no indirect light, a fitted constant, the truth itself.
    #[serde(default)]
    pub control: bool,
    /// Parameters by name.
    pub settings: BTreeMap<String, Value>,
    /// What ran it.
    pub backend: String,
    /// Distance from the truth; absent where no truth was at hand or it was black.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<ErrorMetrics>,
    /// Median times.
    pub time_ms: TimeMs,
    /// Device memory.
    pub memory_bytes: MemoryBytes,
    /// What the method decided by itself (resolution, bounces, ranks…), an object.
    #[serde(default = "empty_object")]
    pub needs: Value,
}

impl MethodResult {
    /// Name for people: the method, with the label where it has one.
    pub fn title(&self) -> String {
        self.label.as_ref().map_or_else(|| self.method.clone(), |label| format!("{} {label}", self.method))
    }
}

fn empty_object() -> Value {
    Value::Object(serde_json::Map::new())
}

/// Settings as JSON: numbers and booleans as such, everything else as text.
pub fn settings_json(settings: &Settings) -> BTreeMap<String, Value> {
    let value = |text: &String| match serde_json::from_str(text) {
        Ok(value @ (Value::Number(_) | Value::Bool(_))) => value,
        _ => Value::String(text.clone()),
    };
    settings.iter().map(|(key, text)| (key.clone(), value(text))).collect()
}

/// Median times in milliseconds, each after warm-up.
#[derive(Clone, PartialEq, Default, Debug, Serialize, Deserialize)]
pub struct TimeMs {
    /// Once per geometry.
    pub precompute: f64,
    /// When lights or materials change.
    pub light_change: f64,
    /// Every frame.
    pub frame: f64,
    /// By stage, in the order in which they run.
    pub stages: Ordered<f64>,
    /// Phase of each stage: `precompute`, `light_change`, `frame`.
    #[serde(default)]
    pub stage_phases: Ordered<Phase>,
    /// Fastest and slowest counted run of each phase, where phases were repeated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spread: Option<TimeSpread>,
}

/// Fastest and slowest counted run of each phase, milliseconds.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct TimeSpread {
    /// Of precompute.
    pub precompute: [f64; 2],
    /// Of light change.
    pub light_change: [f64; 2],
    /// Of a frame.
    pub frame: [f64; 2],
}

impl TimeMs {
    /// Adds up stages by phase. A name that returns within a phase is summed; one that returns in another phase gets
    /// the phase added: `mipmap (frame)`.
    pub fn from_stages(stages: impl IntoIterator<Item = (Phase, String, f64)>) -> Self {
        let mut times = Self::default();
        for (phase, name, ms) in stages {
            let (total, suffix) = match phase {
                Phase::Precompute => (&mut times.precompute, " (precompute)"),
                Phase::LightChange => (&mut times.light_change, " (light change)"),
                Phase::Frame => (&mut times.frame, " (frame)"),
            };
            *total += ms;
            let name = match times.stage_phases.get(&name) {
                Some(other) if *other != phase => name + suffix,
                _ => name,
            };
            *times.stages.entry(&name) += ms;
            *times.stage_phases.entry(&name) = phase;
        }
        times
    }

    /// Time of a frame in which the lights move: light change and frame.
    pub fn dynamic_frame(&self) -> f64 {
        self.light_change + self.frame
    }

    /// Smallest and largest time of a frame in which the lights move.
    pub fn dynamic_spread(&self) -> Option<[f64; 2]> {
        self.spread.map(|s| [s.light_change[0] + s.frame[0], s.light_change[1] + s.frame[1]])
    }
}

/// Device memory in bytes.
#[derive(Clone, PartialEq, Default, Debug, Serialize, Deserialize)]
pub struct MemoryBytes {
    /// All buffers together.
    pub total: u64,
    /// By buffer, in order of creation; buffers of one name are summed.
    pub buffers: Ordered<u64>,
}

impl MemoryBytes {
    /// Adds up buffers.
    pub fn from_buffers(buffers: impl IntoIterator<Item = (String, u64)>) -> Self {
        let mut memory = Self::default();
        for (name, bytes) in buffers {
            memory.total += bytes;
            *memory.buffers.entry(&name) += bytes;
        }
        memory
    }
}

/// A JSON object whose keys keep their order.
#[derive(Clone, PartialEq, Debug)]
pub struct Ordered<T>(Vec<(String, T)>);

impl<T> Default for Ordered<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T> Ordered<T> {
    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&T> {
        self.iter().find(|(k, _)| *k == key).map(|(_, v)| v)
    }

    /// Keys and values in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &T)> {
        self.0.iter().map(|(k, v)| (k.as_str(), v))
    }

    /// Number of keys.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T: Default> Ordered<T> {
    /// The value of a key, made if it is not there.
    pub fn entry(&mut self, key: &str) -> &mut T {
        let k = self.0.iter().position(|(k, _)| k == key).unwrap_or_else(|| {
            self.0.push((key.to_string(), T::default()));
            self.0.len() - 1
        });
        &mut self.0[k].1
    }
}

impl<T> FromIterator<(String, T)> for Ordered<T> {
    /// Keys must differ.
    fn from_iter<I: IntoIterator<Item = (String, T)>>(iter: I) -> Self {
        Self(iter.into_iter().collect())
    }
}

impl<T: Serialize> Serialize for Ordered<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (key, value) in &self.0 {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Ordered<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Entries<T> {
            type Value = Ordered<T>;
            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("an object")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Ordered<T>, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Ordered(entries))
            }
        }
        deserializer.deserialize_map(Entries(PhantomData))
    }
}

/// Indented JSON with a final newline.
///
/// # Errors
/// [`ReportError::NotFinite`] with the path of the first number that is NaN or infinite (JSON has none, and a `null` in
/// its place would break readers far from the cause).
pub fn to_json<T: Serialize>(report: &T) -> Result<String, ReportError> {
    let value = serde_json::to_value(report).map_err(|e| ReportError::Json { reason: e.to_string() })?;
    if let Some(path) = find_null(&value, "") {
        return Err(ReportError::NotFinite { path });
    }
    let text = serde_json::to_string_pretty(&value).map_err(|e| ReportError::Json { reason: e.to_string() })?;
    Ok(text + "\n")
}

/// Path of the first `null`: what serde_json makes of a number that is not finite. No field of ours is null by intent;
/// in `needs` a method may write what it likes.
fn find_null(value: &Value, path: &str) -> Option<String> {
    match value {
        Value::Null => Some(path.to_string()),
        Value::Array(items) => items.iter().enumerate().find_map(|(k, v)| find_null(v, &format!("{path}[{k}]"))),
        Value::Object(fields) => fields.iter().filter(|(key, _)| *key != "needs").find_map(|(key, v)| {
            let dot = if path.is_empty() { "" } else { "." };
            find_null(v, &format!("{path}{dot}{key}"))
        }),
        _ => None,
    }
}
