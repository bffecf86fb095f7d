//! Collects triangles in world space, whatever the file format: the checks and simplifications that hold for all.

use super::super::origin::local_origin;
use super::super::{Alpha, Camera, FileError, Light, LoadOptions, Material, Scene};
use super::{MAX_COORDINATE_M, camera_fit};
use glam::{DVec3, Vec2, Vec3};

/// Triangles of one material, in world space.
pub struct Part<'a> {
    /// Name of the mesh, for errors.
    pub mesh: &'a str,
    /// Vertex positions.
    pub positions: Vec<DVec3>,
    /// One per position, of any length; without them each triangle gets its geometric normal.
    pub normals: Option<Vec<Vec3>>,
    /// One per position.
    pub uvs: Option<Vec<Vec2>>,
    /// One per position.
    pub colours: Option<Vec<Vec3>>,
    /// One per position.
    pub lightmap_uvs: Option<Vec<Vec2>>,
    /// Index into [`Scene::materials`].
    pub material: u32,
}

/// A scene in the making. Positions stay in double precision until all are known.
pub struct Assembler {
    pub scene: Scene,
    positions: Vec<DVec3>,
    camera_positions: Vec<DVec3>,
    light_positions: Vec<DVec3>,
    options: LoadOptions,
    zero_area_count: usize,
    glass_count: usize,
    has_all_lightmap_uvs: bool,
}

impl Assembler {
    pub fn new(options: &LoadOptions) -> Self {
        let scene = Scene { environment: options.environment.unwrap_or(Vec3::ZERO), ..Scene::default() };
        Assembler {
            scene,
            positions: Vec::new(),
            camera_positions: Vec::new(),
            light_positions: Vec::new(),
            options: options.clone(),
            zero_area_count: 0,
            glass_count: 0,
            has_all_lightmap_uvs: true,
        }
    }

    /// Says something about the import to the user, once.
    pub fn note(&mut self, note: impl Into<String>) {
        let note = note.into();
        if !self.scene.notes.contains(&note) {
            self.scene.notes.push(note);
        }
    }

    /// Appends a material whose values are brought into their legal range, and returns its index.
    pub fn add_material(&mut self, material: Material) -> u32 {
        self.scene.materials.push(material);
        self.scene.materials.len() as u32 - 1
    }

    /// Appends a camera at a position.
    pub fn add_camera(&mut self, camera: Camera, position: DVec3) {
        self.scene.cameras.push(camera);
        self.camera_positions.push(position);
    }

    /// Appends a light at a position.
    pub fn add_light(&mut self, light: Light, position: DVec3) {
        self.scene.lights.push(light);
        self.light_positions.push(position);
    }

    /// Appends the triangles of a part; only vertices that a triangle uses are kept.
    pub fn add(&mut self, part: &Part, triangles: impl Iterator<Item = [u32; 3]>) -> Result<(), FileError> {
        check_positions(part)?;
        let glass = self.scene.materials[part.material as usize].alpha == Alpha::Blend;
        let mut kept = vec![u32::MAX; part.positions.len()];
        for vertices in triangles {
            let corners = corners_of(part, vertices)?;
            if glass {
                self.glass_count += 1;
            } else if normal(corners) == DVec3::ZERO {
                self.zero_area_count += 1;
            } else {
                self.add_triangle(part, vertices, corners, &mut kept)?;
            }
        }
        Ok(())
    }

    fn add_triangle(
        &mut self,
        part: &Part,
        vertices: [u32; 3],
        corners: [DVec3; 3],
        kept: &mut [u32],
    ) -> Result<(), FileError> {
        if self.scene.triangles.len() >= self.options.max_triangles {
            let (claimed, limit) = (self.options.max_triangles as u64 + 1, self.options.max_triangles as u64);
            return Err(FileError::TooLarge { what: "the number of triangles".into(), claimed, limit });
        }
        let flat = normal(corners).as_vec3();
        let vertices = vertices.map(|v| {
            // Without vertex normals no vertex is shared: each triangle has its own normal.
            let known = if part.normals.is_some() { kept[v as usize] } else { u32::MAX };
            if known != u32::MAX {
                return known;
            }
            kept[v as usize] = self.add_vertex(part, v as usize, flat);
            kept[v as usize]
        });
        self.scene.triangles.push(super::super::Triangle { vertices, material: part.material });
        Ok(())
    }

    fn add_vertex(&mut self, part: &Part, v: usize, flat: Vec3) -> u32 {
        let finite_uv = |uv: Vec2| if uv.is_finite() { uv } else { Vec2::ZERO };
        let scene = &mut self.scene;
        self.positions.push(part.positions[v]);
        scene.normals.push(part.normals.as_ref().and_then(|n| n[v].try_normalize()).unwrap_or(flat));
        scene.uvs.push(part.uvs.as_ref().map_or(Vec2::ZERO, |uvs| finite_uv(uvs[v])));
        let colour = part.colours.as_ref().map_or(Vec3::ONE, |colours| colours[v]);
        // Rounding is not to make a surface that reflects more than arrives, nor is a number that is none.
        scene.colours.push(if colour.is_finite() { colour.clamp(Vec3::ZERO, Vec3::ONE) } else { Vec3::ONE });
        scene.lightmap_uvs.push(part.lightmap_uvs.as_ref().map_or(Vec2::ZERO, |uvs| finite_uv(uvs[v])));
        self.has_all_lightmap_uvs &= part.lightmap_uvs.is_some();
        self.positions.len() as u32 - 1
    }

    /// The scene, with a camera, and with notes on what was dropped.
    pub fn finish(mut self) -> Result<Scene, FileError> {
        self.place();
        self.drop_degenerate();
        if self.scene.triangles.is_empty() {
            return Err(FileError::NoTriangles(self.dropped()));
        }
        if self.scene.colours.iter().all(|colour| *colour == Vec3::ONE) {
            self.scene.colours = Vec::new();
        }
        if !self.has_all_lightmap_uvs {
            self.scene.lightmap_uvs = Vec::new();
        }
        if self.zero_area_count > 0 {
            self.note(format!("{} triangles of zero area dropped", self.zero_area_count));
        }
        if self.glass_count > 0 {
            self.note(format!(
                "{} triangles of glass (alpha blending) dropped: it does not exist for light",
                self.glass_count
            ));
        }
        let view = self.options.view(&self.scene);
        self.scene.cameras.splice(..0, view);
        if self.scene.cameras.is_empty() {
            self.scene.cameras.push(camera_fit::fit(&self.scene));
            self.note("no camera in the file: where none is named, one that shows the scene stands in");
        }
        self.scene.lights.extend(self.options.sun_light());
        if !self.scene.is_lit() {
            self.note("no light, no emission and no environment: the result will be black");
        }
        Ok(self.scene)
    }

    /// Counts all positions from a point near by.
    fn place(&mut self) {
        let scene = &mut self.scene;
        let bounds = self.positions.iter().fold((DVec3::MAX, DVec3::MIN), |(lo, hi), p| (lo.min(*p), hi.max(*p)));
        let origin = local_origin(bounds.0, bounds.1);
        scene.origin = origin;
        scene.positions = std::mem::take(&mut self.positions).iter().map(|p| (*p - origin).as_vec3()).collect();
        for (camera, position) in scene.cameras.iter_mut().zip(&self.camera_positions) {
            camera.position = (*position - origin).as_vec3();
        }
        for (light, world) in scene.lights.iter_mut().zip(&self.light_positions) {
            light.position_mut().into_iter().for_each(|p| *p = (*world - origin).as_vec3());
        }
        if origin != DVec3::ZERO {
            let [x, y, z] = origin.to_array();
            self.note(format!("far from the origin for its size: coordinates are counted from {x}, {y}, {z} m"));
        }
    }

    /// Drops triangles that rounding to single precision has left without an area.
    fn drop_degenerate(&mut self) {
        let Scene { positions, triangles, .. } = &mut self.scene;
        let before = triangles.len();
        triangles.retain(|t| !is_degenerate(t.vertices.map(|v| positions[v as usize])));
        self.zero_area_count += before - triangles.len();
    }

    fn dropped(&self) -> String {
        match (self.zero_area_count, self.glass_count) {
            (0, 0) => String::new(),
            (zero, glass) => format!(" left ({zero} of zero area and {glass} of glass dropped)"),
        }
    }
}

fn check_positions(part: &Part) -> Result<(), FileError> {
    part.positions.iter().enumerate().try_for_each(|(vertex, &position)| check_position(part.mesh, vertex, position))
}

/// An error unless a position is finite and not absurdly far away.
pub fn check_position(mesh: &str, vertex: usize, position: DVec3) -> Result<(), FileError> {
    let reason = if !position.is_finite() {
        "is not finite".to_owned()
    } else if position.abs().max_element() > MAX_COORDINATE_M {
        format!("is more than {MAX_COORDINATE_M:e} m from the origin")
    } else {
        return Ok(());
    };
    Err(FileError::BadVertex { mesh: mesh.to_owned(), vertex, position: position.as_vec3().to_array(), reason })
}

fn corners_of(part: &Part, vertices: [u32; 3]) -> Result<[DVec3; 3], FileError> {
    let mut corners = [DVec3::ZERO; 3];
    for (corner, vertex) in corners.iter_mut().zip(vertices) {
        *corner = *part.positions.get(vertex as usize).ok_or_else(|| FileError::OutOfRange {
            what: format!("mesh `{}`: vertex index", part.mesh),
            index: i64::from(vertex),
            count: part.positions.len() as u64,
        })?;
    }
    Ok(corners)
}

/// Unit normal; zero for a triangle without area.
fn normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

/// Whether a triangle has no area, or so little that its normal cannot be had in f32.
fn is_degenerate([a, b, c]: [Vec3; 3]) -> bool {
    let [a64, b64, c64] = [a, b, c].map(Vec3::as_dvec3);
    let exact = (b64 - a64).cross(c64 - a64);
    let rounded = (b - a).cross(c - a);
    exact == glam::DVec3::ZERO || rounded.length_squared() < f32::MIN_POSITIVE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_without_area_are_recognised_and_thin_ones_kept() {
        let p = |x: f32, y: f32| Vec3::new(x, y, 0.3);
        assert!(is_degenerate([p(1.0, 1.0), p(1.0, 1.0), p(2.0, 0.0)]), "two equal corners");
        assert!(is_degenerate([p(0.1, 0.1), p(0.2, 0.2), p(0.7, 0.7)]), "corners on a line");
        assert!(is_degenerate([p(0.0, 0.0), p(1e-20, 0.0), p(0.0, 1e-20)]), "a normal that underflows");
        assert!(!is_degenerate([p(0.0, 0.0), p(1e-4, 0.0), p(0.0, 1e-4)]), "small, but well shaped");
        assert!(!is_degenerate([p(0.0, 0.0), p(10.0, 0.0), p(5.0, 1e-4)]), "a sliver of a tenth of a millimetre");
    }
}
