//! The truth as a method: path-traced irradiance at every visible point, on the CPU whatever the executor.
//!
//! Shows what plain path tracing costs for an error, beside the methods that approximate it. With few samples its
//! error is noise alone. Its seed differs from the truth's, so that it is judged like any other method.

use super::settings::parse;
use super::{Input, Method, MethodError, MethodRow, Setting, StageClock, receivers};
use crate::exec::{BufferId, Executor};
use crate::reference::{self, ReferenceSettings};
use glam::Vec4;

/// Row of the methods table.
pub const ROW: MethodRow = MethodRow {
    name: "reference",
    control: true,
    summary: "The path tracer itself, at a fixed number of paths per pixel.",
    good_when: "Offline, or when nothing is known of the scene: it has no bias and no failure but noise.",
    fails_when: "Real time: its noise falls only with the square root of the time.",
    settings: &[Setting {
        key: "spp",
        default: "64",
        allowed: "a whole number from 2 to 65536",
        help: "Paths per pixel: four times as many halve the noise and take four times as long.",
    }],
    ladder: &[
        ("2 spp", &[("spp", "2")]),
        ("8 spp", &[("spp", "8")]),
        ("32 spp", &[("spp", "32")]),
        ("128 spp", &[("spp", "128")]),
        ("512 spp", &[("spp", "512")]),
    ],
    new: |settings| {
        let spp = parse(&ROW, settings, "spp", |spp: &u32| (2..=65_536).contains(spp))?;
        Ok(Box::new(PathTraced { spp }))
    },
};

/// Keeps the method's random numbers apart from those of the truth that it is compared with.
const SEED_OF_METHOD: u32 = 0x5EED_0001;

struct PathTraced {
    spp: u32,
}

impl Method for PathTraced {
    fn precompute(&mut self, _: &mut dyn Executor, _: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        Ok(())
    }

    fn light_change(&mut self, _: &mut dyn Executor, _: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        Ok(())
    }

    fn frame(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        gbuffer: BufferId,
        irradiance: BufferId,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        clock.stage(exec, "path-trace", |exec| {
            let receivers = receivers(exec, gbuffer)?;
            let settings =
                ReferenceSettings { spp: Some(self.spp), seed: input.seed ^ SEED_OF_METHOD, ..Default::default() };
            let traced = reference::irradiance(input.scene, &receivers, &settings, &mut |_| {})?;
            let out: Vec<Vec4> = traced.values.iter().map(|value| value.indirect.extend(0.0)).collect();
            Ok(exec.write(irradiance, bytemuck::cast_slice(&out))?)
        })
    }
}
