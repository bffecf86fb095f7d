//! Lanes in one vector register of an x86 processor, by its instructions.
//!
//! [`super::Lanes`] leaves it to the compiler to find vectors among unrolled numbers. In long bodies it finds only some of
//! them and moves the rest from lane to lane. Here every operation is one instruction; results are the same bits, since
//! all of them are IEEE operations, contracted only where a body says so.
//!
//! # Safety
//! The types' methods use instructions that a processor may lack. They stay inside this crate, and only
//! [`crate::kernel::widest_vectors`] names them, in the branch that has asked the processor.
#![allow(unsafe_code)]

use super::Real;
use core::arch::x86_64::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// An intrinsic that reads and writes registers only.
macro_rules! on_register {
    ($call:expr) => {
        // SAFETY: no memory is touched, and the processor has the instruction (module doc).
        unsafe { $call }
    };
}

macro_rules! operator {
    ($lanes:ident: $($trait:ident $method:ident $intrinsic:ident),*) => { $(
        impl $trait for $lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(on_register!($intrinsic(self.0, other.0)))
            }
        }
    )* };
}

/// Elements `i` to `i + N` of a plane. (One comparison, where a slice takes two and a sum: kernels load so often that it shows.)
#[inline(always)]
fn elements<T, const N: usize>(plane: &[T], i: usize) -> *const T {
    assert!(i < plane.len().saturating_sub(N - 1), "elements beyond the end");
    plane.as_ptr().wrapping_add(i)
}

/// For an even and an odd place `x` of the first lane, and each lane: which element of a row of half the resolution, counted
/// from the one before `x/2`, lies below it, or (`beside`) beside that on the lane's side.
const fn picks<const N: usize>(beside: bool) -> [[i32; N]; 2] {
    let mut picks = [[0; N]; 2];
    let mut k = 0;
    while k < 2 * N {
        let (odd, lane) = (k / N, k % N);
        let below = (odd + lane) / 2;
        picks[odd][lane] = (if beside { below + 2 * ((odd + lane) % 2) } else { below + 1 }) as i32;
        k += 1;
    }
    picks
}

/// What both widths share, given the intrinsics' prefix.
macro_rules! lanes {
    ($lanes:ident: $width:literal of $register:ident, mask $mask:ident, words $words:ident;
     load $load:ident, $load_words:ident, store $store:ident, splat $splat:ident, splat_words $splat_words:ident;
     arithmetic $add:ident $sub:ident $mul:ident $div:ident $mul_add:ident, $max:ident $min:ident $sqrt:ident;
     words_and $and:ident, words_or $or:ident, words_xor $xor:ident, left $left:ident, right $right:ident;
     as_words $as_words:ident, as_floats $as_floats:ident;
     less $less:path, blend $blend:path, from_words $from_words:path, part $part:path, permute $permute:path;) => {
        #[doc = concat!(stringify!($width), " neighbouring elements.")]
        #[derive(Clone, Copy)]
        pub(crate) struct $lanes($register);

        operator!($lanes: Add add $add, Sub sub $sub, Mul mul $mul, Div div $div);

        impl Neg for $lanes {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(on_register!($as_floats($xor($as_words(self.0), $splat_words(i32::MIN)))))
            }
        }

        impl $lanes {
            #[inline(always)]
            fn of(values: [f32; $width]) -> Self {
                // SAFETY: as many floats as the register holds; the load needs no alignment.
                Self(unsafe { $load(values.as_ptr()) })
            }
            #[inline(always)]
            fn words(plane: &[u32], i: usize) -> $words {
                // SAFETY: so many elements are there; the load needs no alignment.
                unsafe { $load_words(elements::<_, $width>(plane, i).cast()) }
            }
            const HALVED: [[i32; $width]; 2] = picks(false);
            const BESIDE: [[i32; $width]; 2] = picks(true);
            /// Lanes picked from a few elements around `i + x/2`. (Picks are tables: where they are computed, rustc computes
            /// them anew for every load.)
            #[inline(always)]
            fn picked(plane: &[f32], i: usize, x: usize, picks: &[[i32; $width]; 2]) -> Self {
                const COUNT: usize = $width / 2 + 3;
                let first = elements::<_, COUNT>(plane, i + x / 2 - 1);
                // SAFETY: as many words as the register holds, so many elements are there; the loads need no alignment.
                unsafe { Self($permute($load_words(picks[x % 2].as_ptr().cast()), $part(first, COUNT as u32))) }
            }
            /// Sign in bit 31 and magnitude in bits 13 to 27, as [`super::HALF_SCALE`] expects them.
            #[inline(always)]
            fn half(sign: $words, magnitude: $words) -> Self {
                let bits = on_register!($or(
                    $and(sign, $splat_words(i32::MIN)),
                    $and(magnitude, $splat_words(super::HALF_BITS as i32))
                ));
                Self(on_register!($as_floats(bits))) * Self::splat(super::HALF_SCALE)
            }
        }

        impl Real for $lanes {
            type Mask = $mask;
            const LANES: usize = $width;
            #[inline(always)]
            fn splat(value: f32) -> Self {
                Self(on_register!($splat(value)))
            }
            #[inline(always)]
            fn ramp(start: f32, step: f32) -> Self {
                Self::of(core::array::from_fn(|lane| start + step * lane as f32))
            }
            #[inline(always)]
            fn load(plane: &[f32], i: usize) -> Self {
                // SAFETY: so many elements are there; the load needs no alignment.
                Self(unsafe { $load(elements::<_, $width>(plane, i)) })
            }
            #[inline(always)]
            fn load_strided(plane: &[f32], i: usize, stride: usize) -> Self {
                let part = &plane[i..i + stride * ($width - 1) + 1];
                Self::of(core::array::from_fn(|lane| part[lane * stride]))
            }
            #[inline(always)]
            fn load_halved(plane: &[f32], i: usize, x: usize) -> Self {
                Self::picked(plane, i, x, &Self::HALVED)
            }
            #[inline(always)]
            fn load_beside(plane: &[f32], i: usize, x: usize) -> Self {
                Self::picked(plane, i, x, &Self::BESIDE)
            }
            #[inline(always)]
            fn parity(x: usize) -> Self {
                Self::of(core::array::from_fn(|lane| ((x + lane) % 2) as f32))
            }
            #[inline(always)]
            fn load_u32(plane: &[u32], i: usize) -> Self {
                Self($from_words(Self::words(plane, i)))
            }
            #[inline(always)]
            fn gather3(records: &[f32], index: &[u32], i: usize) -> [Self; 3] {
                let mut r = [[0.0; $width]; 3];
                for (lane, &word) in index[i..i + $width].iter().enumerate() {
                    let at = 4 * word as usize;
                    let record = &records[at..at + 4];
                    for k in 0..3 {
                        r[k][lane] = record[k];
                    }
                }
                r.map(Self::of)
            }
            #[inline(always)]
            fn load_f16x2(words: &[u32], i: usize) -> [Self; 2] {
                let words = Self::words(words, i);
                let (low, low_sign) = on_register!(($left::<13>(words), $left::<16>(words)));
                let high = on_register!($right::<3>(words));
                [Self::half(low_sign, low), Self::half(words, high)]
            }
            #[inline(always)]
            fn prefetch<T>(slice: &[T], i: usize) {
                crate::kernel::prefetch(slice, i);
            }
            #[inline(always)]
            fn store(self, plane: &mut [f32], i: usize) {
                let part = &mut plane[i..i + $width];
                // SAFETY: `part` is as long as the register; the store needs no alignment.
                unsafe { $store(part.as_mut_ptr(), self.0) }
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                on_register!($less(self.0, other.0))
            }
            #[inline(always)]
            fn select(mask: Self::Mask, a: Self, b: Self) -> Self {
                Self($blend(mask, a.0, b.0))
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                Self(on_register!($mul_add(self.0, factor.0, addend.0)))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(on_register!($sqrt(self.0)))
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self(on_register!($as_floats($and($as_words(self.0), $splat_words(i32::MAX)))))
            }
            // x86's own maximum and minimum give the second operand where either is NaN, or both are zero: the definition.
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self(on_register!($max(self.0, other.0)))
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self(on_register!($min(self.0, other.0)))
            }
        }
    };
}

#[inline(always)]
fn blend512(mask: __mmask16, a: __m512, b: __m512) -> __m512 {
    on_register!(_mm512_mask_blend_ps(mask, b, a))
}

#[inline(always)]
fn unsigned512(words: __m512i) -> __m512 {
    on_register!(_mm512_cvtepu32_ps(words))
}

/// The first `count` lanes of a register, the others 0.
///
/// # Safety
/// So many elements are at `first`.
#[inline(always)]
unsafe fn part512(first: *const f32, count: u32) -> __m512 {
    // SAFETY: the mask leaves out all others; the load needs no alignment.
    unsafe { _mm512_maskz_loadu_ps(((1_u32 << count) - 1) as __mmask16, first) }
}

#[inline(always)]
fn permute512(index: __m512i, from: __m512) -> __m512 {
    on_register!(_mm512_permutexvar_ps(index, from))
}

/// As [`part512`].
///
/// # Safety
/// So many elements are at `first`.
#[inline(always)]
unsafe fn part256(first: *const f32, count: u32) -> __m256 {
    // SAFETY: the mask leaves out all others.
    unsafe {
        let lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
        _mm256_maskload_ps(first, _mm256_cmpgt_epi32(_mm256_set1_epi32(count as i32), lane))
    }
}

#[inline(always)]
fn permute256(index: __m256i, from: __m256) -> __m256 {
    on_register!(_mm256_permutevar8x32_ps(from, index))
}

#[inline(always)]
fn blend256(mask: __m256, a: __m256, b: __m256) -> __m256 {
    on_register!(_mm256_blendv_ps(b, a, mask))
}

/// Unsigned words to floats, rounded once: both halves of a word are exact, and so is the upper one's product with 2¹⁶.
#[inline(always)]
fn unsigned256(words: __m256i) -> __m256 {
    on_register!({
        let low = _mm256_cvtepi32_ps(_mm256_and_si256(words, _mm256_set1_epi32(0xFFFF)));
        let high = _mm256_cvtepi32_ps(_mm256_srli_epi32::<16>(words));
        _mm256_add_ps(_mm256_mul_ps(high, _mm256_set1_ps(65_536.0)), low)
    })
}

lanes! {
    Avx512: 16 of __m512, mask __mmask16, words __m512i;
    load _mm512_loadu_ps, _mm512_loadu_si512, store _mm512_storeu_ps, splat _mm512_set1_ps, splat_words _mm512_set1_epi32;
    arithmetic _mm512_add_ps _mm512_sub_ps _mm512_mul_ps _mm512_div_ps _mm512_fmadd_ps, _mm512_max_ps _mm512_min_ps _mm512_sqrt_ps;
    words_and _mm512_and_si512, words_or _mm512_or_si512, words_xor _mm512_xor_si512,
    left _mm512_slli_epi32, right _mm512_srli_epi32;
    as_words _mm512_castps_si512, as_floats _mm512_castsi512_ps;
    less _mm512_cmp_ps_mask::<_CMP_LT_OQ>, blend blend512, from_words unsigned512,
    part part512, permute permute512;
}

lanes! {
    Avx2: 8 of __m256, mask __m256, words __m256i;
    load _mm256_loadu_ps, _mm256_loadu_si256, store _mm256_storeu_ps, splat _mm256_set1_ps, splat_words _mm256_set1_epi32;
    arithmetic _mm256_add_ps _mm256_sub_ps _mm256_mul_ps _mm256_div_ps _mm256_fmadd_ps, _mm256_max_ps _mm256_min_ps _mm256_sqrt_ps;
    words_and _mm256_and_si256, words_or _mm256_or_si256, words_xor _mm256_xor_si256,
    left _mm256_slli_epi32, right _mm256_srli_epi32;
    as_words _mm256_castps_si256, as_floats _mm256_castsi256_ps;
    less _mm256_cmp_ps::<_CMP_LT_OQ>, blend blend256, from_words unsigned256,
    part part256, permute permute256;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::Vectors;
    use crate::real::Lanes;

    /// Ordinary and difficult numbers: every pair of them meets in some lane.
    fn numbers() -> Vec<f32> {
        let mut all = vec![0.0, -0.0, 1.0, -1.5, 3.0e38, -3.0e38, 1e-40, -1e-40, 0.1, 7.25, -1e-20, 1e20];
        all.extend([f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MIN_POSITIVE]);
        (0..16).flat_map(|turn| (0..16).map(move |k| (k + turn) % 16)).map(|k| all[k]).collect()
    }

    fn bits<R: Real>(value: R) -> Vec<u32> {
        let mut out = vec![0.0; R::LANES];
        value.store(&mut out, 0);
        // Which NaN comes out is the one thing that IEEE leaves open.
        out.iter().map(|v| if v.is_nan() { f32::NAN.to_bits() } else { v.to_bits() }).collect()
    }

    /// All results of the arithmetic at `i`, operation by operation.
    fn arithmetic<R: Real>(a: &[f32], b: &[f32], i: usize) -> Vec<Vec<u32>> {
        let (x, y) = (R::load(a, i), R::load(b, i));
        let picked = R::select(x.lt(y), x, y + R::splat(1.0));
        [x + y, x - y, x * y, x / y, x.mul_add(y, -x), -x, x.abs(), x.sqrt(), x.max(y), x.min(y), x.positive(), picked]
            .map(bits)
            .to_vec()
    }

    /// All results of loading from `first` on, of the lanes from `lane` on.
    fn loading<R: Real>(plane: &[f32], words: &[u32], first: usize, lane: usize) -> Vec<Vec<u32>> {
        let i = first + lane;
        let index: Vec<u32> = words.iter().map(|w| w % 50).collect();
        let [low, high] = R::load_f16x2(words, i);
        let [x, y, z] = R::gather3(plane, &index, i);
        let at = first % 7 + lane;
        let halves = [R::load_halved(plane, 20, at), R::load_beside(plane, 20, at), R::parity(at)];
        let [one, two, three] = [1, 2, 3].map(|stride| R::load_strided(plane, first + stride * lane, stride));
        [R::load_u32(words, i), low, high, x, y, z, R::ramp(i as f32, 1.0), one, two, three]
            .into_iter()
            .chain(halves)
            .map(bits)
            .collect()
    }

    fn agrees<R: Real>() {
        let (a, words) = (numbers(), (0..256_u32).map(|k| k.wrapping_mul(0x9E37_79B9)).collect::<Vec<_>>());
        let b: Vec<f32> = (0..256).map(|k| a[k / 16]).collect();
        for i in (0..256 - R::LANES).step_by(5) {
            let wide = [arithmetic::<R>(&a, &b, i), loading::<R>(&a, &words, i.min(128), 0)].concat();
            for lane in 0..R::LANES {
                let one = [arithmetic::<f32>(&a, &b, i + lane), loading::<f32>(&a, &words, i.min(128), lane)].concat();
                for (operation, (wide, one)) in wide.iter().zip(one).enumerate() {
                    assert_eq!(wide[lane], one[0], "operation {operation}, lane {lane} at {i}");
                }
            }
        }
    }

    #[test]
    fn registers_agree_with_single_numbers_bit_for_bit() {
        agrees::<Lanes<16>>();
        let mut tried = 0;
        if crate::kernel::vectors() != Vectors::Baseline {
            agrees::<Avx2>();
            tried += 1;
        }
        if crate::kernel::vectors() == Vectors::Avx512 {
            agrees::<Avx512>();
            tried += 1;
        }
        println!("{tried} of 2 kinds of registers");
    }
}
