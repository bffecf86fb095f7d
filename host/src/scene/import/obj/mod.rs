//! Wavefront OBJ (Appendix B1 of the Advanced Visualizer manual): polygons, vertex normals, texture coordinates and
//! materials. Errors name the line.
//!
//! Statements may refer to vertices that come later in the file. Lines, points and curves are dropped.

mod mtl;
mod triangulate;

use super::super::{FileError, LoadOptions, Scene};
use super::assemble::{Assembler, Part, check_position};
use glam::{DVec3, Vec2, Vec3};
use mtl::Library;
use std::collections::HashMap;
use std::path::Path;
use std::str::FromStr;
use triangulate::triangulate;

/// Imports an `.obj` file with the material libraries and textures beside it.
pub fn load(bytes: &[u8], folder: &Path, options: &LoadOptions) -> Result<Scene, FileError> {
    let text = String::from_utf8_lossy(bytes);
    let mut importer = Importer {
        vertices: Vertices::read(&text)?,
        library: Library::new(folder),
        object: "unnamed".into(),
        material: None,
        seen: [0; 3],
        run: Run::default(),
        out: Assembler::new(options),
    };
    for (line, statement) in statements(&text) {
        importer.statement(&statement).map_err(|e| at_line(line, e))?;
    }
    importer.flush()?;
    importer.out.finish()
}

/// The lines that say something, numbered from 1, comments removed, and lines that end in `\` joined with the next.
fn statements(text: &str) -> impl Iterator<Item = (usize, String)> {
    let mut lines = text.lines().enumerate();
    std::iter::from_fn(move || {
        let (number, line) = lines.next()?;
        let mut statement = without_comment(line).to_owned();
        while let Some(begun) = statement.strip_suffix('\\') {
            statement = begun.to_owned() + " " + lines.next().map_or("", |(_, line)| without_comment(line));
        }
        Some((number + 1, statement.trim().to_owned()))
    })
    .filter(|(_, statement)| !statement.is_empty())
}

fn without_comment(line: &str) -> &str {
    line.split('#').next().unwrap_or_default().trim()
}

/// Says where in a file something is wrong.
fn at_line(line: usize, error: FileError) -> FileError {
    match error {
        FileError::Malformed(reason) => FileError::Malformed(format!("line {line}: {reason}")),
        FileError::OutOfRange { what, index, count } => {
            FileError::OutOfRange { what: format!("line {line}: {what}"), index, count }
        }
        other => other,
    }
}

/// Up to `N` numbers from the start of some words, the rest 0, and how many there were.
fn numbers<T: Copy + Default + FromStr, const N: usize>(words: &[&str]) -> Result<([T; N], usize), FileError> {
    let mut values = [T::default(); N];
    let count = words.len().min(N);
    for (value, word) in values.iter_mut().zip(words) {
        *value = word.parse().map_err(|_| FileError::Malformed(format!("`{word}` is not a number")))?;
    }
    Ok((values, count))
}

/// All vertex data of a file.
#[derive(Default)]
struct Vertices {
    positions: Vec<DVec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
}

impl Vertices {
    fn read(text: &str) -> Result<Self, FileError> {
        let mut vertices = Vertices::default();
        let mut object = "unnamed".to_owned();
        for (line, statement) in statements(text) {
            let words: Vec<&str> = statement.split_whitespace().collect();
            let at_least = |wanted: usize, got: usize| {
                let reason = format!("`{}` needs {wanted} numbers, {got} are given", words[0]);
                if got < wanted { Err(at_line(line, FileError::Malformed(reason))) } else { Ok(()) }
            };
            let read = |words: &[&str]| numbers::<f32, 3>(words).map_err(|e| at_line(line, e));
            match words[0] {
                "o" | "g" => object = words[1..].join(" "),
                "v" => {
                    let (p, count) = numbers::<f64, 3>(&words[1..]).map_err(|e| at_line(line, e))?;
                    at_least(3, count)?;
                    check_position(&object, vertices.positions.len(), p.into())?;
                    vertices.positions.push(p.into());
                }
                "vn" => {
                    let (n, count) = read(&words[1..])?;
                    at_least(3, count)?;
                    vertices.normals.push(n.into());
                }
                "vt" => {
                    let (uv, count) = read(&words[1..])?;
                    at_least(1, count)?;
                    // v points upwards in OBJ.
                    vertices.uvs.push(Vec2::new(uv[0], 1.0 - uv[1]));
                }
                _ => {}
            }
        }
        Ok(vertices)
    }
}

/// Indices of a corner's position, texture coordinates and normal.
type Corner = (u32, Option<u32>, Option<u32>);

/// Faces that follow each other and share object, material, and whether they have normals.
#[derive(Default)]
struct Run {
    has_normals: bool,
    index_of: HashMap<Corner, u32>,
    corners: Vec<Corner>,
    triangles: Vec<[u32; 3]>,
}

struct Importer<'a> {
    vertices: Vertices,
    library: Library<'a>,
    object: String,
    /// Index of the material in use; `None` before the first `usemtl`.
    material: Option<u32>,
    /// Positions, texture coordinates and normals above the current line: what negative indices count from.
    seen: [usize; 3],
    run: Run,
    out: Assembler,
}

impl Importer<'_> {
    fn statement(&mut self, statement: &str) -> Result<(), FileError> {
        let words: Vec<&str> = statement.split_whitespace().collect();
        match words[0] {
            "v" => self.seen[0] += 1,
            "vt" => self.seen[1] += 1,
            "vn" => self.seen[2] += 1,
            "f" | "fo" => self.face(&words[1..])?,
            "o" | "g" => {
                self.flush()?;
                self.object = words[1..].join(" ");
            }
            "usemtl" => {
                self.flush()?;
                self.material = Some(self.library.find(&words[1..].join(" "), &mut self.out));
            }
            "mtllib" => self.library.load_all(statement["mtllib".len()..].trim(), &mut self.out)?,
            "l" | "p" | "curv" | "curv2" | "surf" => {
                self.out.note("points, lines, curves and free-form surfaces dropped")
            }
            _ => {}
        }
        Ok(())
    }

    fn face(&mut self, words: &[&str]) -> Result<(), FileError> {
        if words.len() < 3 {
            self.out.note("faces of fewer than three corners dropped");
            return Ok(());
        }
        let corners = words.iter().map(|word| self.corner(word)).collect::<Result<Vec<_>, _>>()?;
        let has_normals = corners.iter().all(|c| c.2.is_some());
        if has_normals != self.run.has_normals {
            self.flush()?;
            self.run.has_normals = has_normals;
        }
        let position = |c: &Corner| self.vertices.positions[c.0 as usize];
        // Relative to the first corner: far from the origin single precision is too little.
        let positions: Vec<Vec3> = corners.iter().map(|c| (position(c) - position(&corners[0])).as_vec3()).collect();
        let Run { index_of, corners: known, triangles, .. } = &mut self.run;
        let indices: Vec<u32> = corners
            .into_iter()
            .map(|corner| {
                *index_of.entry(corner).or_insert_with(|| {
                    known.push(corner);
                    known.len() as u32 - 1
                })
            })
            .collect();
        triangles.extend(triangulate(&positions).into_iter().map(|t| t.map(|i| indices[i])));
        Ok(())
    }

    /// `position/texture/normal`, the last two optional.
    fn corner(&self, word: &str) -> Result<Corner, FileError> {
        let mut parts = word.split('/');
        let mut next = |kind: usize| match parts.next() {
            None | Some("") => Ok(None),
            Some(digits) => self.index(digits, kind).map(Some),
        };
        let (position, uv, normal) = (next(0)?, next(1)?, next(2)?);
        match position {
            Some(position) if parts.next().is_none() => Ok((position, uv, normal)),
            _ => Err(FileError::Malformed(format!("`{word}` is not a corner of a face"))),
        }
    }

    /// An index from 1, or a negative one counted back from the current line, as an index from 0.
    fn index(&self, digits: &str, kind: usize) -> Result<u32, FileError> {
        let names = ["vertex", "texture coordinate", "normal"];
        let count = [self.vertices.positions.len(), self.vertices.uvs.len(), self.vertices.normals.len()][kind];
        let index: i64 = digits.parse().map_err(|_| FileError::Malformed(format!("`{digits}` is not an index")))?;
        let from_zero = if index < 0 { (self.seen[kind] as i64).checked_add(index) } else { index.checked_sub(1) };
        match from_zero {
            Some(i) if (0..count as i64).contains(&i) => Ok(i as u32),
            _ => Err(FileError::OutOfRange { what: names[kind].into(), index, count: count as u64 }),
        }
    }

    /// Hands the current run to the scene.
    fn flush(&mut self) -> Result<(), FileError> {
        let next = Run { has_normals: self.run.has_normals, ..Run::default() };
        let run = std::mem::replace(&mut self.run, next);
        if run.triangles.is_empty() {
            return Ok(());
        }
        let material = match self.material {
            Some(material) => material,
            None => self.library.default_material(&mut self.out),
        };
        let vertices = &self.vertices;
        let part = Part {
            mesh: &self.object,
            positions: run.corners.iter().map(|c| vertices.positions[c.0 as usize]).collect(),
            normals: run.has_normals.then(|| {
                run.corners.iter().map(|c| c.2.map_or(Vec3::ZERO, |n| vertices.normals[n as usize])).collect()
            }),
            uvs: Some(run.corners.iter().map(|c| c.1.map_or(Vec2::ZERO, |uv| vertices.uvs[uv as usize])).collect()),
            colours: None,
            lightmap_uvs: None,
            material,
        };
        self.out.add(&part, run.triangles.into_iter())
    }
}
