//! Float functions that give the same result on every target, or say how far they differ.
//!
//! The standard library's on the CPU, `num_traits` (GLSL.std.450) on a device and without `std`. Do not use the
//! targets' own `round`, `powi`, `min`/`max` with NaN, `asin`, `acos`, `atan`, `atan2`: they differ.

#[cfg(any(target_arch = "spirv", not(feature = "std")))]
use spirv_std::num_traits::Float;

/// Square root, correctly rounded everywhere.
#[inline(always)]
pub fn sqrt(x: f32) -> f32 {
    x.sqrt()
}
/// Magnitude, exact.
#[inline(always)]
pub fn abs(x: f32) -> f32 {
    x.abs()
}
/// Largest integer not above `x`, exact.
#[inline(always)]
pub fn floor(x: f32) -> f32 {
    x.floor()
}
/// Sine; `|x|` must stay below 8e6. Within 3e-7 on every target.
#[inline(always)]
pub fn sin(x: f32) -> f32 {
    x.sin()
}
/// Cosine; `|x|` must stay below 8e6. Within 3e-7 on every target.
#[inline(always)]
pub fn cos(x: f32) -> f32 {
    x.cos()
}
/// Natural exponential, relative error 3e-7 on every target.
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    x.exp()
}
/// Base-2 logarithm of a positive normal number, within 3e-7.
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    x.log2()
}
/// The smaller number; `b` where `a` is NaN, on every target.
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
/// The larger number; `b` where `a` is NaN, on every target.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
