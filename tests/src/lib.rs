//! Test harness of Interreflect: every kernel's case on every executor, compared word by word.
//!
//! [`run`] runs a case and holds its output to what must be true of it alone; [`compare`] holds two outputs to each
//! other; [`gpu`] opens the adapters and decides whether a missing one is ignored or a failure. A check returns a
//! [`Failure`]; `tests/harness_fails.rs` provokes each of them.

pub mod browser;
pub mod compare;
pub mod failure;
pub mod gpu;
pub mod run;
pub mod suite;

pub use failure::Failure;
