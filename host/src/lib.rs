//! Global illumination measured against path-traced truth.
//!
//! [`scene`] loads or builds scenes, [`exec`] runs kernels on the CPU or through wgpu, [`methods`] holds every
//! lighting method, [`mod@reference`] the truth, `metrics` and `report` what is said of them; [`chart`] runs ladders of
//! settings, [`stress`] looks for failures, [`fit`] for the least that is good enough.

#[macro_use]
pub mod output;

pub mod chart;
pub mod cli;
pub mod error;
pub mod evaluate;
pub mod exec;
pub mod fit;
pub mod image_io;
pub mod memory;
pub mod methods;
pub mod metrics;
pub mod reference;
pub mod report;
pub mod scene;
pub mod shading;
pub mod stress;
