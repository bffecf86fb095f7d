//! Pictures: linear RGB in memory, EXR and PNG on disk, and how linear light becomes something to look at.
//!
//! [`Image`] holds linear Rec. 709 values (radiance in W/(sr m²), irradiance in W/m²). [`write_exr`] and [`read_exr`]
//! keep every bit of them; [`ToneMap`] and [`error_map`] make 8-bit sRGB pictures, which [`write_png`] stores.
//! Every file appears whole or not at all: it is written beside its place under another name and renamed when complete.

mod display;
mod exr_file;

pub use display::{DIVERGING_ENDS, Rgb8, ToneMap, colour_of_signed, error_map, flip_map, magma};
pub use exr_file::{MAX_PIXELS, read_exr, write_exr};

use glam::Vec3;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What can go wrong with pictures and files.
#[derive(Debug, thiserror::Error)]
pub enum ImageError {
    /// The file system refused.
    #[error("cannot {action} `{path}`: {source}")]
    Io {
        /// `read`, `write`, `create`.
        action: &'static str,
        /// File or folder.
        path: PathBuf,
        /// The system's words.
        source: std::io::Error,
    },
    /// The file is not a picture that we can read.
    #[error("`{path}` is not a readable EXR picture: {reason}")]
    Decode {
        /// File.
        path: PathBuf,
        /// The decoder's words.
        reason: String,
    },
    /// A picture could not be turned into a file's bytes.
    #[error("cannot encode `{path}`: {reason}")]
    Encode {
        /// File.
        path: PathBuf,
        /// The encoder's words.
        reason: String,
    },
    /// Width or height is zero, the number of pixels does not fit them, or the picture is larger than [`MAX_PIXELS`].
    #[error("picture `{what}` of {width} x {height} pixels: {reason}")]
    Size {
        /// Path or name.
        what: String,
        /// Width in pixels.
        width: usize,
        /// Height in pixels.
        height: usize,
        /// What is wrong.
        reason: String,
    },
    /// NaN or infinite values.
    #[error("picture `{what}` has {count} pixels that are not finite, the first at ({x}, {y})")]
    NonFinite {
        /// Path or name.
        what: String,
        /// How many pixels.
        count: usize,
        /// Column of the first.
        x: u32,
        /// Row of the first.
        y: u32,
    },
}

impl ImageError {
    pub(crate) fn io(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::Io { action, path: path.to_path_buf(), source }
    }
}

/// A picture of linear Rec. 709 values, row 0 on top.
#[derive(Clone, PartialEq, Debug)]
pub struct Image {
    width: u32,
    height: u32,
    pixels: Vec<Vec3>,
}

impl Image {
    /// A picture from its pixels, row by row from the top.
    ///
    /// # Errors
    /// [`ImageError::Size`] where a side is zero or `pixels` does not hold `width * height` values.
    ///
    /// ```
    /// use interreflect::image_io::Image;
    /// let grey = Image::new(2, 1, vec![glam::Vec3::splat(0.5); 2])?;
    /// assert_eq!(grey.pixel(1, 0).x, 0.5);
    /// # Ok::<(), interreflect::image_io::ImageError>(())
    /// ```
    pub fn new(width: u32, height: u32, pixels: Vec<Vec3>) -> Result<Self, ImageError> {
        let error = |reason: String| ImageError::Size {
            what: "(in memory)".into(),
            width: width as usize,
            height: height as usize,
            reason,
        };
        if width == 0 || height == 0 {
            return Err(error("a side is zero".into()));
        }
        if pixels.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(error(format!("{} pixels were given", pixels.len())));
        }
        Ok(Self { width, height, pixels })
    }

    /// Width in pixels, at least 1.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels, at least 1.
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Width and height.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// All pixels, row by row from the top.
    pub fn pixels(&self) -> &[Vec3] {
        &self.pixels
    }

    /// One pixel; `x` counts from the left, `y` from the top.
    pub fn pixel(&self, x: u32, y: u32) -> Vec3 {
        self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// Refuses NaN and infinity, and counts them. `what` names the picture in the message.
    ///
    /// # Errors
    /// [`ImageError::NonFinite`].
    pub fn check_finite(&self, what: &str) -> Result<(), ImageError> {
        let Some(first) = self.pixels.iter().position(|p| !p.is_finite()) else { return Ok(()) };
        Err(ImageError::NonFinite {
            what: what.into(),
            count: self.pixels.iter().filter(|p| !p.is_finite()).count(),
            x: (first % self.width as usize) as u32,
            y: (first / self.width as usize) as u32,
        })
    }
}

/// Relative luminance of a linear Rec. 709 value (ITU-R BT.709-6, item 3.2).
pub fn luminance(rgb: Vec3) -> f32 {
    rgb.dot(Vec3::new(0.2126, 0.7152, 0.0722))
}

/// Writes a file so that it appears whole or not at all: the bytes go to a hidden neighbour that takes the file's
/// place only when complete. An older file of that name stays as it was until then.
///
/// # Errors
/// [`ImageError::Io`] with the path; nothing is left behind.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), ImageError> {
    replace_file(path, bytes).map_err(|source| ImageError::io("write", path, source))
}

/// [`write_whole`] for modules with an error of their own.
pub(crate) fn replace_file(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".interreflect-").suffix(".partial");
    // Temporary files are private by default; a report is as readable as any other file of the user's.
    #[cfg(unix)]
    let builder = builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(bytes)?;
    file.flush()?;
    file.persist(path)?;
    Ok(())
}

/// Writes an 8-bit sRGB picture as PNG, whole or not at all.
///
/// # Errors
/// [`ImageError::Encode`] and [`ImageError::Io`], with the path.
pub fn write_png(path: &Path, picture: &Rgb8) -> Result<(), ImageError> {
    let bytes = png_bytes(picture).map_err(|reason| ImageError::Encode { path: path.into(), reason })?;
    write_whole(path, &bytes)
}

/// A PNG file's bytes.
pub(crate) fn png_bytes(picture: &Rgb8) -> Result<Vec<u8>, String> {
    use image::codecs::png::{CompressionType, FilterType, PngEncoder};
    let mut bytes = Vec::new();
    let encoder = PngEncoder::new_with_quality(&mut bytes, CompressionType::Default, FilterType::Adaptive);
    picture.write_with_encoder(encoder).map_err(|e| e.to_string())?;
    Ok(bytes)
}
