//! The lower control: direct light alone, no indirect irradiance. Every method must beat it.

use super::{Input, Method, MethodError, MethodRow, StageClock};
use crate::exec::{BufferId, Executor};

/// Row of the methods table.
pub const ROW: MethodRow = MethodRow {
    name: "direct",
    control: true,
    summary: "Control: no indirect light at all.",
    good_when: "Scenes in the open, where the sky and the sun outweigh what surfaces reflect.",
    fails_when: "Every interior: corners and shadows are black.",
    settings: &[],
    ladder: &[("direct", &[])],
    new: |_| Ok(Box::new(Direct)),
};

struct Direct;

impl Method for Direct {
    fn precompute(&mut self, _: &mut dyn Executor, _: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        Ok(())
    }

    fn light_change(&mut self, _: &mut dyn Executor, _: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        Ok(())
    }

    fn frame(
        &mut self,
        exec: &mut dyn Executor,
        _: &Input<'_>,
        _gbuffer: BufferId,
        irradiance: BufferId,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        clock.stage(exec, "clear", |exec| Ok(exec.clear(irradiance)?))
    }
}
