//! Decoding of base-colour pictures.

use super::super::{FileError, Texture};
use super::{MAX_TEXELS, MAX_TEXTURE_SIDE};
use glam::Vec3;
use image::{ImageReader, Limits};
use std::io::Cursor;

/// Decodes PNG and JPEG pictures and counts their pixels, so that a scene cannot claim endless memory.
#[derive(Default)]
pub struct Pictures {
    texels: u64,
}

impl Pictures {
    /// Decodes a picture; its kind follows from its bytes. `name` is for errors.
    pub fn decode(&mut self, name: &str, bytes: &[u8]) -> Result<Texture, FileError> {
        let refuse = |reason: String| FileError::Image { image: name.to_owned(), reason };
        let size = reader(bytes).and_then(ImageReader::into_dimensions).map_err(|e| refuse(e.to_string()))?;
        if size.0 == 0 || size.1 == 0 || size.0.max(size.1) > MAX_TEXTURE_SIDE {
            return Err(refuse(format!(
                "{} × {} pixels: sides of 1 to {MAX_TEXTURE_SIDE} are accepted",
                size.0, size.1
            )));
        }
        self.texels += u64::from(size.0) * u64::from(size.1);
        if self.texels > MAX_TEXELS {
            let what = "the number of texture pixels".to_owned();
            return Err(FileError::TooLarge { what, claimed: self.texels, limit: MAX_TEXELS });
        }
        let decoded = reader(bytes).and_then(ImageReader::decode).map_err(|e| refuse(e.to_string()))?;
        let rgba = decoded.to_rgba8();
        let (width, height) = rgba.dimensions();
        let srgba = rgba.into_raw().chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect();
        Ok(Texture { width, height, srgba })
    }
}

fn reader(bytes: &[u8]) -> image::ImageResult<ImageReader<Cursor<&[u8]>>> {
    let mut reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format()?;
    let mut limits = Limits::default();
    limits.max_image_width = Some(MAX_TEXTURE_SIDE);
    limits.max_image_height = Some(MAX_TEXTURE_SIDE);
    // 16-bit RGBA of the largest picture.
    limits.max_alloc = Some(8 * MAX_TEXELS);
    reader.limits(limits);
    Ok(reader)
}

/// Mean linear colour of a picture.
pub fn mean_linear(texture: &Texture) -> Vec3 {
    let decode: Vec<f64> = (0..256).map(|code| f64::from(srgb_to_linear(code as f32 / 255.0))).collect();
    let mut sum = [0.0; 3];
    for texel in &texture.srgba {
        for channel in 0..3 {
            sum[channel] += decode[texel[channel] as usize];
        }
    }
    Vec3::from_array(sum.map(|s| (s / texture.srgba.len().max(1) as f64) as f32))
}

/// IEC 61966-2-1: linear light of an sRGB-coded value, both in 0…1.
fn srgb_to_linear(coded: f32) -> f32 {
    if coded <= 0.04045 { coded / 12.92 } else { ((coded + 0.055) / 1.055).powf(2.4) }
}
