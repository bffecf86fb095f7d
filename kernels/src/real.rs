//! Numbers that stand for one invocation on a device or for several neighbouring elements on a CPU.
//!
//! An arithmetic kernel body is generic over [`Real`]. The device runs it with `f32`; the CPU runs it with the registers of
//! `x86` where the processor has them, else with [`Lanes`], which rustc turns into vector instructions. Every operation is defined lane by lane with the same IEEE
//! operations as `f32`, no reassociation and no contraction but where a body asks for it, so scalar and lanes agree bit for bit.

use crate::kernel::fetch;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// What a lane-generic body may do with a number. Comparison gives a mask; `select` takes the place of a branch.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// Result of a comparison, one truth value per lane.
    type Mask: Copy;
    /// Elements that one value stands for.
    const LANES: usize;
    /// The same number in every lane.
    fn splat(value: f32) -> Self;
    /// `start + step·lane`: exact while the values are integers below 2²⁴.
    fn ramp(start: f32, step: f32) -> Self;
    /// Elements `i, i+1, …` of a plane.
    fn load(plane: &[f32], i: usize) -> Self;
    /// Elements `i, i+stride, …` of a plane.
    fn load_strided(plane: &[f32], i: usize, stride: usize) -> Self;
    /// Elements of a row of half the resolution, below elements `x, x+1, …` of this one: `i + x/2, i + (x+1)/2, …`. On a CPU
    /// the elements before and after them must exist as well.
    fn load_halved(plane: &[f32], i: usize, x: usize) -> Self;
    /// The neighbours of what [`Self::load_halved`] gives on the side of each lane's element: the one before where x is
    /// even, the one after where it is odd.
    fn load_beside(plane: &[f32], i: usize, x: usize) -> Self;
    /// 1 where `x, x+1, …` is odd, 0 where it is even.
    fn parity(x: usize) -> Self;
    /// Words `i, i+1, …` converted from unsigned integers (rounded to nearest).
    fn load_u32(plane: &[u32], i: usize) -> Self;
    /// The first three of the four floats of records `index[i]`, `index[i+1]`, …
    fn gather3(records: &[f32], index: &[u32], i: usize) -> [Self; 3];
    /// Words `i, i+1, …` as pairs of half floats, those in the low bits first. For words that
    /// [`crate::math::pack::pack_f16x2_flushed`] made: denormal halves may be read as 0, and there is no infinity.
    fn load_f16x2(words: &[u32], i: usize) -> [Self; 2];
    /// Asks for the elements from `i` on that a later load reads, which may lie beyond the end: no more than a hint to a CPU.
    #[inline(always)]
    fn prefetch<T>(_slice: &[T], _i: usize) {}
    /// Stores to elements `i, i+1, …` of a plane.
    fn store(self, plane: &mut [f32], i: usize);
    /// `self < other` (false with a NaN).
    fn lt(self, other: Self) -> Self::Mask;
    /// Picks `a` where the mask is true, else `b`.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;
    /// `self·factor + addend`, rounded once on every CPU ([`crate::math::float::mul_add`]).
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// Square root (correctly rounded on every target).
    fn sqrt(self) -> Self;
    /// Magnitude.
    fn abs(self) -> Self;
    /// The larger number, `other` where `self` is NaN: the same on every target, unlike the target's own `max`.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::select(other.lt(self), self, other)
    }
    /// The smaller number, `other` where `self` is NaN.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    /// `max(self, 0)`, 0 for NaN.
    #[inline(always)]
    fn positive(self) -> Self {
        self.max(Self::splat(0.0))
    }
}

impl Real for f32 {
    type Mask = bool;
    const LANES: usize = 1;
    #[inline(always)]
    fn splat(value: f32) -> f32 {
        value
    }
    #[inline(always)]
    fn ramp(start: f32, _step: f32) -> f32 {
        start
    }
    #[inline(always)]
    fn load(plane: &[f32], i: usize) -> f32 {
        *fetch(plane, i)
    }
    #[inline(always)]
    fn load_strided(plane: &[f32], i: usize, _stride: usize) -> f32 {
        *fetch(plane, i)
    }
    #[inline(always)]
    fn load_halved(plane: &[f32], i: usize, x: usize) -> f32 {
        *fetch(plane, i + x / 2)
    }
    #[inline(always)]
    fn load_beside(plane: &[f32], i: usize, x: usize) -> f32 {
        *fetch(plane, i + x / 2 + 2 * (x & 1) - 1)
    }
    #[inline(always)]
    fn parity(x: usize) -> f32 {
        (x & 1) as f32
    }
    #[inline(always)]
    fn load_u32(plane: &[u32], i: usize) -> f32 {
        *fetch(plane, i) as f32
    }
    #[inline(always)]
    fn gather3(records: &[f32], index: &[u32], i: usize) -> [f32; 3] {
        let at = 4 * *fetch(index, i) as usize;
        [*fetch(records, at), *fetch(records, at + 1), *fetch(records, at + 2)]
    }
    #[inline(always)]
    fn load_f16x2(words: &[u32], i: usize) -> [f32; 2] {
        [half_low(*fetch(words, i)), half_high(*fetch(words, i))]
    }
    #[inline(always)]
    fn store(self, plane: &mut [f32], i: usize) {
        plane[i] = self;
    }
    #[inline(always)]
    fn lt(self, other: f32) -> bool {
        self < other
    }
    #[inline(always)]
    fn select(mask: bool, a: f32, b: f32) -> f32 {
        if mask { a } else { b }
    }
    #[inline(always)]
    fn mul_add(self, factor: f32, addend: f32) -> f32 {
        crate::math::float::mul_add(self, factor, addend)
    }
    #[inline(always)]
    fn sqrt(self) -> f32 {
        crate::math::float::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> f32 {
        crate::math::float::abs(self)
    }
}

/// 2¹¹²: takes an exponent biased by 15 to one biased by 127.
const HALF_SCALE: f32 = f32::from_bits((127 + 112) << 23);
/// Exponent and mantissa of a half float that was moved to a float's place.
const HALF_BITS: u32 = 0x0FFF_E000;
/// The half float in a word's low bits: sign, exponent and mantissa moved to their places, without a branch.
#[inline(always)]
fn half_low(word: u32) -> f32 {
    f32::from_bits(((word << 16) & 0x8000_0000) | ((word << 13) & HALF_BITS)) * HALF_SCALE
}
/// The half float in a word's high bits.
#[inline(always)]
fn half_high(word: u32) -> f32 {
    f32::from_bits((word & 0x8000_0000) | ((word >> 3) & HALF_BITS)) * HALF_SCALE
}

#[cfg(not(target_arch = "spirv"))]
pub use counted::{Counted, count_operations};
#[cfg(not(target_arch = "spirv"))]
pub use lanes::{Lanes, WIDTH};

#[cfg(all(feature = "std", target_arch = "x86_64"))]
pub(crate) mod x86;

#[cfg(not(target_arch = "spirv"))]
mod lanes {
    use super::{Real, half_high, half_low};
    use core::ops::{Add, Div, Mul, Neg, Sub};

    /// Lanes where the processor's registers are not named: four of 128 bits.
    pub const WIDTH: usize = 16;

    /// `N` neighbouring elements.
    #[derive(Clone, Copy, Debug, PartialEq)]
    #[repr(align(64))]
    pub struct Lanes<const N: usize>(pub [f32; N]);

    macro_rules! lanewise {
        ($($trait:ident $method:ident $op:tt),*) => { $(
            impl<const N: usize> $trait for Lanes<N> {
                type Output = Self;
                #[inline(always)]
                fn $method(mut self, other: Self) -> Self {
                    for lane in 0..N { self.0[lane] $op other.0[lane]; }
                    self
                }
            }
        )* };
    }
    lanewise!(Add add +=, Sub sub -=, Mul mul *=, Div div /=);

    impl<const N: usize> Neg for Lanes<N> {
        type Output = Self;
        #[inline(always)]
        fn neg(mut self) -> Self {
            for lane in 0..N {
                self.0[lane] = -self.0[lane];
            }
            self
        }
    }

    impl<const N: usize> Real for Lanes<N> {
        type Mask = [bool; N];
        const LANES: usize = N;
        #[inline(always)]
        fn splat(value: f32) -> Self {
            Self([value; N])
        }
        #[inline(always)]
        fn ramp(start: f32, step: f32) -> Self {
            let mut r = [0.0; N];
            for lane in 0..N {
                r[lane] = start + step * lane as f32;
            }
            Self(r)
        }
        #[inline(always)]
        fn load(plane: &[f32], i: usize) -> Self {
            let mut r = [0.0; N];
            r.copy_from_slice(&plane[i..i + N]);
            Self(r)
        }
        #[inline(always)]
        fn load_strided(plane: &[f32], i: usize, stride: usize) -> Self {
            let mut r = [0.0; N];
            let part = &plane[i..i + stride * (N - 1) + 1];
            for lane in 0..N {
                r[lane] = part[lane * stride];
            }
            Self(r)
        }
        #[inline(always)]
        fn load_halved(plane: &[f32], i: usize, x: usize) -> Self {
            let part = &plane[i + x / 2..=i + (x + N - 1) / 2];
            Self(core::array::from_fn(|lane| part[(x % 2 + lane) / 2]))
        }
        #[inline(always)]
        fn load_beside(plane: &[f32], i: usize, x: usize) -> Self {
            let part = &plane[i + x / 2 - 1..=i + (x + N - 1) / 2 + 1];
            Self(core::array::from_fn(|lane| part[(x % 2 + lane) / 2 + 2 * ((x + lane) % 2)]))
        }
        #[inline(always)]
        fn parity(x: usize) -> Self {
            Self(core::array::from_fn(|lane| ((x + lane) % 2) as f32))
        }
        #[inline(always)]
        fn load_u32(plane: &[u32], i: usize) -> Self {
            let mut r = [0.0; N];
            let part = &plane[i..i + N];
            for lane in 0..N {
                r[lane] = part[lane] as f32;
            }
            Self(r)
        }
        #[inline(always)]
        fn gather3(records: &[f32], index: &[u32], i: usize) -> [Self; 3] {
            let mut r = [Self([0.0; N]); 3];
            let part = &index[i..i + N];
            for lane in 0..N {
                let at = 4 * part[lane] as usize;
                let record = &records[at..at + 4];
                for k in 0..3 {
                    r[k].0[lane] = record[k];
                }
            }
            r
        }
        #[inline(always)]
        fn load_f16x2(words: &[u32], i: usize) -> [Self; 2] {
            let mut part = [0; N];
            part.copy_from_slice(&words[i..i + N]);
            let (mut low, mut high) = ([0.0; N], [0.0; N]);
            for lane in 0..N {
                low[lane] = half_low(part[lane]);
            }
            for lane in 0..N {
                high[lane] = half_high(part[lane]);
            }
            [Self(low), Self(high)]
        }
        #[inline(always)]
        fn prefetch<T>(slice: &[T], i: usize) {
            crate::kernel::prefetch(slice, i);
        }
        #[inline(always)]
        fn store(self, plane: &mut [f32], i: usize) {
            plane[i..i + N].copy_from_slice(&self.0);
        }
        #[inline(always)]
        fn lt(self, other: Self) -> [bool; N] {
            let mut r = [false; N];
            for lane in 0..N {
                r[lane] = self.0[lane] < other.0[lane];
            }
            r
        }
        #[inline(always)]
        fn select(mask: [bool; N], a: Self, b: Self) -> Self {
            let mut r = b;
            for lane in 0..N {
                r.0[lane] = if mask[lane] { a.0[lane] } else { b.0[lane] };
            }
            r
        }
        #[inline(always)]
        fn mul_add(mut self, factor: Self, addend: Self) -> Self {
            for lane in 0..N {
                self.0[lane] = crate::math::float::mul_add(self.0[lane], factor.0[lane], addend.0[lane]);
            }
            self
        }
        #[inline(always)]
        fn sqrt(mut self) -> Self {
            for lane in 0..N {
                self.0[lane] = crate::math::float::sqrt(self.0[lane]);
            }
            self
        }
        #[inline(always)]
        fn abs(mut self) -> Self {
            for lane in 0..N {
                self.0[lane] = crate::math::float::abs(self.0[lane]);
            }
            self
        }
    }
}

#[cfg(not(target_arch = "spirv"))]
mod counted {
    use super::Real;
    use crate::kernel::{At, Rows};
    use core::ops::{Add, Div, Mul, Neg, Sub};
    use core::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    /// A number that counts what is done with it: arithmetic, comparisons and selections count one each, a multiply-add two. Loads, stores,
    /// signs and magnitudes count nothing.
    #[derive(Clone, Copy, PartialEq, Debug)]
    pub struct Counted(f32);

    static OPERATIONS: AtomicUsize = AtomicUsize::new(0);

    fn one<T>(result: T) -> T {
        OPERATIONS.fetch_add(1, Relaxed);
        result
    }

    /// Elements that [`count_operations`] looks at.
    const SAMPLES: u32 = 256;

    /// Runs a body with [`Counted`] numbers on a sample of elements; gives the operations and the elements counted. For
    /// one thread at a time.
    pub fn count_operations(rows: &Rows, mut body: impl FnMut(At)) -> (u64, u64) {
        let before = OPERATIONS.load(Relaxed);
        let step = rows.invocations().div_ceil(SAMPLES).max(1);
        let sample = (0..rows.invocations()).step_by(step as usize);
        let elements = sample.len() as u64;
        sample.for_each(|id| body(rows.at(id)));
        ((OPERATIONS.load(Relaxed) - before) as u64, elements)
    }

    macro_rules! counted {
        ($($trait:ident $method:ident $op:tt),*) => { $(
            impl $trait for Counted {
                type Output = Self;
                fn $method(self, other: Self) -> Self { one(Self(self.0 $op other.0)) }
            }
        )* };
    }
    counted!(Add add +, Sub sub -, Mul mul *, Div div /);

    impl Neg for Counted {
        type Output = Self;
        fn neg(self) -> Self {
            Self(-self.0)
        }
    }

    impl Real for Counted {
        type Mask = bool;
        const LANES: usize = 1;
        fn splat(value: f32) -> Self {
            Self(value)
        }
        fn ramp(start: f32, _step: f32) -> Self {
            Self(start)
        }
        fn load(plane: &[f32], i: usize) -> Self {
            Self(plane[i])
        }
        fn load_strided(plane: &[f32], i: usize, _stride: usize) -> Self {
            Self(plane[i])
        }
        fn load_halved(plane: &[f32], i: usize, x: usize) -> Self {
            Self(f32::load_halved(plane, i, x))
        }
        fn load_beside(plane: &[f32], i: usize, x: usize) -> Self {
            Self(f32::load_beside(plane, i, x))
        }
        fn parity(x: usize) -> Self {
            Self(f32::parity(x))
        }
        fn load_u32(plane: &[u32], i: usize) -> Self {
            Self(plane[i] as f32)
        }
        fn gather3(records: &[f32], index: &[u32], i: usize) -> [Self; 3] {
            f32::gather3(records, index, i).map(Self)
        }
        fn load_f16x2(words: &[u32], i: usize) -> [Self; 2] {
            f32::load_f16x2(words, i).map(Self)
        }
        fn store(self, plane: &mut [f32], i: usize) {
            plane[i] = self.0;
        }
        fn lt(self, other: Self) -> bool {
            one(self.0 < other.0)
        }
        fn select(mask: bool, a: Self, b: Self) -> Self {
            one(if mask { a } else { b })
        }
        fn mul_add(self, factor: Self, addend: Self) -> Self {
            self * factor + addend
        }
        fn sqrt(self) -> Self {
            one(Self(crate::math::float::sqrt(self.0)))
        }
        fn abs(self) -> Self {
            Self(crate::math::float::abs(self.0))
        }
    }
}

/// Repeats a block with its index as a constant, `unroll!(K in 0, 1, 2 => { … })`: neither rust-gpu nor the drivers
/// unroll, and a run-time index into a constant table becomes a copy in private memory (measured 20 times slower).
#[macro_export]
macro_rules! unroll {
    ($k:ident in $($value:expr),+ => $block:block) => { $( { const $k: usize = $value; $block } )+ };
}
