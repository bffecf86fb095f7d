//! Sparse radiance probes (SRP): indirect light gathered at few probes, brought to many receivers by precomputed,
//! visibility-aware local transport. Silvennoinen & Lehtinen 2017, "Real-time Global Illumination by Precomputed Local
//! Reconstruction from Sparse Radiance Probes" (below: SL17); the thesis on its implementation from phones to
//! desktops in the engine LlamaEngine, below: LE.
//!
//! Precomputation, in order: [`charts`] and [`reach`] (the second UV set, and which sides of it light can reach), [`atlas`]
//! (lightmap texels as receivers), [`probes`], [`transport`] (with [`visibility`]), [`orders`], [`round_trip`] (which corrects it, with [`states`] and [`stand_in`]),
//! [`compress`]; [`plan`] runs them, [`mod@file`] keeps the result.
//! [`model`] is what it hands to run time. [`error_map`] shows where probes do not suffice, [`dictionary`] is another
//! way to compress.
//!
//! Deviations from SL17 and LE, with reasons in the modules: surfaces reflect on both sides, so that backs that can be
//! reached are receivers too; probes are spread over all open space by default (Lloyd's relaxation), SL17's thinning of what lies
//! beside surfaces is a setting; nothing is decided by rounding, so that a scene's unit and place do not change the bake;
//! the environment and emitters are direct light and never pass through the probes; receivers are points, not texel areas;
//! transport is corrected by least squares, and components are chosen for the light that they carry; each probe has an order of
//! its own in each cluster.

pub mod atlas;
pub mod charts;
pub mod compress;
pub mod dictionary;
pub mod error_map;
mod estimate;
pub mod feedback;
pub mod file;
pub mod memo;
pub mod model;
pub mod occluders;
pub mod orders;
pub mod packed;
pub mod plan;
pub mod probes;
pub mod reach;
pub mod round_trip;
pub mod runtime;
pub mod stand_in;
pub mod states;
pub mod synthetic;
pub mod transport;
pub mod visibility;
pub mod world;

mod method;

pub use compress::Compression;
pub use memo::Memo;
pub use method::{ROW, bake_options};
pub use model::{Cluster, SrpBake};
pub use plan::{BakeOptions, Plan, Window};
pub use probes::Placement;

/// Name of the method.
pub const NAME: &str = "srp";
