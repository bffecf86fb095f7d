//! Truths on disk, so that the same picture is not traced twice.
//!
//! A file is named by two hashes of all that its content depends on: what it is the truth of (this module's version, the scene's
//! content, the camera and the size, or the receivers), and how well (noise, samples, seed). It holds a magic number, the payload's length, its SHA-256, and the payload:
//! numbers little-endian, then the pictures (or the values at the receivers). A file that does not hold what it says is ignored and written anew.

use super::trace::KeptTree;
use super::{
    Irradiance, IrradianceTruth, Progress, Receiver, ReferenceError, ReferenceSettings, Truth, irradiance_by, render_by,
};
use crate::scene::{Camera, Scene};
use glam::Vec3;
use sha2::{Digest, Sha256};
use std::io::Write;
use std::path::{Path, PathBuf};

/// Version of the estimator and of the file format: a change of either makes old files unknown.
const MAGIC: &[u8; 8] = b"irtruth2";
/// The same for irradiance at receivers.
const MAGIC_IRRADIANCE: &[u8; 8] = b"irirrad2";
/// Bytes before the payload: magic, length, SHA-256.
const HEADER_BYTES: usize = 8 + 8 + 32;
/// Bytes of the payload before the pictures.
const NUMBER_BYTES: usize = 4 + 4 + 4 + 8 + 8 + 8;
/// Pictures stored: direct, indirect, variance of full, variance of indirect; full is the sum of two.
const PICTURES: usize = 4;

/// A truth, and whether the cache had it.
#[derive(Clone, PartialEq, Debug)]
pub struct Cached {
    /// The picture.
    pub truth: Truth,
    /// Whether it was read rather than rendered.
    pub from_cache: bool,
    /// Its file.
    pub path: PathBuf,
}

/// Irradiance at receivers, and whether the cache had it.
#[derive(Clone, PartialEq, Debug)]
pub struct CachedIrradiance {
    /// Values.
    pub truth: IrradianceTruth,
    /// Whether it was read rather than traced.
    pub from_cache: bool,
    /// Its file.
    pub path: PathBuf,
}

/// Where truths are kept unless the user names a directory: `$XDG_CACHE_HOME/interreflect`, `~/.cache/interreflect`,
/// `%LOCALAPPDATA%\interreflect`, or else a directory for temporary files.
pub fn default_dir() -> PathBuf {
    let var = |name: &str| std::env::var_os(name).filter(|v| !v.is_empty()).map(PathBuf::from);
    // The XDG specification asks to ignore relative paths.
    let base = var("XDG_CACHE_HOME").filter(|p| p.is_absolute());
    base.or_else(|| var("HOME").map(|h| h.join(".cache")))
        .or_else(|| var("LOCALAPPDATA"))
        .unwrap_or_else(std::env::temp_dir)
        .join("interreflect")
}

/// [`super::render()`], or the same picture from `dir`, where an earlier run left it. A missing or damaged file is made anew;
/// it appears whole or not at all, so that runs side by side may share a directory. `tree` is the scene's, and built only where
/// something is to be traced; `size` in pixels, width first.
///
/// # Errors
/// As [`super::render()`]; [`ReferenceError::Cache`] where the directory cannot be made or written.
pub fn cached(
    dir: &Path,
    tree: &KeptTree,
    scene: &Scene,
    camera: &Camera,
    size: (u32, u32),
    settings: &ReferenceSettings,
    progress: &mut dyn FnMut(Progress),
) -> Result<Cached, ReferenceError> {
    let path =
        dir.join(format!("{}-{}.truth", picture_of(scene, camera, size, settings.max_bounces), quality(settings)));
    if let Some(truth) = std::fs::read(&path).ok().and_then(|bytes| decode(&bytes))
        && (truth.width, truth.height) == size
    {
        progress(Progress { fraction: 1.0, remaining_s: 0.0, spp: truth.spp, noise: truth.noise });
        return Ok(Cached { truth, from_cache: true, path });
    }
    let file = writable(dir)?;
    let truth = render_by(tree, scene, camera, size, settings, progress)?;
    keep(file, &path, &encode(&truth))?;
    Ok(Cached { truth, from_cache: false, path })
}

/// [`super::irradiance()`], or the same values from `dir`, where an earlier run left them; as careful as [`cached`].
///
/// # Errors
/// As [`super::irradiance()`]; [`ReferenceError::Cache`] where the directory cannot be made or written.
pub fn cached_irradiance(
    dir: &Path,
    tree: &KeptTree,
    scene: &Scene,
    receivers: &[Receiver],
    settings: &ReferenceSettings,
    progress: &mut dyn FnMut(Progress),
) -> Result<CachedIrradiance, ReferenceError> {
    let path =
        dir.join(format!("{}-{}.irradiance", irradiance_of(scene, receivers, settings.max_bounces), quality(settings)));
    if let Some(truth) = std::fs::read(&path).ok().and_then(|bytes| decode_irradiance(&bytes))
        && truth.values.len() == receivers.len()
    {
        progress(Progress { fraction: 1.0, remaining_s: 0.0, spp: truth.spp, noise: truth.noise });
        return Ok(CachedIrradiance { truth, from_cache: true, path });
    }
    let file = writable(dir)?;
    let truth = irradiance_by(tree, scene, receivers, settings, progress)?;
    keep(file, &path, &encode_irradiance(&truth))?;
    Ok(CachedIrradiance { truth, from_cache: false, path })
}

/// The picture by the most samples that earlier runs left in `dir`, whatever noise and seed they asked for; `None` where there is
/// none with all bounces.
pub fn best_picture(dir: &Path, scene: &Scene, camera: &Camera, size: (u32, u32)) -> Option<Truth> {
    let what = picture_of(scene, camera, size, None);
    let found = left_behind(dir, &what, "truth", |bytes| decode(bytes).filter(|t| (t.width, t.height) == size));
    found.into_iter().max_by_key(|truth| truth.spp)
}

/// [`best_picture`] of irradiance at receivers.
pub fn best_irradiance(dir: &Path, scene: &Scene, receivers: &[Receiver]) -> Option<IrradianceTruth> {
    let what = irradiance_of(scene, receivers, None);
    let found = left_behind(dir, &what, "irradiance", |bytes| {
        decode_irradiance(bytes).filter(|t| t.values.len() == receivers.len())
    });
    found.into_iter().max_by_key(|truth| truth.spp)
}

/// Every truth of `what` in a directory that may not be there.
fn left_behind<T>(dir: &Path, what: &str, ending: &str, decode: impl Fn(&[u8]) -> Option<T>) -> Vec<T> {
    let Ok(entries) = std::fs::read_dir(dir) else { return Vec::new() };
    let is_meant = |path: &PathBuf| {
        path.extension().is_some_and(|e| e == ending)
            && path.file_name().and_then(|n| n.to_str()).is_some_and(|n| n.starts_with(what))
    };
    let paths = entries.flatten().map(|entry| entry.path()).filter(is_meant);
    paths.filter_map(|path| decode(&std::fs::read(path).ok()?)).collect()
}

/// A file in `dir`, made before the work rather than after it: so one finds out early that its result cannot be kept.
fn writable(dir: &Path) -> Result<tempfile::NamedTempFile, ReferenceError> {
    std::fs::create_dir_all(dir)
        .and_then(|()| tempfile::NamedTempFile::new_in(dir))
        .map_err(|source| ReferenceError::Cache { path: dir.to_owned(), source })
}

fn keep(mut file: tempfile::NamedTempFile, path: &Path, bytes: &[u8]) -> Result<(), ReferenceError> {
    file.write_all(bytes)
        .and_then(|()| file.persist(path).map_err(|e| e.error))
        .map_err(|source| ReferenceError::Cache { path: path.to_owned(), source })?;
    Ok(())
}

/// Hash of what a picture shows.
fn picture_of(scene: &Scene, camera: &Camera, (width, height): (u32, u32), max_bounces: Option<u32>) -> String {
    let mut hash = Sha256::new();
    hash.update(MAGIC);
    hash.update(scene.content_hash());
    for v in [camera.position, camera.forward, camera.up, Vec3::new(camera.fovy_rad, 0.0, 0.0)] {
        hash.update(bytemuck::bytes_of(&v));
    }
    finish(hash, &[Some(u64::from(width)), Some(u64::from(height)), max_bounces.map(u64::from)])
}

/// Hash of where irradiance is asked for.
fn irradiance_of(scene: &Scene, receivers: &[Receiver], max_bounces: Option<u32>) -> String {
    let mut hash = Sha256::new();
    hash.update(MAGIC_IRRADIANCE);
    hash.update(scene.content_hash());
    hash.update((receivers.len() as u64).to_le_bytes());
    for receiver in receivers {
        hash.update(bytemuck::bytes_of(&[receiver.position, receiver.normal, receiver.geometric_normal]));
    }
    finish(hash, &[max_bounces.map(u64::from)])
}

/// Hash of how well a truth is known.
fn quality(settings: &ReferenceSettings) -> String {
    let (noise, spp) = (settings.noise.map(f64::to_bits), settings.spp.map(u64::from));
    finish(Sha256::new(), &[noise, spp, Some(u64::from(settings.seed))])
}

/// Adds numbers and gives the first half of the sum, in hexadecimal.
fn finish(mut hash: Sha256, numbers: &[Option<u64>]) -> String {
    // Absent numbers must differ from every value: a flag goes before each.
    for number in numbers {
        hash.update(u64::from(number.is_some()).to_le_bytes());
        hash.update(number.unwrap_or(0).to_le_bytes());
    }
    hash.finalize()[..16].iter().map(|byte| format!("{byte:02x}")).collect()
}

fn encode(truth: &Truth) -> Vec<u8> {
    let mut payload = Vec::with_capacity(NUMBER_BYTES + PICTURES * 12 * truth.full.len());
    for n in [truth.width, truth.height, truth.spp] {
        payload.extend(n.to_le_bytes());
    }
    payload.extend(truth.noise.to_le_bytes());
    payload.extend(truth.ms.to_le_bytes());
    payload.extend(truth.rays.to_le_bytes());
    for picture in [&truth.direct, &truth.indirect, &truth.variance_full, &truth.variance_indirect] {
        payload.extend(picture.iter().flat_map(|v| v.to_array()).flat_map(f32::to_le_bytes));
    }
    seal(MAGIC, payload)
}

/// A file's bytes: magic, length, SHA-256, payload.
fn seal(magic: &[u8; 8], payload: Vec<u8>) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(HEADER_BYTES + payload.len());
    bytes.extend(magic);
    bytes.extend((payload.len() as u64).to_le_bytes());
    bytes.extend(Sha256::digest(&payload).iter());
    bytes.extend(payload);
    bytes
}

/// The payload of a file's bytes, `None` where they are not whole.
fn unseal<'a>(magic: &[u8; 8], bytes: &'a [u8]) -> Option<&'a [u8]> {
    let (header, payload) = bytes.split_at_checked(HEADER_BYTES)?;
    let length = u64::from_le_bytes(header[8..16].try_into().ok()?);
    let whole = header[..8] == *magic && length == payload.len() as u64;
    (whole && header[16..] == Sha256::digest(payload)[..]).then_some(payload)
}

fn encode_irradiance(truth: &IrradianceTruth) -> Vec<u8> {
    let mut payload = Vec::with_capacity(28 + 36 * truth.values.len());
    payload.extend(truth.spp.to_le_bytes());
    payload.extend(truth.noise.to_le_bytes());
    payload.extend(truth.ms.to_le_bytes());
    payload.extend(truth.rays.to_le_bytes());
    for v in &truth.values {
        payload.extend([v.indirect, v.direct, v.variance].iter().flat_map(|v| v.to_array()).flat_map(f32::to_le_bytes));
    }
    seal(MAGIC_IRRADIANCE, payload)
}

fn decode_irradiance(bytes: &[u8]) -> Option<IrradianceTruth> {
    let (numbers, values) = unseal(MAGIC_IRRADIANCE, bytes)?.split_at_checked(28)?;
    if !values.len().is_multiple_of(36) {
        return None;
    }
    let double = |at: usize| Some(u64::from_le_bytes(numbers[at..at + 8].try_into().ok()?));
    let value = |b: &[u8]| Irradiance { indirect: vector(b), direct: vector(&b[12..]), variance: vector(&b[24..]) };
    Some(IrradianceTruth {
        values: values.chunks_exact(36).map(value).collect(),
        spp: u32::from_le_bytes(numbers[..4].try_into().ok()?),
        noise: f64::from_bits(double(4)?),
        ms: f64::from_bits(double(12)?),
        rays: double(20)?,
    })
}

/// Three floats, little-endian.
fn vector(b: &[u8]) -> Vec3 {
    let float = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
    Vec3::new(float(b), float(&b[4..]), float(&b[8..]))
}

/// The truth in a file's bytes, `None` where they are not whole.
fn decode(bytes: &[u8]) -> Option<Truth> {
    let payload = unseal(MAGIC, bytes)?;
    let (numbers, pictures) = payload.split_at_checked(NUMBER_BYTES)?;
    let word = |at: usize| Some(u32::from_le_bytes(numbers[at..at + 4].try_into().ok()?));
    let double = |at: usize| Some(u64::from_le_bytes(numbers[at..at + 8].try_into().ok()?));
    let (width, height) = (word(0)?, word(4)?);
    let pixels = width as usize * height as usize;
    if pixels == 0 || pictures.len() != PICTURES * 12 * pixels {
        return None;
    }
    let picture = |i: usize| -> Vec<Vec3> {
        pictures[i * 12 * pixels..(i + 1) * 12 * pixels].chunks_exact(12).map(vector).collect()
    };
    let (direct, indirect) = (picture(0), picture(1));
    Some(Truth {
        width,
        height,
        full: direct.iter().zip(&indirect).map(|(d, i)| *d + *i).collect(),
        direct,
        indirect,
        variance_full: picture(2),
        variance_indirect: picture(3),
        spp: word(8)?,
        noise: f64::from_bits(double(12)?),
        ms: f64::from_bits(double(20)?),
        rays: double(28)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn irradiance_is_kept_bit_for_bit_and_known_by_all_it_depends_on() {
        let dir = tempfile::tempdir().unwrap();
        let mut scene = crate::scene::built_in::furnace(0.5, 1.0);
        let mut receivers = vec![Receiver::new(Vec3::splat(0.3), Vec3::Y), Receiver::new(Vec3::splat(0.6), Vec3::X)];
        let settings = ReferenceSettings { spp: Some(4), ..Default::default() };
        let ask = |scene: &Scene, receivers: &[Receiver], settings: &ReferenceSettings| {
            cached_irradiance(dir.path(), &KeptTree::default(), scene, receivers, settings, &mut |_| {}).unwrap()
        };
        let first = ask(&scene, &receivers, &settings);
        let again = ask(&scene, &receivers, &settings);
        assert!(!first.from_cache && again.from_cache && first.truth == again.truth);
        assert!(!ask(&scene, &receivers, &ReferenceSettings { seed: 1, ..settings }).from_cache);
        // The best that is there, with all bounces, is found without knowing how it was made.
        let better = ask(&scene, &receivers, &ReferenceSettings { spp: Some(16), ..settings }).truth;
        ask(&scene, &receivers, &ReferenceSettings { spp: Some(64), max_bounces: Some(2), ..settings });
        let best = |receivers: &[Receiver]| best_irradiance(dir.path(), &scene, receivers);
        assert_eq!(best(&receivers), Some(better));
        assert_eq!(best(&receivers[..1]), None);
        receivers[1].position.x += 1e-6;
        assert!(!ask(&scene, &receivers, &settings).from_cache);
        scene.materials[0].albedo.x += 1e-6;
        assert!(!ask(&scene, &receivers, &settings).from_cache);
        // A damaged file is made anew.
        let mut bytes = std::fs::read(&first.path).unwrap();
        *bytes.last_mut().unwrap() ^= 1;
        std::fs::write(&first.path, bytes).unwrap();
        receivers[1].position.x = 0.6;
        scene.materials[0].albedo.x = 0.5;
        assert!(!ask(&scene, &receivers, &settings).from_cache);
    }
}
