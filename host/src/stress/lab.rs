//! One method with one set of settings, run on scenes made for a purpose.

use crate::error::Error;
use crate::evaluate::View;
use crate::exec::{BufferId, Executor, ExecutorExt};
use crate::image_io::{Image, ToneMap, png_bytes};
use crate::methods::{Input, Method, MethodRow, Settings, StageClock, Unit};
use crate::reference::trace::KeptTree;
use crate::reference::{self, Receiver, ReferenceSettings};
use crate::scene::device::SceneBuffers;
use crate::scene::{Camera, Light, Scene};
use glam::{DVec3, Quat, Vec3, Vec4};
use interreflect_shared::scene::Surfel;
use std::path::PathBuf;

/// Pixels along a side of the pictures that errors are measured on.
pub const SIDE_PX: u32 = 32;
/// Pixels of a block: jitter of single pixels is not what fails.
const BLOCK_PX: u32 = 8;

/// How much of an entry is measured.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Effort {
    /// The whole range of a parameter, and by bisection where the method begins to fail.
    #[default]
    Full,
    /// The ends of the range and its middle: enough to see whether what is known still holds.
    Ends,
}

/// Where a method is put to the test.
pub struct Lab {
    /// Method.
    pub row: &'static MethodRow,
    /// Every setting.
    pub settings: Settings,
    /// Seed of every random number.
    pub seed: u32,
    /// Folder of truths.
    pub cache: PathBuf,
    /// Where kernels run.
    pub exec: Box<dyn Executor>,
    /// How much is measured.
    pub effort: Effort,
    /// Whether the method gave a number that is not finite since this was last set to false: whatever a family makes of
    /// such numbers, they are a failure.
    pub not_finite: bool,
    /// The last scene and settings that the method ran with: what there is to show for an answer without a picture.
    pub last: Option<(Settings, Scene)>,
}

/// What a method made of a scene.
pub struct Measured {
    /// Indirect irradiance at the receivers (W/m²).
    pub values: Vec<Vec3>,
    /// The length that the method resolves in this scene.
    pub unit: Option<Unit>,
    /// Gain of its feedback loop, where it knows.
    pub gain: Option<f64>,
    /// Least irradiance and mean of what it holds before it cuts off what is negative, where it does.
    pub uncut: Option<[f64; 2]>,
}

impl Lab {
    /// The method's irradiance at surface points.
    ///
    /// # Errors
    /// What the method says.
    pub fn measure(&mut self, scene: &Scene, surfels: &[Surfel]) -> Result<Measured, Error> {
        let settings = self.settings.clone();
        self.measure_with(&settings, scene, surfels)
    }

    /// The same with other settings.
    ///
    /// # Errors
    /// What the method says.
    pub fn measure_with(&mut self, settings: &Settings, scene: &Scene, surfels: &[Surfel]) -> Result<Measured, Error> {
        self.session(settings, scene, surfels, |session| {
            session.light_change(scene)?;
            let values = session.frame(scene)?;
            let uncut = session.method.lowest_uncut(session.exec)?;
            Ok(Measured { values, unit: session.method.unit(), gain: session.method.feedback_gain(), uncut })
        })
    }

    /// Precomputes the method for a scene and hands it over, to change lights and make frames.
    ///
    /// # Errors
    /// What the method or `work` says.
    pub fn session<T>(
        &mut self,
        settings: &Settings,
        scene: &Scene,
        surfels: &[Surfel],
        work: impl FnOnce(&mut Session<'_>) -> Result<T, Error>,
    ) -> Result<T, Error> {
        self.last = Some((settings.clone(), scene.clone()));
        let exec = self.exec.as_mut();
        let mark = exec.mark();
        let not_finite = &mut self.not_finite;
        let result = (|| {
            let buffers = SceneBuffers::upload(exec, scene)?;
            let gbuffer = exec.upload_slice("gbuffer", surfels)?;
            let irradiance = exec.zeroed_slice::<Vec4>("irradiance", surfels.len())?;
            let mut method = (self.row.new)(settings)?;
            let input = Input { scene, buffers: &buffers, seed: self.seed, true_mean: None };
            method.precompute(exec, &input, &mut StageClock::default())?;
            let mut session = Session { exec, method, buffers, gbuffer, irradiance, seed: self.seed, not_finite };
            work(&mut session)
        })();
        self.exec.free_since(mark);
        result
    }

    /// The method's indirect light as the first camera of a scene sees it, as PNG; `None` where it shows nothing.
    pub fn snapshot(&mut self, (settings, scene): &(Settings, Scene)) -> Option<Vec<u8>> {
        let surfels = self.seen(scene, scene.cameras.first()?, SIDE_PX).ok()?;
        let values = self.measure_with(settings, scene, &surfels).ok()?.values;
        picture(&values, &values)
    }

    /// The surface points that a camera sees.
    ///
    /// # Errors
    /// What the executor says.
    pub fn seen(&mut self, scene: &Scene, camera: &Camera, side_px: u32) -> Result<Vec<Surfel>, Error> {
        let exec = self.exec.as_mut();
        let mark = exec.mark();
        let result = SceneBuffers::upload(exec, scene)
            .and_then(|buffers| View::new(exec, scene, &buffers, camera, (side_px, side_px), self.seed));
        self.exec.free_since(mark);
        Ok(result?.surfels)
    }

    /// The points as surface points of another scene: each on the plane of the triangle that it lies on there. A tree of its own gives
    /// every scene an order of triangles of its own.
    ///
    /// # Errors
    /// What the executor says.
    pub fn attach(&mut self, scene: &Scene, surfels: &[Surfel]) -> Result<Vec<Surfel>, Error> {
        let exec = self.exec.as_mut();
        let mark = exec.mark();
        let triangles = SceneBuffers::upload(exec, scene)
            .and_then(|buffers| exec.read_slice::<interreflect_shared::scene::SceneTriangle>(buffers.triangles));
        self.exec.free_since(mark);
        let corners: Vec<[DVec3; 3]> =
            triangles?.iter().map(|t| [t.v0, t.v1, t.v2].map(|v| Vec3::from(v).as_dvec3())).collect();
        let on = |s: &Surfel| match triangle_at(&corners, s) {
            Some(triangle) => Surfel { triangle, position: onto(corners[triangle as usize], s.position), ..*s },
            None => *s,
        };
        Ok(surfels.iter().map(on).collect())
    }

    /// The truth's indirect irradiance at surface points.
    ///
    /// # Errors
    /// What the path tracer says.
    pub fn truth(&self, scene: &Scene, surfels: &[Surfel], spp: u32) -> Result<Vec<Vec3>, Error> {
        self.truth_by(scene, surfels, spp, 77)
    }

    /// The same by other random numbers.
    ///
    /// # Errors
    /// What the path tracer says.
    pub fn truth_by(&self, scene: &Scene, surfels: &[Surfel], spp: u32, seed: u32) -> Result<Vec<Vec3>, Error> {
        let receivers: Vec<Receiver> = surfels.iter().map(Receiver::from).collect();
        let settings = ReferenceSettings { spp: Some(spp), seed, ..ReferenceSettings::default() };
        let truth =
            reference::cached_irradiance(&self.cache, &KeptTree::default(), scene, &receivers, &settings, &mut |_| {})?
                .truth;
        Ok(truth.values.iter().map(|v| v.indirect).collect())
    }

    /// The length that the method resolves in a scene: its name and metres; metres where it names none.
    ///
    /// # Errors
    /// What the method says.
    pub fn unit(&mut self, scene: &Scene, surfels: &[Surfel]) -> Result<(&'static str, f64), Error> {
        let settings = self.settings.clone();
        let unit = self.session(&settings, scene, &surfels[..1.min(surfels.len())], |s| Ok(s.method.unit()))?;
        Ok(unit.filter(|u| u.metres > 0.0).map_or(("metres", 1.0), |u| (u.name, f64::from(u.metres))))
    }

    /// The settings with some changed; `None` where the method has not all of them.
    pub fn changed(&self, changes: &[(&str, &str)]) -> Option<Settings> {
        let mut settings = self.settings.clone();
        for (key, value) in changes {
            *settings.get_mut(*key)? = (*value).to_string();
        }
        (self.row.new)(&settings).ok().map(|_| settings)
    }
}

/// A method that was precomputed for a scene.
pub struct Session<'a> {
    /// Where it runs.
    pub exec: &'a mut dyn Executor,
    /// The method.
    pub method: Box<dyn Method>,
    buffers: SceneBuffers,
    gbuffer: BufferId,
    irradiance: BufferId,
    seed: u32,
    not_finite: &'a mut bool,
}

impl Session<'_> {
    /// Takes the lights of a scene of the same geometry.
    ///
    /// # Errors
    /// What the method says.
    pub fn light_change(&mut self, scene: &Scene) -> Result<(), Error> {
        let input = Input { scene, buffers: &self.buffers, seed: self.seed, true_mean: None };
        Ok(self.method.light_change(self.exec, &input, &mut StageClock::default())?)
    }

    /// Puts the lights of a scene of the same geometry into the buffers that the next light change reads.
    ///
    /// # Errors
    /// What the executor says.
    pub fn relight(&mut self, scene: &Scene) -> Result<(), Error> {
        self.buffers = SceneBuffers::upload(self.exec, scene)?;
        Ok(())
    }

    /// Makes a frame of other surface points, as many as before.
    ///
    /// # Errors
    /// What the executor says.
    pub fn look_at(&mut self, surfels: &[Surfel]) -> Result<(), Error> {
        Ok(self.exec.write(self.gbuffer, bytemuck::cast_slice(surfels))?)
    }

    /// Irradiance at the points.
    ///
    /// # Errors
    /// What the method says.
    pub fn frame(&mut self, scene: &Scene) -> Result<Vec<Vec3>, Error> {
        let input = Input { scene, buffers: &self.buffers, seed: self.seed, true_mean: None };
        self.method.frame(self.exec, &input, self.gbuffer, self.irradiance, &mut StageClock::default())?;
        let values = self.exec.read_slice::<Vec4>(self.irradiance)?;
        let values: Vec<Vec3> = values.iter().map(|v| v.truncate()).collect();
        *self.not_finite |= values.iter().any(|v| !v.is_finite());
        Ok(values)
    }
}

/// The point of a triangle's plane that is nearest to a position.
fn onto([a, b, c]: [DVec3; 3], position: [f32; 3]) -> [f32; 3] {
    let p = Vec3::from(position).as_dvec3();
    let normal = (b - a).cross(c - a).normalize_or_zero();
    (p - normal * (p - a).dot(normal)).as_vec3().to_array()
}

/// The triangle that a surface point lies on: the nearest of those that face its way.
fn triangle_at(corners: &[[DVec3; 3]], s: &Surfel) -> Option<u32> {
    let (p, n) = (Vec3::from(s.position).as_dvec3(), Vec3::from(s.geometric_normal).as_dvec3());
    let distance = |[a, b, c]: &[DVec3; 3]| {
        let normal = (*b - *a).cross(*c - *a).normalize_or_zero();
        let outside = |from: &DVec3, to: &DVec3| (p - *from).dot((*to - *from).cross(normal).normalize_or_zero());
        let beside = outside(a, b).max(outside(b, c)).max(outside(c, a)).max(0.0);
        if normal.dot(n).abs() > 0.9 { (p - *a).dot(normal).abs() + beside } else { f64::INFINITY }
    };
    let nearest = (0..corners.len()).min_by(|i, j| distance(&corners[*i]).total_cmp(&distance(&corners[*j])))?;
    (distance(&corners[nearest]) < f64::INFINITY).then_some(nearest as u32)
}

/// Mean over values and channels.
pub fn mean(values: &[Vec3]) -> f64 {
    values.iter().map(|v| f64::from(v.element_sum())).sum::<f64>() / (3 * values.len().max(1)) as f64
}

/// Root mean square difference of block means over the mean of `truth`; pictures of [`SIDE_PX`] rows.
pub fn difference(picture: &[Vec3], truth: &[Vec3]) -> f64 {
    let side = (truth.len() as f64).sqrt().round() as u32;
    let block = BLOCK_PX.min(side.max(1));
    let blocks = side / block;
    let means = |values: &[Vec3]| -> Vec<Vec3> {
        (0..blocks * blocks)
            .map(|b| {
                let (x0, y0) = (b % blocks * block, b / blocks * block);
                let pixels = (0..block * block).map(|k| values[((y0 + k / block) * side + x0 + k % block) as usize]);
                pixels.sum::<Vec3>() / (block * block) as f32
            })
            .collect()
    };
    let (a, b) = (means(picture), means(truth));
    let square: f64 = a.iter().zip(&b).map(|(a, b)| f64::from((*a - *b).length_squared())).sum();
    let scale = mean(truth);
    let rms = (square / (3 * a.len().max(1)) as f64).sqrt();
    if scale > 0.0 { rms / scale } else { rms }
}

/// The scene scaled about the origin, turned about the vertical axis, then moved.
pub fn transformed(scene: &Scene, scale: f32, angle_rad: f32, offset: Vec3) -> Scene {
    let turn = Quat::from_rotation_y(angle_rad);
    let place = |p: Vec3| turn * (p * scale) + offset;
    let mut out = scene.clone();
    out.positions.iter_mut().for_each(|p| *p = place(*p));
    out.normals.iter_mut().for_each(|n| *n = turn * *n);
    for camera in &mut out.cameras {
        camera.position = place(camera.position);
        camera.forward = turn * camera.forward;
        camera.up = turn * camera.up;
    }
    for light in &mut out.lights {
        match light {
            // The same irradiance on the scaled surfaces.
            Light::Point { position, intensity } => {
                (*position, *intensity) = (place(*position), *intensity * (scale * scale));
            }
            Light::Spot { position, direction, intensity, .. } => {
                (*position, *direction, *intensity) =
                    (place(*position), turn * *direction, *intensity * (scale * scale));
            }
            Light::Directional { direction, .. } => *direction = turn * *direction,
        }
    }
    out
}

/// A picture of values as PNG, exposed like `like`.
pub fn picture(values: &[Vec3], like: &[Vec3]) -> Option<Vec<u8>> {
    let image = |v: &[Vec3]| {
        let side = (v.len() as f64).sqrt().round() as u32;
        let finite = v.iter().map(|v| if v.is_finite() { *v } else { Vec3::new(1e6, 0.0, 1e6) });
        Image::new(side, side, finite.collect()).ok()
    };
    let tone = ToneMap::from_truth(&image(like)?, &[]);
    png_bytes(&tone.apply(&image(values)?)).ok()
}
