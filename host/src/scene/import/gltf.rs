//! glTF 2.0 (Khronos, `registry.khronos.org/glTF/specs/2.0`): nodes, meshes, cameras and lights.
//!
//! The JSON document is read with the `gltf` crate's types; everything that refers to something else is checked here.

use super::super::{Camera, FileError, Light, LoadOptions, Scene};
use super::MAX_COORDINATE_M;
use super::accessor::{Buffers, index_of, look_up};
use super::assemble::{Assembler, Part};
use super::container;
use super::material::{Materials, UvSource};
use ::gltf::json::camera::Type as CameraType;
use ::gltf::json::extensions::scene::khr_lights_punctual::Type as LightType;
use ::gltf::json::mesh::{Mode, Primitive, Semantic};
use ::gltf::json::validation::Checked;
use ::gltf::json::{Node, Root};
use glam::{DMat3, DMat4, DQuat, DVec3, Vec2, Vec3};
use std::path::Path;

/// Extensions that a file may require. KHR_mesh_quantization needs nothing but the component types that
/// [`Buffers::floats`] reads anyway.
const SUPPORTED_EXTENSIONS: [&str; 4] =
    ["KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_texture_transform", "KHR_mesh_quantization"];

/// Imports a `.glb` file.
pub fn load_binary(bytes: &[u8], folder: &Path, options: &LoadOptions) -> Result<Scene, FileError> {
    let glb = container::split(bytes)?;
    load_document(glb.json, glb.binary, folder, options)
}

/// Imports a `.gltf` file.
pub fn load_text(bytes: &[u8], folder: &Path, options: &LoadOptions) -> Result<Scene, FileError> {
    load_document(bytes, None, folder, options)
}

fn load_document(json: &[u8], binary: Option<&[u8]>, folder: &Path, options: &LoadOptions) -> Result<Scene, FileError> {
    let root: Root = ::gltf::json::deserialize::from_slice(json)
        .map_err(|e| FileError::Malformed(format!("the glTF document is not valid: {e}")))?;
    check_version_and_extensions(&root)?;
    let buffers = Buffers::read(&root, binary, folder)?;
    let mut out = Assembler::new(options);
    for name in root.extensions_used.iter().filter(|name| !SUPPORTED_EXTENSIONS.contains(&name.as_str())) {
        out.note(format!("the glTF extension {name} is ignored"));
    }
    let uv_sources = Materials::new(&root, folder).convert_all(&buffers, &mut out)?;
    let mut importer = Importer { root: &root, buffers, uv_sources, out };
    importer.visit_nodes()?;
    importer.out.finish()
}

fn check_version_and_extensions(root: &Root) -> Result<(), FileError> {
    let version = root.asset.min_version.as_ref().unwrap_or(&root.asset.version);
    let is_supported = version.split('.').next() == Some("2") && version != "2.1";
    if !is_supported {
        return Err(FileError::Malformed(format!("glTF of version {version}: only version 2.0 is supported")));
    }
    match root.extensions_required.iter().find(|name| !SUPPORTED_EXTENSIONS.contains(&name.as_str())) {
        Some(name) => Err(FileError::RequiredExtension { name: name.clone() }),
        None => Ok(()),
    }
}

struct Importer<'a> {
    root: &'a Root,
    buffers: Buffers<'a>,
    /// For each material, the default one last.
    uv_sources: Vec<UvSource>,
    out: Assembler,
}

impl<'a> Importer<'a> {
    /// Visits the nodes of the default scene (without one: of the first scene; without any: all nodes that are no
    /// node's child), parents before children, in the file's order.
    fn visit_nodes(&mut self) -> Result<(), FileError> {
        let mut pending: Vec<(usize, DMat4)> =
            self.root_nodes()?.into_iter().rev().map(|n| (n, DMat4::IDENTITY)).collect();
        let mut visited = vec![false; self.root.nodes.len()];
        while let Some((node_idx, world_from_parent)) = pending.pop() {
            let node = look_up(&self.root.nodes, node_idx, || "node".into())?;
            if std::mem::replace(&mut visited[node_idx], true) {
                let reason = format!("node {node_idx} is reached twice: nodes must form trees");
                return Err(FileError::Malformed(reason));
            }
            let world_from_node = world_from_parent * local_transform(node);
            if !world_from_node.is_finite() {
                return Err(FileError::Malformed(format!("node {node_idx} has a transform that is not finite")));
            }
            self.visit(node_idx, node, &world_from_node)?;
            let children = node.children.as_deref().unwrap_or_default();
            pending.extend(children.iter().rev().map(|child| (child.value(), world_from_node)));
        }
        Ok(())
    }

    fn root_nodes(&self) -> Result<Vec<usize>, FileError> {
        if self.root.scenes.is_empty() && self.root.scene.is_none() {
            let mut is_child = vec![false; self.root.nodes.len()];
            for child in self.root.nodes.iter().filter_map(|n| n.children.as_ref()).flatten() {
                if let Some(flag) = is_child.get_mut(child.value()) {
                    *flag = true;
                }
            }
            return Ok((0..is_child.len()).filter(|&n| !is_child[n]).collect());
        }
        let scene = look_up(&self.root.scenes, index_of(self.root.scene).unwrap_or(0), || "scene".into())?;
        Ok(scene.nodes.iter().map(|n| n.value()).collect())
    }

    fn visit(&mut self, node_idx: usize, node: &Node, world_from_node: &DMat4) -> Result<(), FileError> {
        let name = node.name.clone().unwrap_or_else(|| format!("node {node_idx}"));
        if let Some(mesh) = index_of(node.mesh) {
            self.add_mesh(&name, mesh, world_from_node)?;
        }
        if let Some(camera) = index_of(node.camera) {
            self.add_camera(&name, camera, world_from_node)?;
        }
        let light = node.extensions.as_ref().and_then(|e| e.khr_lights_punctual.as_ref());
        if let Some(light) = light {
            self.add_light(&name, light.light.value(), world_from_node)?;
        }
        if node.skin.is_some() {
            self.out.note("skins are ignored: such meshes stand as modelled");
        }
        Ok(())
    }

    fn add_mesh(&mut self, node: &str, mesh_idx: usize, world_from_mesh: &DMat4) -> Result<(), FileError> {
        let mesh = look_up(&self.root.meshes, mesh_idx, || format!("node `{node}`: mesh"))?;
        let name = mesh.name.clone().unwrap_or_else(|| format!("mesh {mesh_idx}"));
        for primitive in &mesh.primitives {
            self.add_primitive(&name, primitive, world_from_mesh)?;
        }
        Ok(())
    }

    fn add_primitive(&mut self, mesh: &str, primitive: &Primitive, world_from_mesh: &DMat4) -> Result<(), FileError> {
        let mode = match primitive.mode {
            Checked::Valid(mode @ (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan)) => mode,
            Checked::Valid(_) => {
                self.out.note("points and lines dropped");
                return Ok(());
            }
            Checked::Invalid => return Err(FileError::Malformed(format!("mesh `{mesh}`: unknown primitive mode"))),
        };
        self.note_ignored(primitive);
        let material = index_of(primitive.material).unwrap_or(self.root.materials.len());
        let uv_source = *look_up(&self.uv_sources, material, || format!("mesh `{mesh}`: material"))?;
        let Some(part) = self.part(mesh, primitive, material as u32, &uv_source, world_from_mesh)? else {
            self.out.note(format!("mesh `{mesh}`: a primitive without positions dropped"));
            return Ok(());
        };
        let indices = match index_of(primitive.indices) {
            Some(accessor) => Indices::Listed(self.buffers.indices(accessor, &format!("mesh `{mesh}`: indices"))?),
            None => Indices::Counted(part.positions.len()),
        };
        // A mirrored mesh would show its back (§3.7.4): its winding is reversed.
        let mirrored = world_from_mesh.determinant() < 0.0;
        let triangles = (0..indices.triangle_count(mode)).map(|t| {
            let [a, b, c] = indices.triangle(mode, t);
            if mirrored { [a, c, b] } else { [a, b, c] }
        });
        self.out.add(&part, triangles)
    }

    /// The vertices of a primitive in world space; `None` without positions.
    fn part<'b>(
        &mut self,
        mesh: &'b str,
        primitive: &Primitive,
        material: u32,
        uv_source: &UvSource,
        world_from_mesh: &DMat4,
    ) -> Result<Option<Part<'b>>, FileError> {
        let Some(positions) = self.attribute::<3>(mesh, primitive, Semantic::Positions, "POSITION")? else {
            return Ok(None);
        };
        let normals = self.attribute::<3>(mesh, primitive, Semantic::Normals, "NORMAL")?;
        let uvs = self.attribute::<2>(mesh, primitive, Semantic::TexCoords(uv_source.set), "TEXCOORD")?;
        let colours = self.attribute::<4>(mesh, primitive, Semantic::Colors(0), "COLOR_0")?;
        let lightmap_uvs = self.attribute::<2>(mesh, primitive, Semantic::TexCoords(1), "TEXCOORD_1")?;
        let lengths = [
            normals.as_ref().map(Vec::len),
            uvs.as_ref().map(Vec::len),
            colours.as_ref().map(Vec::len),
            lightmap_uvs.as_ref().map(Vec::len),
        ];
        if colours.as_ref().is_some_and(|colours| colours.iter().any(|c| c[3] != 1.0)) {
            self.out.note("the alpha of vertex colours is ignored");
        }
        if lengths.into_iter().flatten().any(|length| length != positions.len()) {
            return Err(FileError::Malformed(format!("mesh `{mesh}`: the vertex attributes differ in number")));
        }
        Ok(Some(Part {
            mesh,
            positions: transform_points(world_from_mesh, &positions),
            normals: normals.map(|normals| transform_normals(world_from_mesh, &normals)),
            uvs: uvs.map(|uvs| uvs.into_iter().map(|uv| uv_source.transform(uv)).collect()),
            colours: colours.map(|colours| colours.iter().map(|c| Vec3::new(c[0], c[1], c[2])).collect()),
            lightmap_uvs: lightmap_uvs.map(|uvs| uvs.into_iter().map(Vec2::from_array).collect()),
            material,
        }))
    }

    fn attribute<const N: usize>(
        &mut self,
        mesh: &str,
        primitive: &Primitive,
        semantic: Semantic,
        name: &str,
    ) -> Result<Option<Vec<[f32; N]>>, FileError> {
        let Some(accessor) = primitive.attributes.get(&Checked::Valid(semantic)) else { return Ok(None) };
        self.buffers.floats(accessor.value(), &format!("mesh `{mesh}`: {name}")).map(Some)
    }

    fn note_ignored(&mut self, primitive: &Primitive) {
        if primitive.targets.as_ref().is_some_and(|t| !t.is_empty()) {
            self.out.note("morph targets are ignored");
        }
    }

    /// A camera looks along its node's −Z, with +Y up (§3.10).
    fn add_camera(&mut self, node: &str, camera_idx: usize, world_from_node: &DMat4) -> Result<(), FileError> {
        let what = || format!("node `{node}`: camera");
        let source = look_up(&self.root.cameras, camera_idx, what)?;
        let Some(perspective) =
            source.perspective.as_ref().filter(|_| source.type_ == Checked::Valid(CameraType::Perspective))
        else {
            self.out.note(format!("the camera of node `{node}` has no perspective and is ignored"));
            return Ok(());
        };
        let malformed = |reason: &str| FileError::Malformed(format!("the camera of node `{node}` {reason}"));
        if !(perspective.yfov > 0.0 && perspective.yfov < std::f32::consts::PI) {
            return Err(malformed("has a field of view outside 0…π"));
        }
        let forward = direction(world_from_node, DVec3::NEG_Z).ok_or_else(|| malformed("has a singular transform"))?;
        let up_node = world_from_node.transform_vector3(DVec3::Y);
        let forward64 = forward.as_dvec3();
        let up = (up_node - forward64 * up_node.dot(forward64)).try_normalize();
        let position = point(world_from_node).ok_or_else(|| malformed("is absurdly far away"))?;
        let up = up.ok_or_else(|| malformed("has a singular transform"))?.as_vec3();
        let name = unique_name(source.name.as_deref().unwrap_or(node), &self.out.scene.cameras);
        let (node, fovy_rad) = (node.to_owned(), perspective.yfov);
        self.out.add_camera(Camera { name, node, position: Vec3::ZERO, forward, up, fovy_rad }, position);
        Ok(())
    }

    /// KHR_lights_punctual: the light shines along its node's −Z; a node's scale does not change it.
    fn add_light(&mut self, node: &str, light_idx: usize, world_from_node: &DMat4) -> Result<(), FileError> {
        let lights: &[_] = self.root.as_ref();
        let light: &::gltf::json::extensions::scene::khr_lights_punctual::Light =
            look_up(lights, light_idx, || format!("node `{node}`: light"))?;
        let malformed = |reason: &str| FileError::Malformed(format!("the light of node `{node}` {reason}"));
        let power = Vec3::from_array(light.color) * light.intensity;
        if !power.is_finite() || power.min_element() < 0.0 {
            return Err(malformed("has an intensity that is negative or not finite"));
        }
        if light.range.is_some() {
            self.out.note("the range of lights is ignored: light falls off with the square of the distance alone");
        }
        let world = point(world_from_node).ok_or_else(|| malformed("is absurdly far away"))?;
        let position = Vec3::ZERO;
        let along = direction(world_from_node, DVec3::NEG_Z).ok_or_else(|| malformed("has a singular transform"));
        let light = match light.type_ {
            Checked::Valid(LightType::Point) => Light::Point { position, intensity: power },
            Checked::Valid(LightType::Directional) => Light::Directional { direction: along?, irradiance: power },
            Checked::Valid(LightType::Spot) => {
                let cone = light.spot.as_ref().ok_or_else(|| malformed("is a spot without cone angles"))?;
                let (inner, outer) = (cone.inner_cone_angle, cone.outer_cone_angle);
                if !(0.0 <= inner && inner < outer && outer <= std::f32::consts::FRAC_PI_2 + 1e-5) {
                    return Err(malformed("has cone angles other than 0 ≤ inner < outer ≤ π/2"));
                }
                let (cos_inner, cos_outer) = (inner.cos(), outer.cos().max(0.0));
                Light::Spot { position, direction: along?, intensity: power, cos_inner, cos_outer }
            }
            Checked::Invalid => return Err(malformed("is of an unknown type")),
        };
        self.out.add_light(light, world);
        Ok(())
    }
}

/// The vertex indices of a primitive.
enum Indices {
    /// From an accessor.
    Listed(Vec<u32>),
    /// 0, 1, 2, … up to a number.
    Counted(usize),
}

impl Indices {
    /// Triangles of a primitive (§3.7.2.1); left-over vertices make none.
    fn triangle_count(&self, mode: Mode) -> usize {
        let count = match self {
            Indices::Listed(list) => list.len(),
            Indices::Counted(count) => *count,
        };
        if mode == Mode::Triangles { count / 3 } else { count.saturating_sub(2) }
    }

    fn triangle(&self, mode: Mode, t: usize) -> [u32; 3] {
        let corners = match mode {
            Mode::TriangleStrip => [t, t + 1 + t % 2, t + 2 - t % 2],
            Mode::TriangleFan => [t + 1, t + 2, 0],
            _ => [3 * t, 3 * t + 1, 3 * t + 2],
        };
        match self {
            Indices::Listed(list) => corners.map(|i| list[i]),
            Indices::Counted(_) => corners.map(|i| i as u32),
        }
    }
}

/// Transform of a node relative to its parent, in double precision.
fn local_transform(node: &Node) -> DMat4 {
    if let Some(matrix) = node.matrix {
        return DMat4::from_cols_array(&matrix.map(f64::from));
    }
    let vector = |v: Option<[f32; 3]>, default: DVec3| v.map_or(default, |v| DVec3::from_array(v.map(f64::from)));
    let rotation = node.rotation.map_or(DQuat::IDENTITY, |q| {
        let q = DQuat::from_array(q.0.map(f64::from));
        if q.length_squared() > 0.0 { q.normalize() } else { DQuat::IDENTITY }
    });
    let (scale, translation) = (vector(node.scale, DVec3::ONE), vector(node.translation, DVec3::ZERO));
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}

fn transform_points(world_from_mesh: &DMat4, points: &[[f32; 3]]) -> Vec<DVec3> {
    let transform = |p: &[f32; 3]| world_from_mesh.transform_point3(DVec3::from_array(p.map(f64::from)));
    points.iter().map(transform).collect()
}

/// Normals transform by the inverse transpose; the cofactor matrix is that up to a factor of the sign of the
/// determinant, and exists for singular transforms too.
fn transform_normals(world_from_mesh: &DMat4, normals: &[[f32; 3]]) -> Vec<Vec3> {
    let m = DMat3::from_mat4(*world_from_mesh);
    let sign = if m.determinant() < 0.0 { -1.0 } else { 1.0 };
    let cofactor = DMat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis));
    let transform = |n: &[f32; 3]| {
        let normal = cofactor * DVec3::from_array(n.map(f64::from)) * sign;
        normal.try_normalize().map_or(Vec3::ZERO, |n| n.as_vec3())
    };
    normals.iter().map(transform).collect()
}

/// Unit world direction of a local one; `None` where the transform takes its length away.
fn direction(world_from_node: &DMat4, local: DVec3) -> Option<Vec3> {
    world_from_node.transform_vector3(local).try_normalize().map(|d| d.as_vec3())
}

/// The node's origin in the world.
fn point(world_from_node: &DMat4) -> Option<DVec3> {
    let p = world_from_node.w_axis.truncate();
    (p.is_finite() && p.abs().max_element() <= MAX_COORDINATE_M).then_some(p)
}

/// The name, numbered where another camera bears it already.
fn unique_name(name: &str, cameras: &[Camera]) -> String {
    let taken = |candidate: &str| cameras.iter().any(|c| c.name == candidate);
    let numbered = (2..).map(|i| format!("{name} {i}"));
    std::iter::once(name.to_owned()).chain(numbered).find(|n| !taken(n)).expect("names do not run out")
}
