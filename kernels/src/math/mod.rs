//! Mathematics that kernels share; imports no method. Everything here compiles for devices and agrees on every target.

pub mod colour;
pub mod filter;
pub mod float;
pub mod frame;
pub mod octahedral;
pub mod pack;
pub mod rng;
pub mod sampling;
pub mod sh;
pub mod vector;
