//! Ray queries: closest hits, and whether anything is in the way.
//!
//! `walk.rs` goes through the tree of `tree.rs`, `ray.rs` tests boxes and triangles. Closest hits do not depend on the tree:
//! of equally distant triangles the one with the smallest index wins.

use super::ReferenceError;
use super::tree::Tree;
use super::walk;
use crate::scene::Scene;
use glam::Vec3;
use std::sync::{Arc, Mutex, PoisonError};

/// No triangle: nothing is excluded from a query.
pub const NO_TRIANGLE: u32 = u32::MAX;

/// Closest intersection of a ray.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hit {
    /// Distance in units of the direction's length.
    pub t: f32,
    /// Index into [`Scene::triangles`].
    pub triangle: u32,
    /// Weights of the three corners; they sum to 1.
    pub barycentric: Vec3,
}

/// A scene prepared for ray queries.
pub struct Tracer<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its triangles in boxes.
    pub(super) tree: Arc<Tree>,
}

/// The tree of one scene, built when a ray is first to be traced, for tracers that follow one another.
#[derive(Default)]
pub struct KeptTree(Mutex<Option<Arc<Tree>>>);

impl KeptTree {
    /// A tracer with the kept tree. The scene must be the same every time.
    ///
    /// # Errors
    /// As [`Tracer::new`].
    pub fn tracer<'a>(&self, scene: &'a Scene) -> Result<Tracer<'a>, ReferenceError> {
        // A tree is put there whole: a builder that panicked has left nothing behind.
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let tracer = match &*kept {
            Some(tree) => Tracer { scene, tree: tree.clone() },
            None => Tracer::new(scene)?,
        };
        *kept = Some(tracer.tree.clone());
        Ok(tracer)
    }
}

impl<'a> Tracer<'a> {
    /// Builds the tree.
    ///
    /// # Errors
    /// [`ReferenceError::BadScene`] where an index is out of range or a vertex is not finite;
    /// [`ReferenceError::TooDeep`] where the geometry is so degenerate that a walk's stack would not suffice.
    pub fn new(scene: &'a Scene) -> Result<Self, ReferenceError> {
        check(scene)?;
        Ok(Self { scene, tree: Arc::new(Tree::build(scene)?) })
    }

    /// Closest hit with 0 < t < `tmax` on any triangle but `exclude`.
    #[inline]
    pub fn closest(&self, origin: Vec3, direction: Vec3, tmax: f32, exclude: u32) -> Option<Hit> {
        walk::closest(self, origin, direction, tmax, exclude)
    }

    /// Whether anything but the triangles `exclude` lies on the ray at 0 < t < `tmax`.
    #[inline]
    pub fn occluded(&self, origin: Vec3, direction: Vec3, tmax: f32, exclude: [u32; 2]) -> bool {
        walk::occluded(self, origin, direction, tmax, exclude)
    }
}

/// The first thing in the scene that a traversal could not stand.
fn check(scene: &Scene) -> Result<(), ReferenceError> {
    let bad = |what: String| Err(ReferenceError::BadScene { what });
    for (i, t) in scene.triangles.iter().enumerate() {
        if t.vertices.iter().any(|&v| v as usize >= scene.positions.len()) {
            return bad(format!("triangle {i} has a vertex beyond the last one ({})", scene.positions.len()));
        }
        if t.material as usize >= scene.materials.len() {
            return bad(format!("triangle {i} has material {} of {}", t.material, scene.materials.len()));
        }
    }
    if let Some(i) = scene.positions.iter().position(|p| !p.is_finite()) {
        return bad(format!("vertex {i} is not finite"));
    }
    if scene.normals.len() != scene.positions.len() || scene.uvs.len() != scene.positions.len() {
        return bad(format!(
            "{} positions, {} normals, {} texture coordinates: not one each",
            scene.positions.len(),
            scene.normals.len(),
            scene.uvs.len()
        ));
    }
    for (i, m) in scene.materials.iter().enumerate() {
        if m.texture.is_some_and(|t| t as usize >= scene.textures.len()) {
            return bad(format!("material {i} (`{}`) has a texture beyond the last one", m.name));
        }
    }
    for (i, t) in scene.textures.iter().enumerate() {
        let texels = t.width as usize * t.height as usize;
        if texels == 0 || t.srgba.len() != texels {
            return bad(format!("texture {i} has {} texels, not {}×{} > 0", t.srgba.len(), t.width, t.height));
        }
    }
    Ok(())
}
