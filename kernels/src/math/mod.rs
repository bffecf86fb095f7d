//! Mathematics that kernels share; imports no method.

pub mod float;
