//! Sparse radiance probes (SRP): indirect light gathered at few probes, brought to many receivers by precomputed,
//! visibility-aware local transport. Silvennoinen & Lehtinen 2017, "Real-time Global Illumination by Precomputed Local
//! Reconstruction from Sparse Radiance Probes" (below: SL17); the thesis on its implementation from phones to
//! desktops in the engine LlamaEngine, below: LE.
//!
//! [`model`] is what precomputation hands to run time.

pub mod feedback;
pub mod model;
pub mod occluders;
pub mod packed;
pub mod runtime;
pub mod synthetic;

pub use model::{Cluster, SrpBake};
