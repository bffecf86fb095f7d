//! The smallest kernels, one of each form: the executors' canary, and the pattern to copy for a new kernel.
//!
//! `smoke_fill` stores a hash of the index (the canary: does the device really write?), `smoke_axpy` is `a·x + y` over
//! planes (the bandwidth probe), `smoke_madd` multiplies and adds in registers (the arithmetic probe), `smoke_histogram`
//! counts by atomics.

use crate::kernel::{At, AtomicWords, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Kernel, Tolerance};
use crate::real::Real;
use interreflect_shared::smoke::SmokeParams;

/// What the canary stores at element `i`.
#[inline(always)]
pub fn fill(i: u32, p: &SmokeParams) -> u32 {
    i.wrapping_mul(747_796_405) ^ p.seed
}

#[cfg(not(target_arch = "spirv"))]
fn fill_case(input: &mut CaseInput) -> Case {
    let params = SmokeParams { count: input.count as u32, seed: input.bits(), scale: 0.0, _pad: 0 };
    Case::default().uniform(&params).zeroed::<u32>(input.count)
}

kernel! {
    /// Canary: every element is a hash of its index.
    mod smoke_fill = super::fill; entry "smoke_fill" threads(64);
    uniform 0 params: SmokeParams;
    write 1 out: u32;
    case super::fill_case; tolerance Tolerance::Exact, "integers";
}

/// Elements that `axpy` covers: one row.
pub fn axpy_rows(p: &SmokeParams) -> Rows {
    Rows {
        count: p.count.div_ceil(AXPY_ROW),
        len: AXPY_ROW,
        pitch: AXPY_ROW,
        first: 0,
        plane: p.count.div_ceil(AXPY_ROW) * AXPY_ROW,
    }
}
const AXPY_ROW: u32 = 256;

/// `scale·x + y` for one element of one plane.
#[inline(always)]
pub fn axpy<R: Real>(at: At, p: &SmokeParams, x: &[f32], y: &[f32]) -> [R; 1] {
    [R::splat(p.scale) * R::load(x, at.i) + R::load(y, at.i)]
}

#[cfg(not(target_arch = "spirv"))]
fn axpy_case(input: &mut CaseInput) -> Case {
    let params = SmokeParams { count: input.count as u32, seed: 0, scale: 0.75, _pad: 0 };
    let count = axpy_rows(&params).plane as usize;
    Case::default().uniform(&params).read(&input.floats(count)).read(&input.floats(count)).zeroed::<f32>(count)
}

kernel! {
    /// `a·x + y`: what the machine's memory gives.
    lanes mod smoke_axpy = super::axpy; entry "smoke_axpy" threads(64);
    uniform 0 params: SmokeParams;
    read 1 x: f32;
    read 2 y: f32;
    write 3 out: f32 x 1;
    over super::axpy_rows;
    case super::axpy_case; tolerance Tolerance::RelAbs(1e-6, 1e-37), "a device may fuse the multiply and the add, and flush denormals";
}

/// Multiply-adds of one chain of [`madd`].
const MADD_STEPS: u32 = 64;

/// Twelve chains of multiply-adds that start from multiples of one element: enough of them to fill any pipeline.
#[inline(always)]
pub fn madd<R: Real>(at: At, p: &SmokeParams, x: &[f32]) -> [R; 1] {
    let (x, scale) = (R::load(x, at.i), R::splat(p.scale));
    let mut chains = [x; 12];
    // Different starts, or a compiler would make one chain of all.
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 => { chains[K] = x * R::splat(K as f32) });
    for _ in 0..MADD_STEPS {
        unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 => { chains[K] = chains[K] * scale + x });
    }
    let mut sum = R::splat(0.0);
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 => { sum = sum + chains[K] });
    [sum]
}

#[cfg(not(target_arch = "spirv"))]
fn madd_case(input: &mut CaseInput) -> Case {
    let params = SmokeParams { count: input.count as u32, seed: 0, scale: 0.75, _pad: 0 };
    let count = axpy_rows(&params).plane as usize;
    Case::default().uniform(&params).read(&input.floats(count)).zeroed::<f32>(count)
}

kernel! {
    /// Multiply-adds in registers: what the machine's arithmetic gives.
    lanes mod smoke_madd = super::madd; entry "smoke_madd" threads(64);
    uniform 0 params: SmokeParams;
    read 1 x: f32;
    write 2 out: f32 x 1;
    over super::axpy_rows;
    case super::madd_case; tolerance Tolerance::RelAbs(1e-5, 1e-35), "64 multiply-adds of one sign: a device may fuse each, and flush denormals";
}

/// Invocations of `histogram`.
pub fn histogram_items(p: &SmokeParams) -> u32 {
    p.count
}

/// Counts one value in the bin of its low bits.
#[inline(always)]
pub fn histogram(i: u32, p: &SmokeParams, values: &[u32], bins: &mut impl AtomicWords) {
    bins.add((values[i as usize] ^ p.seed) % HISTOGRAM_BINS, 1);
}
/// Bins of [`histogram`]: so many that threads seldom meet in one where values are spread over all.
pub const HISTOGRAM_BINS: u32 = 4096;
/// Values of small cases lie below this: many meet in each bin, so that an addition that is not atomic loses some.
#[cfg(not(target_arch = "spirv"))]
const CROWDED: u32 = 64;

#[cfg(not(target_arch = "spirv"))]
fn histogram_case(input: &mut CaseInput) -> Case {
    let params = SmokeParams { count: input.count as u32, seed: input.bits(), scale: 0.0, _pad: 0 };
    let range = if input.is_large() { HISTOGRAM_BINS } else { CROWDED };
    let values: alloc::vec::Vec<u32> = (0..input.count).map(|_| input.bits() % range).collect();
    Case::default().uniform(&params).read(&values).zeroed::<u32>(HISTOGRAM_BINS as usize)
}

scatter! {
    /// Histogram of hashed words.
    mod smoke_histogram = super::histogram; entry "smoke_histogram" threads(64);
    uniform 0 params: SmokeParams; items super::histogram_items;
    read 1 values: u32;
    atomic 2 bins;
    case super::histogram_case; tolerance Tolerance::Exact, "integers";
}

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&Kernel] =
    &[&smoke_fill::KERNEL, &smoke_axpy::KERNEL, &smoke_madd::KERNEL, &smoke_histogram::KERNEL];
