//! Import of scene files. Whatever the bytes are, an import returns a scene or a [`FileError`]: every index is checked
//! before it is used, every length against what is there, and every allocation is bounded by the size of the files
//! read, by [`LoadOptions::max_triangles`], or by a constant of this module.

mod accessor;
mod assemble;
mod camera_fit;
mod container;
mod external;
mod gltf;
mod material;
mod obj;
mod picture;

use super::{FileError, LoadOptions, Scene};
use std::path::Path;

/// Largest sum of the bytes of a scene's files (4 GiB).
const MAX_FILE_BYTES: u64 = 1 << 32;
/// Most pixels of all textures of a scene together (1 GiB when decoded).
const MAX_TEXELS: u64 = 1 << 28;
/// Largest width and height of a texture.
const MAX_TEXTURE_SIDE: u32 = 16_384;
/// Most accessor elements that one import decodes (a file may refer to the same bytes many times).
const MAX_ELEMENTS: u64 = 1 << 29;
/// Most elements of an accessor that no bytes back (its elements are zero, or sparse).
const MAX_UNBACKED_ELEMENTS: u64 = 1 << 22;
/// Largest distance of a vertex, camera or light from the origin (m): squares of lengths stay far from overflow.
const MAX_COORDINATE_M: f64 = 1e9;

/// Reads a scene file; its kind follows from its name.
pub(super) fn load(path: &Path, options: &LoadOptions) -> Result<Scene, FileError> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    if !matches!(extension.as_str(), "glb" | "gltf" | "obj") {
        // A name that says nothing must not hide that the file is not there at all.
        external::check_is_file(path)?;
        return Err(FileError::UnknownKind);
    }
    let bytes = external::read(path, MAX_FILE_BYTES)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut scene = match extension.as_str() {
        "glb" => gltf::load_binary(&bytes, folder, options)?,
        "gltf" => gltf::load_text(&bytes, folder, options)?,
        _ => obj::load(&bytes, folder, options)?,
    };
    scene.name = path.display().to_string();
    Ok(scene)
}
