//! `render --frames N --animate …`: a method over frames in which lights or objects move; only what changed is computed
//! again.

use super::args::RenderArgs;
use super::{print_json, setup};
use crate::error::Error;
use crate::evaluate::{View, median};
use crate::exec::{Executor, ExecutorExt};
use crate::image_io::{ToneMap, write_png, write_whole};
use crate::methods::{Input, Method, MethodRow, Settings, StageClock};
use crate::report;
use crate::scene::device::{PackedScene, SceneBuffers};
use crate::scene::{Light, Scene};
use glam::{Vec3, Vec4};
use serde_json::json;
use std::str::FromStr;
use std::time::Instant;

/// What moves.
#[derive(Clone, PartialEq, Debug)]
enum Target {
    /// Light of this index among those without a surface.
    Light(usize),
    /// All triangles of the material of this name.
    Object(String),
}

/// A straight path over all frames. Directional lights turn instead: the offset is added to their direction.
#[derive(Clone, PartialEq, Debug)]
pub struct Motion {
    target: Target,
    /// From the first frame to the last (m).
    offset: Vec3,
}

impl FromStr for Motion {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("`{text}` is not light:INDEX:DX,DY,DZ or object:MATERIAL:DX,DY,DZ");
        let mut parts = text.splitn(2, ':');
        let (kind, rest) = (parts.next().unwrap_or_default(), parts.next().ok_or_else(wrong)?);
        let (name, path) = rest.rsplit_once(':').ok_or_else(wrong)?;
        let numbers: Vec<f32> = path
            .split(',')
            .map(|n| n.trim().parse().ok().filter(|x: &f32| x.is_finite()))
            .collect::<Option<_>>()
            .ok_or_else(wrong)?;
        let offset = <[f32; 3]>::try_from(numbers).map(Vec3::from).map_err(|_| wrong())?;
        let target = match kind {
            "light" => Target::Light(name.parse().map_err(|_| wrong())?),
            "object" if !name.is_empty() => Target::Object(name.to_string()),
            _ => return Err(wrong()),
        };
        Ok(Self { target, offset })
    }
}

impl Motion {
    /// Checks that the scene has what moves.
    fn check(&self, scene: &Scene) -> Result<(), Error> {
        match &self.target {
            Target::Light(k) if *k >= scene.lights.len() => Err(Error::Usage(format!(
                "--animate light:{k}: the scene has {} lights without a surface",
                scene.lights.len()
            ))),
            Target::Object(name) if !scene.materials.iter().any(|m| m.name == *name) => {
                let names: Vec<&str> = scene.materials.iter().map(|m| m.name.as_str()).collect();
                Err(Error::Usage(format!("--animate object:{name}: the scene's materials are {}", names.join(", "))))
            }
            _ => Ok(()),
        }
    }

    fn moves_geometry(&self) -> bool {
        matches!(self.target, Target::Object(_))
    }

    /// Moves its target in `scene`, a copy of `first`, to the place at `time` from 0 to 1.
    fn apply(&self, first: &Scene, scene: &mut Scene, time: f32) {
        let offset = self.offset * time;
        match &self.target {
            Target::Light(k) => match (&first.lights[*k], &mut scene.lights[*k]) {
                (Light::Point { position: from, .. }, Light::Point { position, .. })
                | (Light::Spot { position: from, .. }, Light::Spot { position, .. }) => *position = *from + offset,
                (Light::Directional { direction: from, .. }, Light::Directional { direction, .. }) => {
                    *direction = (*from + offset).try_normalize().unwrap_or(*from);
                }
                _ => {}
            },
            Target::Object(name) => {
                let material = first.materials.iter().position(|m| m.name == *name).unwrap_or(usize::MAX) as u32;
                let mut moved = vec![false; first.positions.len()];
                for t in first.triangles.iter().filter(|t| t.material == material) {
                    t.vertices.iter().for_each(|&v| moved[v as usize] = true);
                }
                for (k, position) in scene.positions.iter_mut().enumerate().filter(|(k, _)| moved[*k]) {
                    *position = first.positions[k] + offset;
                }
            }
        }
    }
}

/// Times of one frame (ms), each phase 0 where it did not run.
struct FrameTimes {
    precompute: f64,
    light_change: f64,
    frame: f64,
    stages: Vec<(String, f64)>,
    needs: serde_json::Value,
}

/// Renders the frames: `frame-0000.png` and so on, and `frames.json` with the times of each.
pub fn run(args: &RenderArgs, row: &'static MethodRow, settings: &Settings, as_json: bool) -> Result<(), Error> {
    let out = &args.scene.out;
    let _folder = setup::output_folder(out)?;
    let (first, camera) = setup::load(&args.scene)?;
    args.animate.iter().try_for_each(|motion| motion.check(&first))?;
    let moves_geometry = args.animate.iter().any(Motion::moves_geometry);
    let mut exec = setup::executor(&args.device)?;
    let exec: &mut dyn Executor = exec.as_mut();

    let mut scene = first.clone();
    let mut packed = PackedScene::new(&scene);
    let mut buffers = packed.upload(exec)?;
    let mut mark = exec.mark();
    let mut method: Option<Box<dyn Method>> = None;
    let mut tone_map: Option<ToneMap> = None;
    let mut rows = Vec::new();
    for frame in 0..args.frames {
        let time = frame as f32 / (args.frames - 1).max(1) as f32;
        args.animate.iter().for_each(|motion| motion.apply(&first, &mut scene, time));
        if frame > 0 && moves_geometry {
            // Nothing of the old geometry is of use.
            exec.free_since(mark);
            method = None;
            free(exec, &buffers);
            packed = PackedScene::new(&scene);
            buffers = packed.upload(exec)?;
            mark = exec.mark();
        } else if frame > 0 {
            packed.relight(&scene);
            exec.write(buffers.lights, bytemuck::cast_slice(&packed.lights))?;
        }
        let view = View::new(exec, &scene, &buffers, &camera, args.scene.size, args.scene.seed)?;
        let input = Input { scene: &scene, buffers: &buffers, seed: args.scene.seed, true_mean: None };
        let irradiance = exec.zeroed_slice::<Vec4>("irradiance", view.surfels.len())?;
        let times = light(exec, &input, row, settings, &mut method, (view.gbuffer, irradiance))?;
        let picture = view.frame(&exec.read_slice::<Vec4>(irradiance)?);
        exec.free(irradiance);
        exec.free(view.gbuffer);
        // One exposure for all frames, or the picture would breathe.
        let tone = tone_map.get_or_insert_with(|| report::tone_map(&picture, &view.visible()));
        let path = out.join(format!("frame-{frame:04}.png"));
        write_png(&path, &tone.apply(&picture.full))?;
        rows.push(json!({
            "frame": frame, "time": time, "picture": path.file_name().map(|n| n.to_string_lossy().into_owned()),
            "time_ms": { "precompute": times.precompute, "light_change": times.light_change, "frame": times.frame,
                         "stages": times.stages.iter().map(|(n, ms)| json!([n, ms])).collect::<Vec<_>>() },
            "needs": times.needs,
        }));
    }
    finish(args, row, &scene, exec, rows, as_json)
}

fn free(exec: &mut dyn Executor, b: &SceneBuffers) {
    [b.nodes, b.triangles, b.attributes, b.surfaces, b.lights].into_iter().for_each(|buffer| exec.free(buffer));
}

/// Runs the phases that are due: all of a new method, light change and frame of one that is there.
fn light(
    exec: &mut dyn Executor,
    input: &Input<'_>,
    row: &MethodRow,
    settings: &Settings,
    method: &mut Option<Box<dyn Method>>,
    (gbuffer, irradiance): (crate::exec::BufferId, crate::exec::BufferId),
) -> Result<FrameTimes, Error> {
    let mut clock = StageClock::default();
    let mut precompute = 0.0;
    let mut lit = match method.take() {
        Some(lit) => lit,
        None => {
            let begin = Instant::now();
            let mut fresh = (row.new)(settings)?;
            fresh.precompute(exec, input, &mut clock)?;
            precompute = waited(exec, begin)?;
            fresh
        }
    };
    let begin = Instant::now();
    lit.light_change(exec, input, &mut clock)?;
    let light_change = waited(exec, begin)?;
    let begin = Instant::now();
    lit.frame(exec, input, gbuffer, irradiance, &mut clock)?;
    let frame = waited(exec, begin)?;
    let needs = lit.needs();
    *method = Some(lit);
    Ok(FrameTimes { precompute, light_change, frame, stages: clock.stages, needs })
}

/// Milliseconds since `begin`, when all that was asked for is done.
fn waited(exec: &mut dyn Executor, begin: Instant) -> Result<f64, Error> {
    exec.begin();
    exec.end()?;
    Ok(begin.elapsed().as_secs_f64() * 1e3)
}

fn finish(
    args: &RenderArgs,
    row: &MethodRow,
    scene: &Scene,
    exec: &mut dyn Executor,
    rows: Vec<serde_json::Value>,
    as_json: bool,
) -> Result<(), Error> {
    let of = |phase: &str| {
        let values = rows.iter().filter_map(|r| r["time_ms"][phase].as_f64()).skip(usize::from(rows.len() > 1));
        median(values.collect())
    };
    let medians = [of("precompute"), of("light_change"), of("frame")];
    let all = json!({
        "scene": scene.name, "method": row.name, "frames": rows,
        "median_ms_after_first": { "precompute": medians[0], "light_change": medians[1], "frame": medians[2] },
        "device": exec.device(),
    });
    let path = args.scene.out.join("frames.json");
    let text = serde_json::to_string_pretty(&all).expect("finite numbers and text keys");
    write_whole(&path, text.as_bytes())?;
    if as_json {
        print_json(&all);
    } else {
        let [precompute, light, frame] = medians;
        say!(
            "{} frames of {} by {}: after the first, precompute {precompute:.1} ms, light change {light:.1} ms, frame \
             {frame:.1} ms -> {}",
            args.frames,
            scene.name,
            row.name,
            path.display()
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_are_read_and_wrong_ones_named() {
        let motion: Motion = "light:2:0.5,0,-1".parse().unwrap();
        assert_eq!((motion.target, motion.offset), (Target::Light(2), Vec3::new(0.5, 0.0, -1.0)));
        let motion: Motion = "object:a:b:1,2,3".parse().unwrap();
        assert_eq!(motion.target, Target::Object("a:b".into()));
        for bad in ["", "light", "light:0", "light:x:1,2,3", "light:0:1,2", "light:0:1,2,nan", "sun:0:1,2,3"] {
            assert!(bad.parse::<Motion>().unwrap_err().contains(bad), "{bad}");
        }
    }

    #[test]
    fn motions_start_at_the_scene_and_move_only_their_target() {
        let first = crate::scene::built_in::many_lights(3);
        let mut scene = first.clone();
        let motion: Motion = "light:1:0,0,2".parse().unwrap();
        motion.check(&first).unwrap();
        motion.apply(&first, &mut scene, 0.0);
        assert_eq!(scene.lights, first.lights);
        motion.apply(&first, &mut scene, 0.5);
        let moved: Vec<bool> = scene.lights.iter().zip(&first.lights).map(|(a, b)| a != b).collect();
        assert_eq!(moved, [false, true, false]);
        assert!("light:7:0,0,1".parse::<Motion>().unwrap().check(&first).is_err());
        assert!("object:nothing:0,0,1".parse::<Motion>().unwrap().check(&first).is_err());
    }
}
