//! The bake file: one [safetensors](https://github.com/huggingface/safetensors) file that people can open elsewhere.
//!
//! Tensors have the names of [`SrpBake`]'s fields. Lists of lists lie one after the other, with `*_first` telling where each
//! begins. The matrices of clusters are 16-bit floats (SL17 §4.1); all else is 32 bits. Metadata: version, `scene`
//! (SHA-256 of the scene's geometry and materials, lights left out: they may change), and `sha256` of all tensors.
//!
//! [`Journal`] is the file beside it while it is being baked (`FILE.part`): every finished cluster, so that an
//! interrupted bake goes on where it stopped.

use super::atlas::{Atlas, Lookup, Texel};
use super::charts::Charts;
use super::model::{Blend, Cluster, FREE, Loss, NO_RECEIVER, RAY_INVALID, Receiver, SrpBake};
use super::orders::LeftOut;
use super::plan::{BakeOptions, ClusterOutput};
use super::round_trip::Verdict;
use super::transport::Rays;
use crate::image_io::replace_file;
use crate::scene::Scene;
use glam::{Vec2, Vec3};
use half::f16;
use safetensors::tensor::{Dtype, SafeTensors, TensorView};
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// The one key of the file's metadata; its value is `version N; scene HASH; sha256 HASH`. (One, because several would
/// be written in a random order: the same bake must give the same bytes.)
const KEY: &str = "interreflect-srp";
/// Version of the layout; a file of another one is refused.
pub const VERSION: u32 = 3;

/// Why a bake file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum BakeFileError {
    /// It cannot be read or written.
    #[error("cannot access the bake file {path}: {source}")]
    Io {
        /// File.
        path: PathBuf,
        /// The system's words.
        source: std::io::Error,
    },
    /// It is no bake file, or one that was cut short.
    #[error("{path} is no bake file, or was cut short: {reason}")]
    Format {
        /// File.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// Another version of this program made it.
    #[error("the bake file {path} has version {got}, this program reads version {expected}: bake it again")]
    Version {
        /// File.
        path: PathBuf,
        /// Its version.
        got: String,
        /// The version wanted.
        expected: u32,
    },
    /// Its content is not what was written.
    #[error("the bake file {path} is damaged: its checksum does not fit its content")]
    Checksum {
        /// File.
        path: PathBuf,
    },
    /// It belongs to another scene.
    #[error("the bake file {path} belongs to another scene (or this one has changed), not to `{scene}`: bake it again")]
    WrongScene {
        /// File.
        path: PathBuf,
        /// The scene at hand.
        scene: String,
    },
}

/// SHA-256 of what a bake depends on: geometry, materials and textures.
pub fn scene_hash(scene: &Scene) -> [u8; 32] {
    Scene { lights: Vec::new(), environment: Vec3::ZERO, ..scene.clone() }.content_hash()
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

/// Tensors on their way to a file.
#[derive(Default)]
struct Tensors(BTreeMap<String, (Dtype, Vec<usize>, Vec<u8>)>);

impl Tensors {
    fn add<T: bytemuck::NoUninit>(&mut self, name: &str, dtype: Dtype, shape: &[usize], data: &[T]) {
        self.0.insert(name.into(), (dtype, shape.to_vec(), bytemuck::cast_slice(data).to_vec()));
    }

    fn f32(&mut self, name: &str, width: usize, data: &[f32]) {
        self.add(name, Dtype::F32, &[data.len() / width.max(1), width], data);
    }

    fn u32(&mut self, name: &str, width: usize, data: &[u32]) {
        self.add(name, Dtype::U32, &[data.len() / width.max(1), width], data);
    }

    fn vectors(&mut self, name: &str, data: impl Iterator<Item = Vec3>) {
        let flat: Vec<f32> = data.flat_map(|v| v.to_array()).collect();
        self.f32(name, 3, &flat);
    }

    /// A list of lists.
    fn lists<T: bytemuck::NoUninit>(&mut self, name: &str, dtype: Dtype, lists: impl Iterator<Item = Vec<T>>) {
        let (mut first, mut all) = (vec![0u64], Vec::new());
        for list in lists {
            all.extend(list);
            first.push(all.len() as u64);
        }
        self.add(&format!("{name}_first"), Dtype::U64, &[first.len()], &first);
        self.add(name, dtype, &[all.len()], &all);
    }

    /// SHA-256 over names, types, shapes and contents.
    fn checksum(&self) -> String {
        checksum(
            self.0
                .iter()
                .map(|(name, (dtype, shape, data))| (name.as_str(), *dtype, shape.as_slice(), data.as_slice())),
        )
    }
}

fn checksum<'a>(tensors: impl Iterator<Item = (&'a str, Dtype, &'a [usize], &'a [u8])>) -> String {
    let mut hash = Sha256::new();
    for (name, dtype, shape, data) in tensors {
        hash.update(format!("{name} {dtype:?} {shape:?} {}\n", data.len()));
        hash.update(data);
    }
    hex(&hash.finalize())
}

/// Writes a bake; the file appears whole or not at all.
///
/// # Errors
/// [`BakeFileError::Io`].
pub fn save(path: &Path, bake: &SrpBake, atlas: &Atlas, scene: &Scene) -> Result<(), BakeFileError> {
    let tensors = tensors(bake, atlas);
    let about = format!("version {VERSION}; scene {}; sha256 {}", hex(&scene_hash(scene)), tensors.checksum());
    let metadata = HashMap::from([(KEY.to_string(), about)]);
    let format = |e: safetensors::SafeTensorError| BakeFileError::Format { path: path.into(), reason: e.to_string() };
    let mut views = Vec::new();
    for (name, (dtype, shape, data)) in &tensors.0 {
        views.push((name.as_str(), TensorView::new(*dtype, shape.clone(), data).map_err(format)?));
    }
    let bytes = safetensors::serialize(views, Some(metadata)).map_err(format)?;
    replace_file(path, &bytes).map_err(|source| BakeFileError::Io { path: path.into(), source })
}

fn tensors(bake: &SrpBake, atlas: &Atlas) -> Tensors {
    let mut t = Tensors::default();
    let r = &bake.receivers;
    t.u32("numbers", 1, &[bake.order, bake.rows_per_receiver, bake.atlas_size[0], bake.atlas_size[1]]);
    t.f32("lengths", 1, &[bake.radius, atlas.texel_size]);
    t.vectors("receiver_position", r.iter().map(|r| r.position));
    t.vectors("receiver_normal", r.iter().map(|r| r.normal));
    t.vectors("receiver_geometric_normal", r.iter().map(|r| r.geometric_normal));
    t.vectors("receiver_albedo", r.iter().map(|r| r.albedo));
    t.vectors("receiver_emission", r.iter().map(|r| r.emission));
    t.f32("receiver_error_area", 2, &r.iter().flat_map(|r| [r.error, r.area]).collect::<Vec<_>>());
    t.u32("receiver_triangle_front", 2, &r.iter().flat_map(|r| [r.triangle, u32::from(r.front)]).collect::<Vec<_>>());
    t.u32("texel", 2, bake.texel.as_flattened());
    t.u32("dilation_texel", 2, &bake.dilation.iter().flat_map(|d| d.0).collect::<Vec<_>>());
    t.u32("dilation_receivers", 4, &bake.dilation.iter().flat_map(|d| d.1.receivers).collect::<Vec<_>>());
    t.f32("dilation_weights", 4, &bake.dilation.iter().flat_map(|d| d.1.weights).collect::<Vec<_>>());
    t.vectors("probes", bake.probes.iter().copied());
    t.vectors("ray_directions", bake.ray_directions.iter().copied());
    t.u32("ray_hits", bake.ray_directions.len(), &bake.ray_hits);
    t.f32("sky", 1, &bake.sky);
    let c = &bake.clusters;
    t.u32("cluster_receivers", 2, &c.iter().flat_map(|c| [c.receivers.start, c.receivers.end]).collect::<Vec<_>>());
    t.u32("cluster_rank", 1, &c.iter().map(|c| c.rank).collect::<Vec<_>>());
    let loss = |c: &Cluster| [c.loss.transport, c.loss.light, c.loss.noise];
    t.f32("cluster_loss", 3, &c.iter().flat_map(loss).collect::<Vec<_>>());
    t.lists("cluster_probes", Dtype::U32, c.iter().map(|c| c.probes.clone()));
    t.lists("cluster_columns", Dtype::U32, c.iter().map(|c| c.columns.iter().flat_map(|c| [c.0, c.1]).collect()));
    t.lists("cluster_projection", Dtype::F16, c.iter().map(|c| halves(&c.projection)));
    t.lists("cluster_reconstruction", Dtype::F16, c.iter().map(|c| halves(&c.reconstruction)));
    let corners: Vec<f32> = atlas.charts.corners.iter().flatten().flat_map(|p| p.to_array()).collect();
    t.f32("lightmap_corners", 6, &corners);
    t.u32("lightmap_chart", 1, &atlas.charts.chart);
    let sides: Vec<u32> = atlas.sides().iter().map(|s| u32::from(s[0]) | u32::from(s[1]) << 1).collect();
    t.u32("lightmap_sides", 1, &sides);
    t.u32("lightmap_layer", 1, &[atlas.charts.size[0], atlas.charts.size[1], u32::from(atlas.charts.from_file)]);
    t
}

/// Bits of 16-bit floats.
fn halves(values: &[f32]) -> Vec<u16> {
    values.iter().map(|v| f16::from_f32(*v).to_bits()).collect()
}

/// Reads a bake of a scene.
///
/// # Errors
/// Every variant of [`BakeFileError`]; nothing in a file makes this panic.
pub fn load(path: &Path, scene: &Scene) -> Result<(SrpBake, Lookup), BakeFileError> {
    let io = |source| BakeFileError::Io { path: path.into(), source };
    let format = |reason: String| BakeFileError::Format { path: path.into(), reason };
    let mut bytes = Vec::new();
    File::open(path).and_then(|mut f| f.read_to_end(&mut bytes)).map_err(io)?;
    let (_, header) = SafeTensors::read_metadata(&bytes).map_err(|e| format(e.to_string()))?;
    let file = SafeTensors::deserialize(&bytes).map_err(|e| format(e.to_string()))?;
    let Some(about) = header.metadata().as_ref().and_then(|m| m.get(KEY)) else {
        return Err(format("it is another safetensors file".into()));
    };
    let entries: HashMap<&str, &str> = about.split("; ").filter_map(|entry| entry.split_once(' ')).collect();
    let text = |key: &str| entries.get(key).map_or(String::new(), |v| v.to_string());
    if text("version") != VERSION.to_string() {
        return Err(BakeFileError::Version { path: path.into(), got: text("version"), expected: VERSION });
    }
    let all: BTreeMap<String, TensorView<'_>> = file.tensors().into_iter().collect();
    let sum = checksum(all.iter().map(|(name, v)| (name.as_str(), v.dtype(), v.shape(), v.data())));
    if sum != text("sha256") {
        return Err(BakeFileError::Checksum { path: path.into() });
    }
    if text("scene") != hex(&scene_hash(scene)) {
        return Err(BakeFileError::WrongScene { path: path.into(), scene: scene.name.clone() });
    }
    let (bake, atlas) = Reader(&all).read(scene).ok_or_else(|| format("its tensors do not fit together".into()))?;
    let order: Vec<u32> = bake
        .receivers
        .iter()
        .enumerate()
        .map(|(i, r)| if r.triangle == FREE { NO_RECEIVER } else { i as u32 })
        .collect();
    Ok((bake, Lookup::new(Arc::new(atlas), &order)))
}

/// Typed access to tensors; `None` wherever something is missing or out of range.
struct Reader<'a>(&'a BTreeMap<String, TensorView<'a>>);

impl Reader<'_> {
    fn data<T: bytemuck::AnyBitPattern>(&self, name: &str, dtype: Dtype) -> Option<Vec<T>> {
        let tensor = self.0.get(name).filter(|t| t.dtype() == dtype)?;
        // Tensors start wherever the header ends: copied, not cast.
        let words = tensor.data().chunks_exact(size_of::<T>());
        Some(words.map(bytemuck::pod_read_unaligned).collect())
    }

    fn u32(&self, name: &str) -> Option<Vec<u32>> {
        self.data(name, Dtype::U32)
    }

    fn f32(&self, name: &str) -> Option<Vec<f32>> {
        let values: Vec<f32> = self.data(name, Dtype::F32)?;
        values.iter().all(|v| v.is_finite()).then_some(values)
    }

    fn vectors(&self, name: &str) -> Option<Vec<Vec3>> {
        Some(self.f32(name)?.chunks_exact(3).map(Vec3::from_slice).collect())
    }

    fn lists<T: bytemuck::AnyBitPattern + Copy>(&self, name: &str, dtype: Dtype) -> Option<Vec<Vec<T>>> {
        let first: Vec<u64> = self.data(&format!("{name}_first"), Dtype::U64)?;
        let all: Vec<T> = self.data(name, dtype)?;
        first.windows(2).map(|w| all.get(w[0] as usize..w[1] as usize).map(<[T]>::to_vec)).collect()
    }

    fn matrices(&self, name: &str) -> Option<Vec<Vec<f32>>> {
        let lists = self.lists::<u16>(name, Dtype::F16)?;
        Some(lists.into_iter().map(|l| l.into_iter().map(|h| f16::from_bits(h).to_f32()).collect()).collect())
    }

    fn read(&self, scene: &Scene) -> Option<(SrpBake, Atlas)> {
        let &[order, rows, width, height] = self.u32("numbers")?.as_slice() else { return None };
        let &[radius, texel_size] = self.f32("lengths")?.as_slice() else { return None };
        let bake = SrpBake {
            order,
            rows_per_receiver: rows,
            receivers: self.receivers()?,
            texel: self.u32("texel")?.chunks_exact(2).map(|t| [t[0], t[1]]).collect(),
            atlas_size: [width, height],
            dilation: self.dilation()?,
            probes: self.vectors("probes")?,
            radius,
            ray_directions: self.vectors("ray_directions")?,
            ray_hits: self.u32("ray_hits")?,
            sky: self.f32("sky")?,
            clusters: self.clusters()?,
        };
        let atlas = self.atlas(&bake, texel_size)?;
        (order <= 9 && (rows == 1 || rows == 4) && fits(&bake, &atlas, scene)).then_some((bake, atlas))
    }

    fn receivers(&self) -> Option<Vec<Receiver>> {
        let [position, normal, geometric, albedo, emission] =
            ["position", "normal", "geometric_normal", "albedo", "emission"]
                .map(|n| self.vectors(&format!("receiver_{n}")));
        let (position, normal, geometric, albedo, emission) = (position?, normal?, geometric?, albedo?, emission?);
        let (lengths, words) = (self.f32("receiver_error_area")?, self.u32("receiver_triangle_front")?);
        let receiver = |i: usize| {
            Some(Receiver {
                position: position[i],
                normal: *normal.get(i)?,
                geometric_normal: *geometric.get(i)?,
                error: *lengths.get(2 * i)?,
                triangle: *words.get(2 * i)?,
                front: *words.get(2 * i + 1)? == 1,
                area: *lengths.get(2 * i + 1)?,
                albedo: *albedo.get(i)?,
                emission: *emission.get(i)?,
            })
        };
        (0..position.len()).map(receiver).collect()
    }

    fn dilation(&self) -> Option<Vec<([u32; 2], Blend)>> {
        let (at, receivers) = (self.u32("dilation_texel")?, self.u32("dilation_receivers")?);
        let weights = self.f32("dilation_weights")?;
        let entry = |i: usize| {
            let blend = Blend {
                receivers: receivers.get(4 * i..4 * i + 4)?.try_into().ok()?,
                weights: weights.get(4 * i..4 * i + 4)?.try_into().ok()?,
            };
            Some(([at[2 * i], at[2 * i + 1]], blend))
        };
        (0..at.len() / 2).map(entry).collect()
    }

    fn clusters(&self) -> Option<Vec<Cluster>> {
        let (ranges, rank) = (self.u32("cluster_receivers")?, self.u32("cluster_rank")?);
        let (probes, columns) =
            (self.lists::<u32>("cluster_probes", Dtype::U32)?, self.lists::<u32>("cluster_columns", Dtype::U32)?);
        let (projection, reconstruction) =
            (self.matrices("cluster_projection")?, self.matrices("cluster_reconstruction")?);
        let loss = self.f32("cluster_loss")?;
        let lengths =
            [ranges.len() / 2, loss.len() / 3, probes.len(), columns.len(), projection.len(), reconstruction.len()];
        if lengths.iter().any(|l| *l != rank.len()) {
            return None;
        }
        let mut lists = probes.into_iter().zip(columns).zip(projection.into_iter().zip(reconstruction));
        let cluster = |i: usize| {
            let ((probes, columns), (projection, reconstruction)) = lists.next()?;
            Some(Cluster {
                receivers: ranges[2 * i]..ranges[2 * i + 1],
                probes,
                columns: columns.chunks_exact(2).map(|c| (c[0], c[1])).collect(),
                rank: rank[i],
                projection,
                reconstruction,
                loss: Loss { transport: loss[3 * i], light: loss[3 * i + 1], noise: loss[3 * i + 2] },
            })
        };
        (0..rank.len()).map(cluster).collect()
    }

    fn atlas(&self, bake: &SrpBake, texel_size: f32) -> Option<Atlas> {
        let &[width, height, from_file] = self.u32("lightmap_layer")?.as_slice() else { return None };
        let corners = self.f32("lightmap_corners")?;
        let corner = |c: &[f32]| [Vec2::new(c[0], c[1]), Vec2::new(c[2], c[3]), Vec2::new(c[4], c[5])];
        let chart = self.u32("lightmap_chart")?;
        let sides: Vec<[bool; 2]> = self.u32("lightmap_sides")?.iter().map(|s| [s & 1 == 1, s & 2 == 2]).collect();
        let charts = Charts {
            size: [width, height],
            corners: corners.chunks_exact(6).map(corner).collect(),
            count: sides.len() as u32,
            from_file: from_file == 1,
            chart,
        };
        let texel = |(r, at): (&Receiver, &[u32; 2])| {
            let chart = if r.triangle == FREE { 0 } else { *charts.chart.get(r.triangle as usize)? };
            Some(Texel { at: *at, chart, receiver: *r })
        };
        let texels = bake.receivers.iter().zip(&bake.texel).map(texel).collect::<Option<Vec<_>>>()?;
        Some(Atlas::from_parts(charts, bake.atlas_size, texel_size, texels, sides))
    }
}

/// Whether every index is in range and every length is what the others say: a checksum is no proof of sense.
fn fits(bake: &SrpBake, atlas: &Atlas, scene: &Scene) -> bool {
    let count = bake.receivers.len();
    let (width, height) = (bake.atlas_size[0], bake.atlas_size[1]);
    let lists = bake.texel.len() == count
        && bake.sky.len() == count
        && bake.ray_hits.len() == bake.probes.len() * bake.ray_directions.len()
        && atlas.charts.corners.len() == scene.triangles.len()
        && atlas.charts.chart.len() == scene.triangles.len()
        && u64::from(width) * u64::from(height) <= 1 << 28
        && width == atlas.charts.size[0]
        && (height == atlas.charts.size[1] || Some(height) == atlas.charts.size[1].checked_mul(2));
    let hits = bake.ray_hits.iter().all(|h| (*h as usize) < count || *h >= RAY_INVALID);
    let charts = atlas.charts.chart.iter().all(|c| *c < atlas.charts.count);
    let inside = |at: &[u32; 2]| at[0] < width && at[1] < height;
    let texels = bake.receivers.iter().zip(&bake.texel).all(|(r, at)| r.triangle == FREE || inside(at));
    let blends = bake
        .dilation
        .iter()
        .all(|(at, b)| inside(at) && b.receivers.iter().all(|r| (*r as usize) < count || *r == NO_RECEIVER));
    let mut next = 0;
    let k = bake.coefficient_count() as u32;
    let clusters = bake.clusters.iter().all(|c| {
        let follows = c.receivers.start == next && c.receivers.end >= next;
        next = c.receivers.end;
        let height = c.receivers.len() * bake.rows_per_receiver as usize;
        let rank = c.rank as usize;
        let projection = if c.projection.is_empty() {
            rank == c.columns.len() || rank == 0
        } else {
            c.projection.len() == rank * c.columns.len()
        };
        follows
            && projection
            && c.reconstruction.len() == height * rank
            && c.probes.iter().all(|p| (*p as usize) < bake.probes.len())
            && c.columns.iter().all(|(slot, coefficient)| (*slot as usize) < c.probes.len() && *coefficient < k)
    });
    lists && hits && charts && texels && blends && clusters && next as usize == count
}

/// Finished clusters of an unfinished bake.
pub struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

impl Journal {
    /// Opens the journal of a bake (`FILE.part`), and gives what it holds: clusters that were finished before an
    /// interruption. One of another scene, of other settings or damaged from its start on is begun anew; a record that was
    /// cut short is dropped.
    ///
    /// # Errors
    /// [`BakeFileError::Io`].
    pub fn open(
        target: &Path,
        scene: &Scene,
        options: &BakeOptions,
    ) -> Result<(Self, BTreeMap<usize, ClusterOutput>), BakeFileError> {
        let mut name = target.as_os_str().to_owned();
        name.push(".part");
        let path = PathBuf::from(name);
        let io = |source| BakeFileError::Io { path: path.clone(), source };
        let mut file = File::options().read(true).write(true).create(true).truncate(false).open(&path).map_err(io)?;
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(io)?;
        let key: [u8; 32] = Sha256::new()
            .chain_update(VERSION.to_le_bytes())
            .chain_update(scene_hash(scene))
            .chain_update(format!("{options:?} {:?}", scene.cameras))
            .finalize()
            .into();
        let mut found = BTreeMap::new();
        let mut end = key.len();
        if bytes.get(..key.len()) == Some(&key[..]) {
            while let Some((index, output, next)) = record(&bytes, end) {
                found.insert(index, output);
                end = next;
            }
        } else {
            file.seek(SeekFrom::Start(0)).and_then(|_| file.write_all(&key)).map_err(io)?;
        }
        file.set_len(end as u64).and_then(|()| file.seek(SeekFrom::Start(end as u64))).map_err(io)?;
        Ok((Self { file: Mutex::new(file), path: path.clone() }, found))
    }

    /// Adds a finished cluster.
    ///
    /// # Errors
    /// [`BakeFileError::Io`].
    pub fn add(&self, index: usize, output: &ClusterOutput) -> Result<(), BakeFileError> {
        let payload = words_of(index, output);
        let body: &[u8] = bytemuck::cast_slice(&payload);
        let mut bytes = (body.len() as u64).to_le_bytes().to_vec();
        bytes.extend_from_slice(body);
        bytes.extend_from_slice(&Sha256::digest(body)[..8]);
        let mut file = self.file.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        file.write_all(&bytes).map_err(|source| BakeFileError::Io { path: self.path.clone(), source })
    }

    /// Removes it: the bake is done.
    ///
    /// # Errors
    /// [`BakeFileError::Io`].
    pub fn remove(self) -> Result<(), BakeFileError> {
        std::fs::remove_file(&self.path).map_err(|source| BakeFileError::Io { path: self.path.clone(), source })
    }
}

/// The record at an offset and the offset after it.
fn record(bytes: &[u8], at: usize) -> Option<(usize, ClusterOutput, usize)> {
    let length = u64::from_le_bytes(bytes.get(at..at + 8)?.try_into().ok()?) as usize;
    let end = at.checked_add(8)?.checked_add(length)?;
    let body = bytes.get(at + 8..end)?;
    if bytes.get(end..end + 8)? != &Sha256::digest(body)[..8] {
        return None;
    }
    let words: Vec<u32> = body.chunks_exact(4).map(bytemuck::pod_read_unaligned).collect();
    let (index, output) = Words(&words).read()?;
    Some((index, output, end + 8))
}

/// A cluster as words: lists with their lengths before them.
fn words_of(index: usize, output: &ClusterOutput) -> Vec<u32> {
    let mut words = vec![index as u32, output.rays.len() as u32];
    words.extend(output.rays.iter().flat_map(|r| [r.sky, r.unseen, r.inside].map(f32::to_bits)));
    let v = output.verdict;
    words.extend([v.receivers, v.followed, v.light, v.before, v.after].map(f32::to_bits));
    let left = output.left_out;
    words.extend([left.light.to_bits(), left.left_out.to_bits(), left.columns, left.columns_left_out, left.bytes]);
    words.push(output.parts.len() as u32);
    let mut list = |items: &mut dyn Iterator<Item = u32>| {
        let at = words.len();
        words.push(0);
        words.extend(items);
        words[at] = (words.len() - at - 1) as u32;
    };
    for (members, cluster) in &output.parts {
        let Loss { transport, light, noise } = cluster.loss;
        list(&mut [cluster.rank, transport.to_bits(), light.to_bits(), noise.to_bits()].into_iter());
        list(&mut members.iter().copied());
        list(&mut cluster.probes.iter().copied());
        list(&mut cluster.columns.iter().flat_map(|c| [c.0, c.1]));
        list(&mut cluster.projection.iter().map(|x| x.to_bits()));
        list(&mut cluster.reconstruction.iter().map(|x| x.to_bits()));
    }
    words
}

struct Words<'a>(&'a [u32]);

impl Words<'_> {
    fn next(&mut self) -> Option<u32> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(*first)
    }

    fn list(&mut self) -> Option<Vec<u32>> {
        let length = self.next()? as usize;
        let list = self.0.get(..length)?.to_vec();
        self.0 = &self.0[length..];
        Some(list)
    }

    fn read(mut self) -> Option<(usize, ClusterOutput)> {
        let (index, count) = (self.next()? as usize, self.next()? as usize);
        let mut rays = Vec::new();
        for _ in 0..count {
            let [sky, unseen, inside] = [self.next()?, self.next()?, self.next()?].map(f32::from_bits);
            rays.push(Rays { sky, unseen, inside });
        }
        let mut verdict = [0.0; 5];
        for number in &mut verdict {
            *number = f32::from_bits(self.next()?);
        }
        let [receivers, followed, light, before, after] = verdict;
        let verdict = Verdict { receivers, followed, light, before, after };
        let left_out = LeftOut {
            light: f32::from_bits(self.next()?),
            left_out: f32::from_bits(self.next()?),
            columns: self.next()?,
            columns_left_out: self.next()?,
            bytes: self.next()?,
        };
        let mut parts = Vec::new();
        for _ in 0..self.next()? {
            let &[rank, transport, light, noise] = self.list()?.as_slice() else { return None };
            let [transport, light, noise] = [transport, light, noise].map(f32::from_bits);
            let members = self.list()?;
            let floats = |list: Vec<u32>| list.into_iter().map(f32::from_bits).collect();
            let cluster = Cluster {
                receivers: 0..0,
                rank,
                probes: self.list()?,
                columns: self.list()?.chunks_exact(2).map(|c| (c[0], c[1])).collect(),
                projection: floats(self.list()?),
                reconstruction: floats(self.list()?),
                loss: Loss { transport, light, noise },
            };
            parts.push((members, cluster));
        }
        Some((index, ClusterOutput { parts, rays, verdict, left_out }))
    }
}

#[cfg(test)]
mod tests {
    use super::super::plan::Plan;
    use super::*;
    use crate::scene::built_in;

    fn small() -> BakeOptions {
        BakeOptions {
            receivers: 600,
            probes: 4,
            order: 2,
            rays: 32,
            relight_rays: 64,
            cluster_size: 128,
            ..BakeOptions::default()
        }
    }

    #[test]
    fn files_come_back_as_written_up_to_16_bits() {
        let scene = built_in::cornell_box();
        let plan = Plan::new(&scene, &small()).unwrap();
        let (bake, lookup) = plan.bake();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("box.safetensors");
        save(&path, &bake, lookup.atlas(), &scene).unwrap();
        let (again, found) = load(&path, &scene).unwrap();
        assert_eq!((&again.receivers, &again.texel, &again.ray_hits), (&bake.receivers, &bake.texel, &bake.ray_hits));
        assert_eq!((&again.dilation, &again.sky, &again.probes), (&bake.dilation, &bake.sky, &bake.probes));
        for (a, b) in again.clusters.iter().zip(&bake.clusters) {
            assert_eq!((&a.columns, &a.probes, a.rank), (&b.columns, &b.probes, b.rank));
            let mut matrices =
                a.projection.iter().chain(&a.reconstruction).zip(b.projection.iter().chain(&b.reconstruction));
            assert!(matrices.all(|(a, b)| (a - b).abs() <= 1e-3 * b.abs() + 1e-6));
        }
        // A lookup of the file is the lookup of the bake.
        let p = bake.receivers[17];
        let ask = |l: &Lookup| l.blend(p.triangle, [0.2, 0.5, 0.3], p.front, p.position, p.geometric_normal);
        assert_eq!(ask(&found), ask(&lookup));
        // Lights may change, geometry may not.
        let mut relit = scene.clone();
        relit.lights.push(crate::scene::Light::Point { position: Vec3::ONE, intensity: Vec3::ONE });
        assert!(load(&path, &relit).is_ok());
        let mut moved = scene.clone();
        moved.positions[0].x += 0.001;
        assert!(matches!(load(&path, &moved), Err(BakeFileError::WrongScene { .. })));
    }

    #[test]
    fn damaged_files_are_refused_by_name() {
        let scene = built_in::cornell_box();
        let (bake, lookup) = Plan::new(&scene, &small()).unwrap().bake();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("box.safetensors");
        save(&path, &bake, lookup.atlas(), &scene).unwrap();
        let whole = std::fs::read(&path).unwrap();
        let with = |bytes: &[u8]| {
            std::fs::write(&path, bytes).unwrap();
            load(&path, &scene).map(drop)
        };
        for cut in [0, 7, 100, whole.len() / 2, whole.len() - 1] {
            assert!(matches!(with(&whole[..cut]), Err(BakeFileError::Format { .. })), "cut at {cut}");
        }
        let mut flipped = whole.clone();
        let middle = whole.len() - 1000;
        flipped[middle] ^= 1;
        assert!(matches!(with(&flipped), Err(BakeFileError::Checksum { .. })));
        let older = |from: &str, to: &str| {
            let at = whole.windows(from.len()).position(|w| w == from.as_bytes()).unwrap();
            let mut bytes = whole.clone();
            bytes[at..at + from.len()].copy_from_slice(to.as_bytes());
            bytes
        };
        let before = format!("version {};", VERSION - 1);
        let version = with(&older(&format!("version {VERSION};"), &before));
        assert!(matches!(version, Err(BakeFileError::Version { .. })), "{version:?}");
        assert!(matches!(with(&older(KEY, &KEY.replace("srp", "lpv"))), Err(BakeFileError::Format { .. })));
        assert!(matches!(with(b"not a bake"), Err(BakeFileError::Format { .. })));
        assert!(matches!(load(&folder.path().join("absent"), &scene), Err(BakeFileError::Io { .. })));
        assert!(with(&whole).is_ok());
    }

    #[test]
    fn an_interrupted_bake_goes_on_with_the_same_bits() {
        let scene = built_in::cornell_box();
        let options = small();
        let plan = Plan::new(&scene, &options).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("box.safetensors");
        let bytes = |bake: &SrpBake, lookup: &Lookup| {
            save(&target, bake, lookup.atlas(), &scene).unwrap();
            std::fs::read(&target).unwrap()
        };
        let (bake, lookup) = plan.bake();
        let uninterrupted = bytes(&bake, &lookup);
        // Two clusters get done, the second is being written when the process dies.
        let (journal, found) = Journal::open(&target, &scene, &options).unwrap();
        assert!(found.is_empty() && plan.clusters.len() > 2);
        journal.add(1, &plan.cluster(1)).unwrap();
        journal.add(0, &plan.cluster(0)).unwrap();
        drop(journal);
        let part = folder.path().join("box.safetensors.part");
        let written = std::fs::read(&part).unwrap();
        std::fs::write(&part, &written[..written.len() - 3]).unwrap();
        let (journal, found) = Journal::open(&target, &scene, &options).unwrap();
        assert_eq!(found.keys().copied().collect::<Vec<_>>(), [1]);
        assert_eq!(found[&1], plan.cluster(1));
        assert!(found[&1].left_out.light > 0.0 && found[&1].left_out.columns > 0);
        let (bake, lookup) = plan.resume(found, &|index, output| journal.add(index, output), &|_| ()).unwrap();
        assert_eq!(bytes(&bake, &lookup), uninterrupted);
        drop(journal);
        // All of it is there now; other settings begin anew.
        let (journal, found) = Journal::open(&target, &scene, &options).unwrap();
        assert_eq!(found.len(), plan.clusters.len());
        drop(journal);
        let (journal, found) = Journal::open(&target, &scene, &BakeOptions { rays: 64, ..options }).unwrap();
        assert!(found.is_empty());
        journal.remove().unwrap();
        assert!(!part.exists());
    }
}
