//! glTF materials and textures as Lambert surfaces.

use super::super::{Alpha, FileError, Material, Wrap};
use super::MAX_FILE_BYTES;
use super::accessor::{Buffers, index_of, look_up};
use super::assemble::Assembler;
use super::external;
use super::picture::{Pictures, mean_linear};
use ::gltf::json::Root;
use ::gltf::json::material::{AlphaMode, Material as Source};
use ::gltf::json::texture::{Info, WrappingMode};
use ::gltf::json::validation::Checked;
use glam::{Mat2, Vec2, Vec3};
use std::collections::HashMap;
use std::path::Path;

/// How a primitive's texture coordinates become those of its base-colour texture.
#[derive(Clone, Copy)]
pub struct UvSource {
    /// The set: `TEXCOORD_<set>`.
    pub set: u32,
    rotation_scale: Mat2,
    offset: Vec2,
}

impl Default for UvSource {
    fn default() -> Self {
        UvSource { set: 0, rotation_scale: Mat2::IDENTITY, offset: Vec2::ZERO }
    }
}

impl UvSource {
    /// KHR_texture_transform: scale, then rotation, then offset. The rotation is counter-clockwise as seen in the
    /// picture, where v points down.
    fn new(info: &Info) -> Self {
        let extension = info.extensions.as_ref().and_then(|e| e.texture_transform.as_ref());
        let Some(transform) = extension else { return UvSource { set: info.tex_coord, ..UvSource::default() } };
        let (sin, cos) = transform.rotation.0.sin_cos();
        let rotation = Mat2::from_cols(Vec2::new(cos, -sin), Vec2::new(sin, cos));
        UvSource {
            set: transform.tex_coord.unwrap_or(info.tex_coord),
            rotation_scale: rotation * Mat2::from_diagonal(Vec2::from_array(transform.scale.0)),
            offset: Vec2::from_array(transform.offset.0),
        }
    }

    /// Applies the transform.
    pub fn transform(&self, uv: [f32; 2]) -> Vec2 {
        self.rotation_scale * Vec2::from_array(uv) + self.offset
    }
}

/// Converts materials and decodes each image once.
pub struct Materials<'a> {
    root: &'a Root,
    folder: &'a Path,
    pictures: Pictures,
    /// Image to texture of the scene.
    textures: HashMap<usize, u32>,
    /// Image to its mean linear colour.
    means: HashMap<usize, Vec3>,
}

impl<'a> Materials<'a> {
    pub fn new(root: &'a Root, folder: &'a Path) -> Self {
        Materials { root, folder, pictures: Pictures::default(), textures: HashMap::new(), means: HashMap::new() }
    }

    /// Appends all materials of the document, and glTF's default material last; for each how it uses texture coordinates.
    pub fn convert_all(&mut self, buffers: &Buffers, out: &mut Assembler) -> Result<Vec<UvSource>, FileError> {
        let mut uv_sources = Vec::with_capacity(self.root.materials.len() + 1);
        for (i, source) in self.root.materials.iter().enumerate() {
            uv_sources.push(self.convert(i, source, buffers, out)?);
        }
        let default = Source { name: Some("default".into()), ..Source::default() };
        uv_sources.push(self.convert(self.root.materials.len(), &default, buffers, out)?);
        Ok(uv_sources)
    }

    fn convert(
        &mut self,
        i: usize,
        source: &Source,
        buffers: &Buffers,
        out: &mut Assembler,
    ) -> Result<UvSource, FileError> {
        let name = source.name.clone().unwrap_or_else(|| format!("material {i}"));
        let pbr = &source.pbr_metallic_roughness;
        let factor = pbr.base_color_factor.0;
        let texture = match &pbr.base_color_texture {
            Some(info) => Some(self.base_colour(&name, info, buffers, out)?),
            None => None,
        };
        let mut material = Material {
            albedo: Vec3::new(factor[0], factor[1], factor[2]),
            texture,
            wrap: pbr.base_color_texture.as_ref().map_or(Ok([Wrap::Repeat; 2]), |info| self.wrap(&name, info))?,
            alpha_factor: factor[3],
            alpha: alpha(&name, source)?,
            emission: self.emission(&name, source, buffers, out)?,
            metallic: pbr.metallic_factor.0,
            roughness: pbr.roughness_factor.0,
            name,
        };
        make_legal(&mut material, out)?;
        out.add_material(material);
        note_ignored(source, out);
        Ok(pbr.base_color_texture.as_ref().map_or_else(UvSource::default, UvSource::new))
    }

    /// Radiance of the front face: factor × strength × mean of the texture.
    fn emission(
        &mut self,
        name: &str,
        source: &Source,
        buffers: &Buffers,
        out: &mut Assembler,
    ) -> Result<Vec3, FileError> {
        let strength = source.extensions.as_ref().and_then(|e| e.emissive_strength.as_ref());
        let emission = Vec3::from_array(source.emissive_factor.0) * strength.map_or(1.0, |s| s.emissive_strength.0);
        let Some(info) = source.emissive_texture.as_ref().filter(|_| emission != Vec3::ZERO) else {
            return Ok(emission);
        };
        let image = self.image_of(name, info)?;
        if !self.means.contains_key(&image) {
            let mean = mean_linear(&self.decode(image, buffers)?);
            self.means.insert(image, mean);
        }
        out.note(format!("material `{name}`: its emission texture is replaced by the texture's mean"));
        Ok(emission * self.means[&image])
    }

    fn base_colour(
        &mut self,
        name: &str,
        info: &Info,
        buffers: &Buffers,
        out: &mut Assembler,
    ) -> Result<u32, FileError> {
        let image = self.image_of(name, info)?;
        if let Some(&texture) = self.textures.get(&image) {
            return Ok(texture);
        }
        out.scene.textures.push(self.decode(image, buffers)?);
        let texture = out.scene.textures.len() as u32 - 1;
        self.textures.insert(image, texture);
        Ok(texture)
    }

    fn image_of(&self, material: &str, info: &Info) -> Result<usize, FileError> {
        let what = || format!("material `{material}`: texture");
        let texture = look_up(&self.root.textures, info.index.value(), what)?;
        // The library gives a texture without a source this one.
        if texture.source.value() == u32::MAX as usize {
            let reason = "its texture has no source that is known: extensions of pictures are not read".to_owned();
            return Err(FileError::Image { image: material.to_owned(), reason });
        }
        Ok(texture.source.value())
    }

    /// How a texture goes on beyond its sides, along u and v.
    fn wrap(&self, material: &str, info: &Info) -> Result<[Wrap; 2], FileError> {
        let texture = &self.root.textures[info.index.value()];
        let Some(sampler_idx) = index_of(texture.sampler) else { return Ok([Wrap::Repeat; 2]) };
        let sampler = look_up(&self.root.samplers, sampler_idx, || format!("material `{material}`: sampler"))?;
        Ok([sampler.wrap_s, sampler.wrap_t].map(|mode| match mode {
            Checked::Valid(WrappingMode::ClampToEdge) => Wrap::Clamp,
            Checked::Valid(WrappingMode::MirroredRepeat) => Wrap::Mirror,
            Checked::Valid(WrappingMode::Repeat) | Checked::Invalid => Wrap::Repeat,
        }))
    }

    fn decode(&mut self, image_idx: usize, buffers: &Buffers) -> Result<super::super::Texture, FileError> {
        let image = look_up(&self.root.images, image_idx, || "texture: image".into())?;
        let name = image.name.clone().unwrap_or_else(|| format!("{image_idx}"));
        match (&image.uri, image.buffer_view) {
            (Some(uri), _) => self.pictures.decode(&name, &external::read_uri(self.folder, uri, MAX_FILE_BYTES)?),
            (None, Some(view)) => self.pictures.decode(&name, buffers.view(view.value())?),
            (None, None) => Err(FileError::Image { image: name, reason: "has neither a URI nor a buffer view".into() }),
        }
    }
}

fn alpha(name: &str, source: &Source) -> Result<Alpha, FileError> {
    match source.alpha_mode {
        Checked::Valid(AlphaMode::Opaque) => Ok(Alpha::Opaque),
        Checked::Valid(AlphaMode::Mask) => Ok(Alpha::Mask(source.alpha_cutoff.unwrap_or_default().0)),
        Checked::Valid(AlphaMode::Blend) => Ok(Alpha::Blend),
        Checked::Invalid => Err(FileError::Malformed(format!("material `{name}`: unknown alphaMode"))),
    }
}

/// Clamps what may not be (said), refuses what is not finite, and makes masks that cut nothing opaque.
pub fn make_legal(material: &mut Material, out: &mut Assembler) -> Result<(), FileError> {
    let cutoff = if let Alpha::Mask(cutoff) = material.alpha { cutoff } else { 0.0 };
    let scalars = Vec3::new(material.alpha_factor, material.metallic, material.roughness);
    if !(material.albedo.is_finite() && material.emission.is_finite() && scalars.is_finite() && cutoff.is_finite()) {
        return Err(FileError::Malformed(format!("material `{}` has a factor that is not finite", material.name)));
    }
    let legal_albedo = material.albedo.clamp(Vec3::ZERO, Vec3::ONE);
    if legal_albedo != material.albedo {
        out.note(format!("material `{}`: reflectance clamped to 0…1", material.name));
        material.albedo = legal_albedo;
    }
    if material.emission.min_element() < 0.0 {
        out.note(format!("material `{}`: negative emission taken as none", material.name));
        material.emission = material.emission.max(Vec3::ZERO);
    }
    material.alpha_factor = material.alpha_factor.clamp(0.0, 1.0);
    material.metallic = material.metallic.clamp(0.0, 1.0);
    material.roughness = material.roughness.clamp(0.0, 1.0);
    if matches!(material.alpha, Alpha::Mask(_)) {
        let codes = material.texture.map(|t| out.scene.textures[t as usize].srgba.iter().map(|texel| texel[3]));
        let (least, most) = codes.map_or((255, 255), |c| c.fold((255, 0), |(lo, hi), a| (lo.min(a), hi.max(a))));
        let alpha_of = |code: u8| material.alpha_factor * f32::from(code) / 255.0;
        if alpha_of(least) >= cutoff {
            material.alpha = Alpha::Opaque;
        } else if alpha_of(most) < cutoff {
            material.alpha = Alpha::Blend; // nothing of it is ever there
        }
    }
    Ok(())
}

fn note_ignored(source: &Source, out: &mut Assembler) {
    if source.normal_texture.is_some() {
        out.note("normal maps are ignored");
    }
    if source.pbr_metallic_roughness.metallic_roughness_texture.is_some() {
        out.note("metallic-roughness textures are ignored");
    }
    if source.occlusion_texture.is_some() {
        out.note("occlusion textures are ignored: occlusion is computed");
    }
}
