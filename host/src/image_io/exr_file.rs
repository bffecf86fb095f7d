//! OpenEXR: 32-bit float RGB, ZIP-compressed scan lines, linear Rec. 709 with a D65 white point.

use super::{Image, ImageError, write_whole};
use exr::prelude::*;
use glam::Vec3;
use std::io::Cursor;
use std::path::Path;

/// Largest picture that is read or written: 134 million pixels (1.6 GB of values). A few bytes of an EXR header may
/// claim more than any machine holds, so the claim is checked before anything is allocated.
pub const MAX_PIXELS: usize = 1 << 27;

/// Writes a picture as EXR: channels R, G, B of 32-bit floats, lossless, whole or not at all.
///
/// # Errors
/// [`ImageError::NonFinite`] (a picture with NaN or infinity is refused), [`ImageError::Size`], [`ImageError::Encode`],
/// [`ImageError::Io`], each with the path.
pub fn write_exr(path: &Path, picture: &Image) -> std::result::Result<(), ImageError> {
    picture.check_finite(&path.display().to_string())?;
    check_size(path, picture.width as usize, picture.height as usize)?;
    let size = Vec2(picture.width as usize, picture.height as usize);
    let channels = SpecificChannels::rgb(|at: Vec2<usize>| {
        let p = picture.pixels[at.y() * size.width() + at.x()];
        (p.x, p.y, p.z)
    });
    let software_name = Some(concat!("interreflect ", env!("CARGO_PKG_VERSION")).into());
    let attributes = LayerAttributes { software_name, ..LayerAttributes::default() };
    let layer = Layer::new(size, attributes, Encoding::SMALL_LOSSLESS, channels);
    let mut file = exr::image::Image::from_layer(layer);
    file.attributes.chromaticities = Some(rec709());
    let mut bytes = Cursor::new(Vec::new());
    file.write()
        .to_buffered(&mut bytes)
        .map_err(|e| ImageError::Encode { path: path.into(), reason: e.to_string() })?;
    write_whole(path, bytes.get_ref())
}

/// Reads the first layer with R, G and B channels (16- or 32-bit) of an EXR file, taken as linear Rec. 709.
///
/// # Errors
/// [`ImageError::Io`], [`ImageError::Decode`], [`ImageError::Size`] (zero or more than [`MAX_PIXELS`]) and
/// [`ImageError::NonFinite`], each with the path.
pub fn read_exr(path: &Path) -> std::result::Result<Image, ImageError> {
    let bytes = std::fs::read(path).map_err(|e| ImageError::io("read", path, e))?;
    let decode = |e: exr::error::Error| ImageError::Decode { path: path.into(), reason: e.to_string() };
    let meta = MetaData::read_from_buffered(Cursor::new(&bytes), false).map_err(decode)?;
    for header in &meta.headers {
        check_size(path, header.layer_size.width(), header.layer_size.height())?;
    }
    let layer = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| (size.width(), vec![Vec3::ZERO; size.area()]),
            |(width, pixels), at, (r, g, b): (f32, f32, f32)| pixels[at.y() * *width + at.x()] = Vec3::new(r, g, b),
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(&bytes))
        .map_err(decode)?
        .layer_data;
    let (width, height) = (layer.size.width() as u32, layer.size.height() as u32);
    let picture = Image::new(width, height, layer.channel_data.pixels.1)?;
    picture.check_finite(&path.display().to_string())?;
    Ok(picture)
}

fn check_size(path: &Path, width: usize, height: usize) -> std::result::Result<(), ImageError> {
    let reason = match width.checked_mul(height) {
        Some(0) => "a side is zero".to_string(),
        Some(n) if n <= MAX_PIXELS => return Ok(()),
        _ => format!("more than {MAX_PIXELS} pixels"),
    };
    Err(ImageError::Size { what: path.display().to_string(), width, height, reason })
}

/// CIE xy of the primaries and the white point (ITU-R BT.709-6, item 1.3).
fn rec709() -> attribute::Chromaticities {
    attribute::Chromaticities {
        red: Vec2(0.64, 0.33),
        green: Vec2(0.30, 0.60),
        blue: Vec2(0.15, 0.06),
        white: Vec2(0.3127, 0.3290),
    }
}
