//! Scenes far from the world's origin: their coordinates are counted from a point near by.
//!
//! A map's coordinates, or a level that is laid out beside others, leave few of f32's 24 bits for the scene itself: at
//! 10⁵ m they are 8 mm apart. Files are therefore read in double precision, and what lies far away in relation to its
//! size is moved; [`Scene::origin`] tells where to. Nothing after import has to know.

use super::{Light, Scene};
use glam::{DVec3, Vec3};

/// A scene is moved where its centre's coordinates are more than this many times its half size: four bits of 24.
const FAR: f64 = 16.0;

/// The point that the coordinates of a box's content are best counted from: zero unless the box is far away. Its
/// coordinates are multiples of a power of two, so that subtracting it from f32 coordinates is exact.
pub(super) fn local_origin(min: DVec3, max: DVec3) -> DVec3 {
    let (centre, half) = (0.5 * (min + max), 0.5 * (max - min).max_element());
    let is_far = centre.abs().max_element() > FAR * half && half > 0.0 && centre.is_finite();
    let step = half.log2().floor().exp2();
    if is_far { (centre / step).round() * step } else { DVec3::ZERO }
}

impl Scene {
    /// Counts the coordinates of a scene that was made in code from a point near by, where it lies far from its origin.
    /// Import has done so already.
    pub fn recentre(&mut self) {
        let (min, max) = self.bounds();
        let origin = local_origin(min.as_dvec3(), max.as_dvec3());
        if origin == DVec3::ZERO {
            return;
        }
        let moved = |p: Vec3| (p.as_dvec3() - origin).as_vec3();
        self.positions.iter_mut().for_each(|p| *p = moved(*p));
        self.cameras.iter_mut().for_each(|camera| camera.position = moved(camera.position));
        self.lights.iter_mut().filter_map(Light::position_mut).for_each(|p| *p = moved(*p));
        self.origin += origin;
    }

    /// A position in the world (m).
    pub fn world(&self, position: Vec3) -> DVec3 {
        self.origin + position.as_dvec3()
    }

    /// A position of the world in the scene's coordinates.
    pub fn local(&self, world: DVec3) -> Vec3 {
        (world - self.origin).as_vec3()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::built_in;

    #[test]
    fn what_is_near_stays_and_what_is_far_comes_back_exactly() {
        for built_in in built_in::BUILT_IN {
            let scene = (built_in.make)();
            let mut same = scene.clone();
            same.recentre();
            assert_eq!((same.origin, same.content_hash()), (DVec3::ZERO, scene.content_hash()), "{}", built_in.name);
        }
        // Coordinates that f32 holds 10⁵ m away: multiples of 1/64 m.
        let mut scene = built_in::many_lights(4);
        scene.positions.iter_mut().for_each(|p| *p = (*p * 64.0).round() / 64.0);
        let near = scene.clone();
        let away = Vec3::new(1e5, -3.0, 2e4);
        scene.positions.iter_mut().for_each(|p| *p += away);
        scene.lights.iter_mut().filter_map(Light::position_mut).for_each(|p| *p += away);
        scene.recentre();
        assert!(scene.origin.distance(away.as_dvec3()) < 20.0, "{}", scene.origin);
        for (p, q) in scene.positions.iter().zip(&near.positions) {
            assert_eq!(scene.world(*p), q.as_dvec3() + away.as_dvec3());
            assert_eq!(scene.local(scene.world(*p)), *p);
        }
    }
}
