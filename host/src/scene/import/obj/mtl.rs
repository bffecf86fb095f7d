//! MTL material libraries as Lambert surfaces.

use super::super::super::{Alpha, FileError, Material, Texture, Wrap};
use super::super::assemble::Assembler;
use super::super::material::make_legal;
use super::super::picture::Pictures;
use super::super::{MAX_FILE_BYTES, external};
use super::{at_line, numbers, statements};
use glam::Vec3;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Reflectance where no material says otherwise.
const DEFAULT_ALBEDO: f32 = 0.8;
/// Opacity below which a texture of opacity cuts the surface away.
const MASK_CUTOFF: f32 = 0.5;

/// The materials of an OBJ file.
pub struct Library<'a> {
    folder: &'a Path,
    by_name: HashMap<String, u32>,
    default: Option<u32>,
    pictures: Pictures,
    /// Names of base-colour and opacity files to texture of the scene.
    textures: HashMap<(String, String), Option<u32>>,
}

/// A material as it stands in the file.
#[derive(Default)]
struct Entry {
    name: String,
    diffuse: Option<[f32; 3]>,
    emission: [f32; 3],
    dissolve: Option<f32>,
    transparency: Option<f32>,
    metallic: f32,
    roughness: Option<f32>,
    colour_file: String,
    opacity_file: String,
}

impl<'a> Library<'a> {
    pub fn new(folder: &'a Path) -> Self {
        let (by_name, textures) = (HashMap::new(), HashMap::new());
        Library { folder, by_name, default: None, pictures: Pictures::default(), textures }
    }

    /// The index of a material; the default one, with a note, where no library has it.
    pub fn find(&mut self, name: &str, out: &mut Assembler) -> u32 {
        if let Some(&material) = self.by_name.get(name) {
            return material;
        }
        out.note(format!("material `{name}` is not defined: grey is used"));
        self.default_material(out)
    }

    /// The index of a grey material.
    pub fn default_material(&mut self, out: &mut Assembler) -> u32 {
        let default = Material::diffuse("default", Vec3::splat(DEFAULT_ALBEDO));
        *self.default.get_or_insert_with(|| out.add_material(default))
    }

    /// Reads one library, or several whose names stand side by side; a name may hold blanks.
    pub fn load_all(&mut self, names: &str, out: &mut Assembler) -> Result<(), FileError> {
        if self.file(names).exists() {
            return self.load(names, out);
        }
        let words: Vec<&str> = names.split_whitespace().collect();
        if words.iter().any(|word| self.file(word).exists()) {
            return words.into_iter().try_for_each(|word| self.load(word, out));
        }
        self.load(names, out)
    }

    /// Reads a library; one that is missing is noted.
    fn load(&mut self, name: &str, out: &mut Assembler) -> Result<(), FileError> {
        let bytes = match external::read(&self.file(name), MAX_FILE_BYTES) {
            Ok(bytes) => bytes,
            Err(reason) => {
                out.note(format!("material library `{name}` {}", external::in_a_sentence(&reason)));
                return Ok(());
            }
        };
        let text = String::from_utf8_lossy(&bytes);
        let mut entry = None;
        for (line, statement) in statements(&text) {
            let context = |e| match at_line(line, e) {
                FileError::Malformed(reason) => FileError::Malformed(format!("material library `{name}`, {reason}")),
                other => other,
            };
            let (key, value) = statement.split_once(char::is_whitespace).unwrap_or((&statement, ""));
            if key == "newmtl" {
                let next = Entry { name: value.trim().to_owned(), ..Entry::default() };
                if let Some(done) = entry.replace(next) {
                    self.add(done, out).map_err(context)?;
                }
            } else if let Some(entry) = &mut entry {
                entry.set(key, value).map_err(context)?;
            }
        }
        match entry {
            Some(last) => self.add(last, out),
            None => Ok(()),
        }
    }

    fn add(&mut self, entry: Entry, out: &mut Assembler) -> Result<(), FileError> {
        let opacity = entry.dissolve.or(entry.transparency.map(|t| 1.0 - t)).unwrap_or(1.0);
        let alpha = match (opacity < 1.0, entry.opacity_file.is_empty()) {
            (true, _) => Alpha::Blend,
            (false, true) => Alpha::Opaque,
            (false, false) => Alpha::Mask(MASK_CUTOFF),
        };
        let texture = self.texture(&entry, out)?;
        // A picture without a colour beside it is the colour.
        let albedo = if texture.is_some() && !entry.colour_file.is_empty() { 1.0 } else { DEFAULT_ALBEDO };
        let mut material = Material {
            albedo: entry.diffuse.map_or(Vec3::splat(albedo), Vec3::from_array),
            texture,
            wrap: [Wrap::Repeat; 2],
            alpha_factor: opacity,
            alpha,
            emission: Vec3::from_array(entry.emission),
            metallic: entry.metallic,
            roughness: entry.roughness.unwrap_or(1.0),
            name: entry.name.clone(),
        };
        make_legal(&mut material, out)?;
        let index = out.add_material(material);
        self.by_name.insert(entry.name, index);
        Ok(())
    }

    /// The base-colour texture, with the texture of opacity in its alpha.
    fn texture(&mut self, entry: &Entry, out: &mut Assembler) -> Result<Option<u32>, FileError> {
        let key = (entry.colour_file.clone(), entry.opacity_file.clone());
        if let Some(&texture) = self.textures.get(&key) {
            return Ok(texture);
        }
        let colour = self.picture(&entry.colour_file, out)?;
        let opacity = self.picture(&entry.opacity_file, out)?;
        let texture = match (colour, opacity) {
            (None, None) => None,
            (Some(colour), None) => Some(colour),
            (colour, Some(opacity)) => Some(with_opacity(colour, &opacity)),
        };
        let index = texture.map(|texture| {
            out.scene.textures.push(texture);
            out.scene.textures.len() as u32 - 1
        });
        self.textures.insert(key, index);
        Ok(index)
    }

    fn picture(&mut self, name: &str, out: &mut Assembler) -> Result<Option<Texture>, FileError> {
        if name.is_empty() {
            return Ok(None);
        }
        match external::read(&self.file(name), MAX_FILE_BYTES) {
            Ok(bytes) => self.pictures.decode(name, &bytes).map(Some),
            Err(reason) => {
                out.note(format!("texture `{name}` {}", external::in_a_sentence(&reason)));
                Ok(None)
            }
        }
    }

    /// A file beside the scene; many files come from Windows.
    fn file(&self, name: &str) -> PathBuf {
        self.folder.join(name.replace('\\', "/"))
    }
}

impl Entry {
    fn set(&mut self, key: &str, value: &str) -> Result<(), FileError> {
        let words: Vec<&str> = value.split_whitespace().collect();
        match key {
            "Kd" => self.diffuse = Some(colour(&words)?),
            "Ke" => self.emission = colour(&words)?,
            "d" => self.dissolve = Some(scalar(words.last())?),
            "Tr" => self.transparency = Some(scalar(words.last())?),
            "Pm" => self.metallic = scalar(words.last())?,
            "Pr" => self.roughness = Some(scalar(words.last())?),
            "map_Kd" => self.colour_file = file_name(&words),
            "map_d" => self.opacity_file = file_name(&words),
            _ => {}
        }
        Ok(())
    }
}

/// `r g b`, or `r` alone for grey.
fn colour(words: &[&str]) -> Result<[f32; 3], FileError> {
    if matches!(words.first(), Some(&("spectral" | "xyz"))) {
        return Err(FileError::Malformed("colours as spectra or CIE XYZ are not supported".into()));
    }
    match numbers::<f32, 3>(words)? {
        (rgb, 3) => Ok(rgb),
        (grey, 1) => Ok([grey[0]; 3]),
        (_, count) => Err(FileError::Malformed(format!("a colour needs 3 numbers, {count} are given"))),
    }
}

fn scalar(word: Option<&&str>) -> Result<f32, FileError> {
    let word = word.ok_or_else(|| FileError::Malformed("a number is missing".into()))?;
    word.parse().map_err(|_| FileError::Malformed(format!("`{word}` is not a number")))
}

/// The file name after a texture's options.
fn file_name(words: &[&str]) -> String {
    let mut rest = words;
    while let Some((option, after)) = rest.split_first().filter(|(word, _)| word.starts_with('-')) {
        let (least, most) = match *option {
            "-o" | "-s" | "-t" => (1, 3),
            "-mm" => (2, 2),
            _ => (1, 1),
        };
        let is_number = |word: &&&str| word.parse::<f32>().is_ok();
        let count = if most > least { after.iter().take(most).take_while(is_number).count().max(least) } else { least };
        rest = after.get(count..).unwrap_or_default();
    }
    rest.join(" ")
}

/// A texture whose alpha is the opacity picture's: its own alpha where it has any, otherwise its brightness.
fn with_opacity(colour: Option<Texture>, opacity: &Texture) -> Texture {
    let has_alpha = opacity.srgba.iter().any(|t| t[3] < 255);
    let mut texture = colour.unwrap_or_else(|| Texture {
        width: opacity.width,
        height: opacity.height,
        srgba: vec![[255; 4]; opacity.srgba.len()],
    });
    let (width, height) = (texture.width as usize, texture.height as usize);
    for (i, texel) in texture.srgba.iter_mut().enumerate() {
        let (x, y) = (i % width * opacity.width as usize / width, i / width * opacity.height as usize / height);
        let source = opacity.srgba[y * opacity.width as usize + x];
        texel[3] = if has_alpha { source[3] } else { source[0] };
    }
    texture
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_before_a_file_name_are_skipped() {
        let name = |text: &str| file_name(&text.split_whitespace().collect::<Vec<_>>());
        assert_eq!(name("brick wall.png"), "brick wall.png");
        assert_eq!(name("-blendu off -s 2 2 1 brick.png"), "brick.png");
        assert_eq!(name("-o 0.5 brick.png"), "brick.png");
        assert_eq!(name("-mm 0 1 -clamp on brick.png"), "brick.png");
        assert_eq!(name("-s"), "");
    }

    #[test]
    fn opacity_goes_into_alpha_whatever_the_sizes() {
        let opacity = Texture { width: 2, height: 1, srgba: vec![[0, 0, 0, 255], [200, 200, 200, 255]] };
        let colour = Texture { width: 4, height: 1, srgba: vec![[9, 8, 7, 255]; 4] };
        let texture = with_opacity(Some(colour), &opacity);
        assert_eq!(texture.srgba.iter().map(|t| t[3]).collect::<Vec<_>>(), [0, 0, 200, 200]);
        assert_eq!(texture.srgba[0][..3], [9, 8, 7]);
        assert_eq!(with_opacity(None, &opacity).srgba[1], [255, 255, 255, 200]);
    }
}
