//! What another renderer imports to shade with sparse radiance probes.
//!
//! Receivers: [`blended`] reads the irradiance of a blend of receivers, [`blended4`] its order-1 radiance, from which
//! [`crate::math::sh::irradiance`] makes irradiance for any normal and [`dominant_light`] with [`ggx`] and [`schlick`] a
//! glossy reflection. Probes: [`cosine_lobe`] and [`support`] are what [`probe_light`] weighs a probe's coefficients with.

pub use super::glossy::{dominant_light, ggx, schlick};
pub use super::normals::blended as blended4;
pub use super::probe_light::{cosine_lobe, light as probe_light, support};
pub use super::resolve::blended;
