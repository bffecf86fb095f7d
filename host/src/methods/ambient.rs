//! The fitted control: one constant indirect irradiance for the whole picture, the best that "ambient light" can do.

use super::settings::parse;
use super::{Input, Method, MethodError, MethodRow, Setting, Settings, StageClock, receivers};
use crate::exec::{BufferId, Executor};
use crate::reference::{self, Receiver, ReferenceSettings};
use glam::{Vec3, Vec4};

/// Row of the methods table.
pub const ROW: MethodRow = MethodRow {
    name: "ambient",
    control: true,
    summary: "Control: a constant, fitted to the mean of the truth over the visible points.",
    good_when: "Evenly lit scenes, or when indirect light is a small part.",
    fails_when: "Wherever indirect light varies: its error is the contrast of the truth.",
    settings: &[
        Setting {
            key: "irradiance",
            default: "fit",
            allowed: "`fit` or three numbers of at least 0: r,g,b in W/m²",
            help: "The constant; `fit` takes the mean of the truth, or of a few paths from visible points.",
        },
        Setting {
            key: "fit_points",
            default: "1024",
            allowed: "a whole number from 1 to 1048576",
            help: "Visible points that `fit` traces from: more give a constant closer to the true mean.",
        },
    ],
    ladder: &[("constant", &[])],
    new: |settings| {
        let fit_points = parse(&ROW, settings, "fit_points", |n: &usize| (1..=1 << 20).contains(n))?;
        Ok(Box::new(Ambient { constant: constant(settings)?, fit_points }))
    },
};

/// Paths per point of a fit: with a thousand points the mean is good to about a per cent.
const FIT_SPP: u32 = 16;

struct Ambient {
    constant: Option<Vec3>,
    fit_points: usize,
}

fn constant(settings: &Settings) -> Result<Option<Vec3>, MethodError> {
    let text: String = parse(&ROW, settings, "irradiance", |_| true)?;
    if text.trim() == "fit" {
        return Ok(None);
    }
    let parts: Result<Vec<f32>, _> = text.split(',').map(|part| part.trim().parse::<f32>()).collect();
    match parts.as_deref() {
        Ok(&[r, g, b]) if [r, g, b].iter().all(|x| x.is_finite() && *x >= 0.0) => Ok(Some(Vec3::new(r, g, b))),
        _ => Err(MethodError::BadValue {
            method: ROW.name,
            key: "irradiance".into(),
            value: text,
            expected: ROW.settings[0].allowed.into(),
        }),
    }
}

impl Ambient {
    /// Mean of the truth where there is one, otherwise of a few paths from evenly spread visible points.
    fn fit(&self, input: &Input<'_>, receivers: &[Receiver]) -> Result<Vec3, MethodError> {
        if let Some(mean) = input.true_mean {
            return Ok(mean);
        }
        let visible: Vec<Receiver> = receivers.iter().copied().filter(|r| r.normal != Vec3::ZERO).collect();
        let step = visible.len().div_ceil(self.fit_points).max(1);
        let chosen: Vec<Receiver> = visible.into_iter().skip(step / 2).step_by(step).collect();
        let settings = ReferenceSettings { spp: Some(FIT_SPP), seed: input.seed, ..Default::default() };
        let traced = reference::irradiance(input.scene, &chosen, &settings, &mut |_| {})?;
        let sum: Vec3 = traced.values.iter().map(|t| t.indirect).sum();
        Ok(sum / traced.values.len().max(1) as f32)
    }
}

impl Method for Ambient {
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
        if self.constant.is_none() {
            clock.stage(exec, "fit", |exec| {
                let receivers = receivers(exec, gbuffer)?;
                self.constant = Some(self.fit(input, &receivers)?);
                Ok::<(), MethodError>(())
            })?;
        }
        let constant = self.constant.unwrap_or(Vec3::ZERO);
        clock.stage(exec, "fill", |exec| {
            let count = exec.size_bytes(irradiance) as usize / size_of::<Vec4>();
            Ok(exec.write(irradiance, bytemuck::cast_slice(&vec![constant.extend(0.0); count]))?)
        })
    }

    fn needs(&self) -> serde_json::Value {
        serde_json::json!({ "irradiance": self.constant.map(|c| c.to_array()) })
    }
}
