//! Float functions that give the same result on every target.
//!
//! Vulkan lets a device take `sin` and `cos` to 2⁻¹¹, `asin`, `acos` and `atan` to 1/4096, and leaves `round` of a half,
//! `min`/`max` of a NaN and `pow` of zero open. What a kernel needs is therefore written out here in additions,
//! multiplications and bit operations, which are exact or correctly rounded everywhere; CPU and device then differ only
//! where a device fuses a multiply with an add or divides or takes roots to 2.5 units in the last place, as Vulkan allows.
//! The polynomials are those of the Cephes library (Moshier 1989, single precision). Errors below were measured
//! against `f64` and are held by the tests. Functions of a bad argument return the neutral value that their
//! documentation states; none produces an infinity from a finite argument unless that is stated.

#[cfg(any(target_arch = "spirv", not(feature = "std")))]
use spirv_std::num_traits::Float;

/// π.
pub const PI: f32 = core::f32::consts::PI;
const HALF_PI: f32 = core::f32::consts::FRAC_PI_2;
const QUARTER_PI: f32 = core::f32::consts::FRAC_PI_4;
const SIGN_BIT: u32 = 0x8000_0000;
const EXPONENT_BITS: u32 = 0x7F80_0000;

/// Square root: correctly rounded on a CPU, within 2.5 units in the last place on a device.
#[inline(always)]
pub fn sqrt(x: f32) -> f32 {
    x.sqrt()
}
/// `a·b + c`, rounded once on a CPU; a device may round the product as well. For the processors that have it as one instruction
/// (x86 since 2013, ARM): elsewhere it is slow.
#[inline(always)]
pub fn mul_add(a: f32, b: f32, c: f32) -> f32 {
    a.mul_add(b, c)
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
/// Smallest integer not below `x`, exact.
#[inline(always)]
pub fn ceil(x: f32) -> f32 {
    -floor(-x)
}
/// A whole number of less than 2³¹ as an integer. A device converts without a check, so that beyond that (and for NaN) it gives any
/// integer; a CPU the nearest (0).
#[inline(always)]
#[cfg_attr(target_arch = "spirv", allow(unsafe_code))]
pub fn to_i32(whole: f32) -> i32 {
    // SAFETY: SPIR-V leaves the result of a conversion out of range open, and nothing else.
    #[cfg(target_arch = "spirv")]
    return unsafe { whole.to_int_unchecked() };
    #[cfg(not(target_arch = "spirv"))]
    return whole as i32;
}
/// Integer part towards zero, exact.
#[inline(always)]
pub fn trunc(x: f32) -> f32 {
    if x < 0.0 { ceil(x) } else { floor(x) }
}
/// Nearest integer, halves away from zero (as Rust's; a device's own `round` takes halves to the even neighbour).
#[inline(always)]
pub fn round(x: f32) -> f32 {
    let whole = trunc(x);
    // The fraction is exact, so that 0.49999997 stays 0, unlike floor(x + 0.5).
    if abs(x - whole) >= 0.5 { whole + sign(x) } else { whole }
}
/// `x − floor(x)`, in [0, 1] (1 only by rounding, for tiny negative `x`).
#[inline(always)]
pub fn fract(x: f32) -> f32 {
    x - floor(x)
}
/// 1 with the sign of `x`: −1 for negative numbers and −0.
#[inline(always)]
pub fn sign(x: f32) -> f32 {
    copysign(1.0, x)
}
/// Magnitude of the first with the sign of the second, exact (also for zeros and NaN).
#[inline(always)]
pub fn copysign(magnitude: f32, sign: f32) -> f32 {
    f32::from_bits((magnitude.to_bits() & !SIGN_BIT) | (sign.to_bits() & SIGN_BIT))
}
/// Neither infinite nor NaN; tests the exponent's bits, since devices need not honour comparisons with NaN.
#[inline(always)]
pub fn is_finite(x: f32) -> bool {
    x.to_bits() & EXPONENT_BITS != EXPONENT_BITS
}
/// The smaller number; `b` where either is NaN, so put the safe number second.
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
/// The larger number; `b` where either is NaN, so put the safe number second.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
/// `x` kept within `[low, high]`; `low` for NaN.
#[inline(always)]
pub fn clamp(x: f32, low: f32, high: f32) -> f32 {
    min(max(x, low), high)
}
/// `x` kept within `[0, 1]`; 0 for NaN.
#[inline(always)]
pub fn saturate(x: f32) -> f32 {
    clamp(x, 0.0, 1.0)
}
/// `a + (b − a)·t`.
#[inline(always)]
pub fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + (b - a) * t
}
/// `x·x`.
#[inline(always)]
pub fn square(x: f32) -> f32 {
    x * x
}
/// `xⁿ` by repeated squaring; any sign of `x` (a device's own `pow` of a negative base is NaN). `powi(x, 0)` is 1.
#[inline(always)]
pub fn powi(x: f32, n: u32) -> f32 {
    let (mut result, mut factor, mut rest) = (1.0, x, n);
    while rest != 0 {
        if rest & 1 != 0 {
            result *= factor;
        }
        factor *= factor;
        rest >>= 1;
    }
    result
}

/// π/2 in three parts short enough that their products with a small integer are exact (Cody & Waite 1980).
const HALF_PI_PARTS: [f32; 3] = [1.570_312_5, 4.837_512_969_970_703e-4, 7.549_789_948_768_648e-8];

/// Sine and cosine of an angle in radians, absolute error 1.2e-7 for `|x| ≤ 8192`, growing with `|x|` beyond.
#[inline(always)]
pub fn sin_cos(x: f32) -> (f32, f32) {
    // Subtract the nearest multiple of a quarter turn.
    let quarter = floor(x * core::f32::consts::FRAC_2_PI + 0.5);
    let r = x - quarter * HALF_PI_PARTS[0] - quarter * HALF_PI_PARTS[1] - quarter * HALF_PI_PARTS[2];
    let r2 = r * r;
    let s = r + r * r2 * (-1.666_665_461_1e-1 + r2 * (8.332_160_873_6e-3 + r2 * -1.951_529_589_1e-4));
    let c = 1.0 - 0.5 * r2
        + r2 * r2 * (4.166_664_568_298_827e-2 + r2 * (-1.388_731_625_493_765e-3 + r2 * 2.443_315_711_809_948e-5));
    // Each quarter turn maps (sin, cos) to (cos, −sin).
    let q = quarter as i32;
    let (a, b) = if q & 1 == 0 { (s, c) } else { (c, s) };
    (if q & 2 == 0 { a } else { -a }, if (q + 1) & 2 == 0 { b } else { -b })
}
/// Sine; see [`sin_cos`].
#[inline(always)]
pub fn sin(x: f32) -> f32 {
    sin_cos(x).0
}
/// Cosine; see [`sin_cos`].
#[inline(always)]
pub fn cos(x: f32) -> f32 {
    sin_cos(x).1
}
/// Tangent, `sin/cos`: relative error 3e-7 for `|x| ≤ 1.5`; at a pole a large number or ∞.
#[inline(always)]
pub fn tan(x: f32) -> f32 {
    let (s, c) = sin_cos(x);
    s / c
}

/// Arc sine of a number in [0, 0.5].
#[inline(always)]
fn asin_small(x: f32) -> f32 {
    let z = x * x;
    let p = 4.547_002_599_8e-2 + z * (2.418_131_104_9e-2 + z * 4.216_319_904_8e-2);
    x + x * z * (1.666_675_242_2e-1 + z * (7.495_300_268_6e-2 + z * p))
}
/// Arc sine in [−π/2, π/2], absolute error 2.5e-7; arguments beyond ±1 count as ±1.
#[inline(always)]
pub fn asin(x: f32) -> f32 {
    let a = abs(x);
    let angle = if a <= 0.5 { asin_small(a) } else { HALF_PI - 2.0 * asin_small(sqrt(0.5 * max(1.0 - a, 0.0))) };
    copysign(angle, x)
}
/// Arc cosine in [0, π], absolute error 4e-7; arguments beyond ±1 count as ±1.
#[inline(always)]
pub fn acos(x: f32) -> f32 {
    let a = abs(x);
    // Near ±1 through the half angle, which keeps small angles exact.
    let half = if a <= 0.5 { HALF_PI - asin_small(a) } else { 2.0 * asin_small(sqrt(0.5 * max(1.0 - a, 0.0))) };
    if x < 0.0 { PI - half } else { half }
}
/// Arc tangent of a number in [0, 1].
#[inline(always)]
fn atan_unit(t: f32) -> f32 {
    const TAN_PI_8: f32 = 0.414_213_56;
    let far = t > TAN_PI_8;
    let x = if far { (t - 1.0) / (t + 1.0) } else { t };
    let z = x * x;
    let p = 1.997_771_064_78e-1 + z * (-1.387_768_560_32e-1 + z * 8.053_744_495_38e-2);
    let angle = x + x * z * (-3.333_294_915_39e-1 + z * p);
    if far { angle + QUARTER_PI } else { angle }
}
/// Arc tangent in [−π/2, π/2], absolute error 2e-7.
#[inline(always)]
pub fn atan(x: f32) -> f32 {
    let a = abs(x);
    let angle = if a <= 1.0 { atan_unit(a) } else { HALF_PI - atan_unit(1.0 / a) };
    copysign(angle, x)
}
/// Angle of the point (x, y) in [−π, π], absolute error 4e-7. `atan2(0, 0)` is 0 or ±π by the zeros' signs as on a CPU
/// (a device's own is garbage there).
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    let (ax, ay) = (abs(x), abs(y));
    let (low, high) = if ay > ax { (ax, ay) } else { (ay, ax) };
    let unit = atan_unit(if high > 0.0 { low / high } else { 0.0 });
    let first = if ay > ax { HALF_PI - unit } else { unit };
    copysign(if x.to_bits() & SIGN_BIT != 0 { PI - first } else { first }, y)
}

/// `2ⁿ` for an integer `n` in [−126, 127], exact.
#[inline(always)]
pub fn exp2_int(n: i32) -> f32 {
    f32::from_bits(((n + 127) as u32) << 23)
}
/// `p·2ⁿ` for `p` near 1 and `n` in [−125, 128], without passing through an infinity.
#[inline(always)]
fn scale(p: f32, n: f32) -> f32 {
    p * 2.0 * exp2_int(n as i32 - 1)
}
/// `2ˣ`, relative error 1.2e-7. `x` counts as −125 below that and as just under 128 above (finite); NaN gives 2⁻¹²⁵.
#[inline(always)]
pub fn exp2(x: f32) -> f32 {
    let x = clamp(x, -125.0, 127.999_99);
    let n = floor(x + 0.5);
    let f = x - n;
    let p = 5.550_332_471_162_809e-2
        + f * (9.618_437_357_674_64e-3 + f * (1.339_887_440_266_574e-3 + f * 1.535_336_188_319_5e-4));
    scale(1.0 + f * (6.931_472_028_550_421e-1 + f * (2.402_264_791_363_012e-1 + f * p)), n)
}
/// ln 2 in two parts, the first short enough that its product with an exponent is exact.
const LN_2_PARTS: [f32; 2] = [0.693_359_375, -2.121_944_4e-4];
/// Natural exponential, relative error 1.2e-7. `x` counts as −86.6 below that (giving 2e-38, not 0) and as 88.7 above;
/// NaN gives the smallest value.
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    let x = clamp(x, -86.6, 88.722_83);
    let n = floor(x * core::f32::consts::LOG2_E + 0.5);
    let f = x - n * LN_2_PARTS[0] - n * LN_2_PARTS[1];
    let p = 4.166_579_589_4e-2 + f * (8.333_451_907_3e-3 + f * (1.398_199_950_7e-3 + f * 1.987_569_15e-4));
    scale(1.0 + (f + f * f * (5.000_000_120_1e-1 + f * (1.666_666_545_9e-1 + f * p))), n)
}
/// A positive normal number as `(m − 1, e)` with `m·2ᵉ` and `m` in [√½, √2); 2⁻¹²⁶ for anything else that is not above.
#[inline(always)]
fn mantissa_exponent(x: f32) -> (f32, f32) {
    let bits = max(x, f32::MIN_POSITIVE).to_bits();
    let m = f32::from_bits((bits & 0x007F_FFFF) | 0x3F00_0000);
    let e = ((bits >> 23) as i32 - 126) as f32;
    if m < core::f32::consts::FRAC_1_SQRT_2 { (m + m - 1.0, e - 1.0) } else { (m - 1.0, e) }
}
/// `ln(1 + x) − x` for `1 + x` in [√½, √2).
#[inline(always)]
fn ln_1p_rest(x: f32) -> f32 {
    let p = -1.242_014_084_6e-1 + x * (1.167_699_874e-1 + x * (-1.151_461_031e-1 + x * 7.037_683_629_2e-2));
    let p = 2.000_071_476_5e-1 + x * (-1.666_805_766_5e-1 + x * (1.424_932_278_7e-1 + x * p));
    let z = x * x;
    x * z * (3.333_333_117_4e-1 + x * (-2.499_999_399_3e-1 + x * p)) - 0.5 * z
}
/// Natural logarithm, error 1.2e-7·max(1, |result|). Zero, negative, denormal and NaN count as the smallest normal number.
#[inline(always)]
pub fn ln(x: f32) -> f32 {
    let (m, e) = mantissa_exponent(x);
    (m + (ln_1p_rest(m) + e * LN_2_PARTS[1])) + e * LN_2_PARTS[0]
}
/// Base-2 logarithm, error 1.2e-7·max(1, |result|). Zero, negative, denormal and NaN give −126.
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    const LOG2_E_MINUS_1: f32 = 0.442_695_04;
    let (m, e) = mantissa_exponent(x);
    let rest = ln_1p_rest(m);
    rest * LOG2_E_MINUS_1 + m * LOG2_E_MINUS_1 + rest + m + e
}
/// `xʸ` for `x > 0`, relative error 1.2e-7·(1 + |y·log₂x|). For `x ≤ 0` it is 0, except that anything to the power 0
/// is 1. Results are finite: see [`exp2`].
#[inline(always)]
pub fn pow(x: f32, y: f32) -> f32 {
    if y == 0.0 {
        1.0
    } else if x > 0.0 {
        exp2(y * log2(x))
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `count` points from `a` to `b`.
    fn sweep(a: f64, b: f64, count: u32) -> impl Iterator<Item = f32> {
        (0..=count).map(move |i| (a + (b - a) * f64::from(i) / f64::from(count)) as f32)
    }
    /// Largest `|f(x) − truth(x)|` over a sweep.
    fn worst(points: impl Iterator<Item = f32>, f: impl Fn(f32) -> f32, truth: impl Fn(f64) -> f64) -> f64 {
        points.map(|x| (f64::from(f(x)) - truth(f64::from(x))).abs()).fold(0.0, f64::max)
    }
    /// Largest relative error over a sweep.
    fn worst_rel(points: impl Iterator<Item = f32>, f: impl Fn(f32) -> f32, truth: impl Fn(f64) -> f64) -> f64 {
        points.map(|x| (f64::from(f(x)) / truth(f64::from(x)) - 1.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn rounding_is_the_standard_librarys() {
        let halves = (-200..200).map(|i| i as f32 * 0.25);
        let hard = [0.499_999_97, -0.499_999_97, 8_388_607.5, -8_388_607.5, 1e10, -1e10, 16_777_217.0, 1e-40, 0.0];
        for x in halves.chain(hard) {
            assert_eq!(round(x), x.round(), "round {x}");
            assert_eq!(trunc(x), x.trunc(), "trunc {x}");
            assert_eq!(ceil(x), x.ceil(), "ceil {x}");
            assert_eq!(fract(x), x - x.floor(), "fract {x}");
        }
    }

    #[test]
    fn circular_functions_reach_their_stated_error() {
        for (low, high) in [(-4.0, 4.0), (-8192.0, 8192.0)] {
            assert!(worst(sweep(low, high, 400_000), sin, f64::sin) < 1.2e-7);
            assert!(worst(sweep(low, high, 400_000), cos, f64::cos) < 1.2e-7);
        }
        assert!(worst_rel(sweep(0.001, 1.5, 100_000), tan, f64::tan) < 3e-7);
        assert!(worst(sweep(-1.0, 1.0, 400_000), asin, f64::asin) < 2.5e-7);
        assert!(worst(sweep(-1.0, 1.0, 400_000), acos, f64::acos) < 4e-7);
        assert!(worst(sweep(-30.0, 30.0, 400_000), atan, f64::atan) < 2e-7);
        for angle in sweep(-3.2, 3.2, 100_000) {
            for radius in [1e-30, 1.0, 1e30] {
                let (x, y) = (radius * angle.cos(), radius * angle.sin());
                assert!((f64::from(atan2(y, x)) - f64::from(y).atan2(f64::from(x))).abs() < 4e-7, "{y} {x}");
            }
        }
    }

    #[test]
    fn circular_functions_at_their_edges() {
        assert_eq!((asin(1.5), asin(-1.5)), (HALF_PI, -HALF_PI));
        assert_eq!((acos(1.5), acos(-1.5)), (0.0, PI));
        assert_eq!((atan2(0.0, 0.0), atan2(0.0, -1.0), atan2(-0.0, -1.0)), (0.0, PI, -PI));
        assert_eq!((atan2(1.0, 0.0), atan2(-1.0, 0.0)), (HALF_PI, -HALF_PI));
        assert_eq!(acos(1.0), 0.0);
    }

    #[test]
    fn exponentials_reach_their_stated_error() {
        assert!(worst_rel(sweep(-125.0, 127.99, 400_000), exp2, f64::exp2) < 1.2e-7);
        assert!(worst_rel(sweep(-86.5, 88.7, 400_000), exp, f64::exp) < 1.2e-7);
        for x in (0..2_000_000_000u32).step_by(9973).map(|i| f32::from_bits(0x0080_0000 + i)) {
            let (l, l2) = (f64::from(x).ln(), f64::from(x).log2());
            assert!((f64::from(ln(x)) - l).abs() < 1.2e-7 * l.abs().max(1.0), "ln {x}");
            assert!((f64::from(log2(x)) - l2).abs() < 1.2e-7 * l2.abs().max(1.0), "log2 {x}");
        }
        for y in [-3.0, -1.0, 0.4166, 1.0, 2.0, 2.4, 64.0] {
            for x in sweep(0.01, 3.0, 20_000) {
                let truth = f64::from(x).powf(f64::from(y));
                if !(1e-37..1e38).contains(&truth) {
                    continue;
                }
                let allowed = 1.2e-7 * (1.0 + f64::from(y * x.log2()).abs());
                assert!((f64::from(pow(x, y)) / truth - 1.0).abs() < allowed, "{x}^{y}");
            }
        }
    }

    #[test]
    fn exponentials_stay_finite_and_follow_their_documented_edges() {
        for x in [-1e30, -126.0, 128.0, 1e30, f32::NAN] {
            assert!(exp2(x).is_finite() && exp2(x) > 0.0 && exp(x).is_finite() && exp(x) > 0.0, "{x}");
        }
        assert_eq!((pow(0.0, 0.0), pow(-2.0, 0.0), pow(0.0, 2.4), pow(-1.0, 2.0)), (1.0, 1.0, 0.0, 0.0));
        assert_eq!((log2(0.0), log2(-1.0), log2(f32::NAN)), (-126.0, -126.0, -126.0));
        assert_eq!((exp2(0.0), exp2(10.0), exp(0.0), log2(1.0), log2(8.0)), (1.0, 1024.0, 1.0, 0.0, 3.0));
    }

    #[test]
    fn comparisons_follow_their_documented_nan_rule() {
        let nan = f32::NAN;
        assert_eq!((min(nan, 1.0), max(nan, 1.0)), (1.0, 1.0));
        assert_eq!(
            (clamp(nan, 2.0, 3.0), saturate(nan), clamp(5.0, 2.0, 3.0), clamp(1.0, 2.0, 3.0)),
            (2.0, 0.0, 3.0, 2.0)
        );
        assert!(is_finite(f32::MAX) && !is_finite(nan) && !is_finite(f32::INFINITY) && !is_finite(f32::NEG_INFINITY));
    }

    #[test]
    fn signs_and_integer_powers() {
        assert_eq!((sign(-0.0), sign(0.0), sign(-3.0), copysign(-2.0, 1.0)), (-1.0, 1.0, -1.0, 2.0));
        assert_eq!((powi(-2.0, 3), powi(-2.0, 10), powi(0.0, 0), powi(5.0, 1)), (-8.0, 1024.0, 1.0, 5.0));
        assert_eq!((exp2_int(-126), exp2_int(0), exp2_int(127)), (f32::MIN_POSITIVE, 1.0, 2f32.powi(127)));
        assert_eq!((lerp(1.0, 3.0, 0.25), square(-3.0)), (1.5, 9.0));
    }
}
