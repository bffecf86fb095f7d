//! Real spherical harmonics (SH), orthonormal over the sphere, orders 0 to 9.
//!
//! **Index.** Band `l`, `−l ≤ m ≤ l`, coefficient `k = l(l+1) + m`. Order `n` (counted from 0) holds the bands `0 … n`:
//! `(n+1)²` coefficients.
//!
//! **Signs.** `Y_lm = √2 K_lm cos(mφ) P_l^m(cos θ)` for m > 0, `√2 K_l|m| sin(|m|φ) P_l^|m|(cos θ)` for m < 0, with
//! associated Legendre functions *without* the Condon–Shortley phase: all of `Y_1 = √(3/4π) (y, z, x)` are positive, as in
//! Ramamoorthi & Hanrahan 2001, "An Efficient Representation for Irradiance Environment Maps", eq. 3 (and in the program
//! sphericart). Directions are unit vectors `(x, y, z)`; the polar axis of the formulas is +Z, whatever is up in a scene.
//!
//! **Other conventions.** Green 2003 ("The Gritty Details"), Sloan 2008 ("Stupid Spherical Harmonics Tricks"),
//! Direct3D's SH functions, and with them the papers on sparse radiance probes and light propagation volumes (Kaplanyan
//! & Dachsbacher 2010: `(1, −y, z, −x)` times constants) keep the phase: their coefficient is ours times `(−1)^m`
//! ([`condon_shortley`]); the index is the same. What is quadratic (energies, products of two expansions) or zonal is
//! the same in both.
//!
//! **Code.** [`walk`] is one straight line of polynomials whose constants are computed by the compiler: no table and no
//! array index is left at run time (a device copies a table on every access). `Y_lm = F_l^m(z)·{Re, Im}(x + iy)^|m|`, with
//! `F_l^m = A z F_{l−1}^m − B F_{l−2}^m` upwards in `l`, which is stable (Sloan 2013, "Efficient Spherical Harmonic Evaluation").
//!
//! **Convolution.** A kernel that is symmetric about its axis multiplies band `l` with the factor
//! `λ_l = 2π ∫ h(u) P_l(u) du` (Ramamoorthi & Hanrahan 2001, eq. 8, where it is `√(4π/(2l+1)) h_l`). The same lobe standing
//! around a direction `d` has the coefficients `λ_l Y_lm(d)`. Factors of the clamped cosine, cosine powers, cones and
//! windows are below; they multiply.

use super::float::{PI, cos, sin, sin_cos};
use crate::real::Real;

/// Highest order.
pub const MAX_ORDER: u32 = 9;
/// Bands of the highest order.
pub const BANDS: usize = MAX_ORDER as usize + 1;
/// Coefficients of the highest order.
pub const MAX_COUNT: usize = BANDS * BANDS;

/// Coefficients of an order.
#[inline(always)]
pub const fn count(order: u32) -> usize {
    ((order + 1) * (order + 1)) as usize
}
/// Index of the coefficient of band `l` and `−l ≤ m ≤ l`.
#[inline(always)]
pub const fn index(l: u32, m: i32) -> usize {
    ((l * (l + 1)) as i32 + m) as usize
}
/// Band of a coefficient.
pub const fn band(k: usize) -> u32 {
    let mut l = 0;
    while count(l) <= k {
        l += 1;
    }
    l
}
/// `(−1)^m` of coefficient `k`: multiplies a coefficient with this to pass to or from the conventions that keep the
/// Condon–Shortley phase.
pub const fn condon_shortley(k: usize) -> f32 {
    let l = band(k) as usize;
    // k = l(l+1) + m, and l(l+1) is even.
    if (k - l * l + l) & 1 == 0 { 1.0 } else { -1.0 }
}

/// Square root in constants (Newton; the standard library's is not `const`).
const fn root(x: f64) -> f64 {
    let mut r = if x > 1.0 { x } else { 1.0 };
    let mut step = 0;
    while step < 60 {
        r = 0.5 * (r + x / r);
        step += 1;
    }
    r
}
/// `F_m^m`: the normalization of the sectoral function, with the √2 of m > 0.
const fn sectoral(m: usize) -> f32 {
    // K_mm² ((2m−1)!!)² = (2m+1)/4π · Π (2i−1)/(2i).
    let mut square = (2 * m + 1) as f64 / (4.0 * core::f64::consts::PI);
    let mut i = 1;
    while i <= m {
        square *= (2 * i - 1) as f64 / (2 * i) as f64;
        i += 1;
    }
    root(if m == 0 { square } else { 2.0 * square }) as f32
}
/// Factor of `z F_{l−1}^m`: `√((4l²−1)/(l²−m²))`.
const fn rise(l: usize, m: usize) -> f64 {
    if l > m { root((4 * l * l - 1) as f64 / (l * l - m * m) as f64) } else { 0.0 }
}
/// Factor of `F_{l−2}^m`: `rise(l)/rise(l−1)`, which normalizes the Legendre recurrence.
const fn fall(l: usize, m: usize) -> f64 {
    if l > m + 1 { rise(l, m) / rise(l - 1, m) } else { 0.0 }
}
/// Indices of ±m in band l, 0 where the band has no such m (those are never used).
const fn place(l: usize, m: usize, negative: bool) -> usize {
    let middle = l * (l + 1);
    if m > l {
        0
    } else if negative {
        middle - m
    } else {
        middle + m
    }
}

/// Takes the values of the basis functions one after the other; [`walk`] calls it once for each.
///
/// What changes is apart from the sink itself, so that a sink may hold a buffer: a device cannot change a variable
/// that holds one.
pub trait Sink<R: Real> {
    /// What comes of the values.
    type Result;
    /// The value of basis function `K`.
    fn take<const K: usize>(&self, y: R, result: &mut Self::Result);
}

/// Hands the basis functions up to an order (at most [`MAX_ORDER`]) at a unit vector to `sink`, grouped by |m|. With a
/// constant order, or a sink that ignores some functions, what is not needed is not computed.
#[inline(always)]
#[expect(unused_assignments, reason = "the last step of each recurrence")]
#[expect(clippy::absurd_extreme_comparisons, reason = "comparisons of constants choose the terms")]
pub fn walk<R: Real, S: Sink<R>>(order: u32, [x, y, z]: [R; 3], sink: &S, result: &mut S::Result) {
    // (x + iy)^m = c + is
    let (mut c, mut s) = (x, y);
    unroll!(M in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 => {
        if M as u32 <= order {
            if M > 1 {
                (c, s) = (x * c - y * s, x * s + y * c);
            }
            let (mut f, mut below) = (R::splat(const { sectoral(M) }), R::splat(0.0));
            unroll!(L in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 => {
                if L >= M && L as u32 <= order {
                    if L > M {
                        let raised = z * R::splat(const { rise(L, M) as f32 }) * f;
                        let next =
                            if L == M + 1 { raised } else { raised - R::splat(const { fall(L, M) as f32 }) * below };
                        (below, f) = (f, next);
                    }
                    if M == 0 {
                        sink.take::<{ place(L, 0, false) }>(f, result);
                    } else {
                        sink.take::<{ place(L, M, false) }>(f * c, result);
                        sink.take::<{ place(L, M, true) }>(f * s, result);
                    }
                }
            });
        }
    });
}

struct Collect<const N: usize>;
impl<R: Real, const N: usize> Sink<R> for Collect<N> {
    type Result = [R; N];
    #[inline(always)]
    fn take<const K: usize>(&self, y: R, values: &mut [R; N]) {
        values[K] = y;
    }
}
/// The order whose number of coefficients is `n`, 0 where there is none.
const fn order_of(n: usize) -> u32 {
    if n == 0 { 0 } else { band(n - 1) }
}
/// The first `N` basis functions at a unit vector; `N = (order + 1)²`.
#[inline(always)]
pub fn basis<R: Real, const N: usize>(direction: [R; 3]) -> [R; N] {
    const { assert!(N == count(order_of(N)) && N <= MAX_COUNT, "N must be (order + 1)² of an order up to 9") };
    let mut values = [R::splat(0.0); N];
    walk(const { order_of(N) }, direction, &Collect::<N>, &mut values);
    values
}

/// One basis function chosen at run time, for kernels in which an invocation owns a few coefficients: a loop over its
/// recurrence instead of [`walk`]'s straight line, with the normalization left to the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Function {
    l: u32,
    /// |m|.
    m: u32,
    negative: bool,
    norm: f32,
}

impl Function {
    /// Basis function `k`; 0 everywhere where `k` is beyond `order`. (Without a loop or a branch: on a CPU all directions of a
    /// row share it, and a compiler takes out of a loop only what has none.)
    #[inline(always)]
    pub fn new(k: u32, order: u32) -> Self {
        let mut l = 0;
        unroll!(L in 1, 2, 3, 4, 5, 6, 7, 8, 9 => { l += if k >= (L * L) as u32 { 1 } else { 0 } });
        let middle = l * (l + 1);
        let negative = k < middle;
        let m = if negative { middle - k } else { k - middle };
        Self { l, m, negative, norm: if l <= order { Self::norm(l, m) } else { 0.0 } }
    }

    /// `√2 K_lm (2m−1)!!/(l−m)!` (without √2 for m = 0): `√((2l+1)/2π · (2m−1)!!²/((l+m)! (l−m)!))`. No product exceeds 10¹⁷.
    #[inline(always)]
    fn norm(l: u32, m: u32) -> f32 {
        let (mut odd, mut factorials) = (1.0, if m == 0 { 4.0 * PI } else { 2.0 * PI });
        unroll!(I in 1, 2, 3, 4, 5, 6, 7, 8, 9 => {
            odd *= if I as u32 <= m { (2 * I - 1) as f32 } else { 1.0 };
            factorials *= if I as u32 <= l - m { I as f32 } else { 1.0 };
        });
        unroll!(I in 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18 => {
            factorials *= if I as u32 <= l + m { I as f32 } else { 1.0 };
        });
        super::float::sqrt((2 * l + 1) as f32 * odd * odd / factorials)
    }

    /// Value at a unit vector.
    #[inline(always)]
    pub fn value<R: Real>(&self, [x, y, z]: [R; 3]) -> R {
        // Re or Im of (x + iy)^m, by c_m = 2x c_{m−1} − (x² + y²) c_{m−2}.
        let mut below = R::splat(if self.negative { 0.0 } else { 1.0 });
        let mut f = if self.m == 0 {
            below
        } else if self.negative {
            y
        } else {
            x
        };
        let (twice_x, radius2) = (x + x, x * x + y * y);
        for _ in 1..self.m {
            (below, f) = (f, twice_x.mul_add(f, -(radius2 * below)));
        }
        // Times Q_j = (j−m)! P_j^m: Q_j = (2j−1) z Q_{j−1} − ((j−1)² − m²) Q_{j−2}, without a division.
        let (mut odd, mut gap) = ((2 * self.m + 1) as f32, 0.0);
        for _ in self.m..self.l {
            // Only one operation waits for the step before.
            (below, f) = (f, (z * R::splat(odd)).mul_add(f, -(R::splat(gap) * below)));
            gap += odd;
            odd += 2.0;
        }
        f * R::splat(self.norm)
    }
}

struct Terms<'a, R, const N: usize>(&'a [R; N]);
impl<R: Real, const N: usize> Sink<R> for Terms<'_, R, N> {
    type Result = R;
    #[inline(always)]
    fn take<const K: usize>(&self, y: R, sum: &mut R) {
        *sum = *sum + self.0[K] * y;
    }
}
/// Value of an expansion in a direction: `Σ c_k Y_k`.
#[inline(always)]
pub fn evaluate<R: Real, const N: usize>(coefs: &[R; N], direction: [R; 3]) -> R {
    let mut sum = R::splat(0.0);
    walk(const { order_of(N) }, direction, &Terms(coefs), &mut sum);
    sum
}

struct CosineTerms<'a, R, const N: usize>(&'a [R; N]);
impl<R: Real, const N: usize> Sink<R> for CosineTerms<'_, R, N> {
    type Result = R;
    #[inline(always)]
    fn take<const K: usize>(&self, y: R, sum: &mut R) {
        let factor = const { clamped_cosine_factor(band(K)) };
        if factor != 0.0 {
            *sum = *sum + self.0[K] * (y * R::splat(factor));
        }
    }
}
/// Irradiance (W/m²) on a surface with the given unit normal under the radiance (W/(sr m²)) that the coefficients
/// expand: `Σ A_l c_lm Y_lm(n)` (Ramamoorthi & Hanrahan 2001, eq. 10). May be negative where the expansion rings.
#[inline(always)]
pub fn irradiance<R: Real, const N: usize>(radiance_coefs: &[R; N], normal: [R; 3]) -> R {
    let mut sum = R::splat(0.0);
    walk(const { order_of(N) }, normal, &CosineTerms(radiance_coefs), &mut sum);
    sum
}

struct Lobe<'a, const N: usize>(&'a [f32; BANDS]);
impl<R: Real, const N: usize> Sink<R> for Lobe<'_, N> {
    type Result = [R; N];
    #[inline(always)]
    fn take<const K: usize>(&self, y: R, coefs: &mut [R; N]) {
        coefs[K] = y * R::splat(self.0[const { band(K) as usize }]);
    }
}
/// Coefficients of a lobe around a direction: the zonal function with the factors `λ_l`, rotated from +Z.
#[inline(always)]
pub fn zonal_lobe<R: Real, const N: usize>(factors: &[f32; BANDS], direction: [R; 3]) -> [R; N] {
    let mut coefs = [R::splat(0.0); N];
    walk(const { order_of(N) }, direction, &Lobe::<N>(factors), &mut coefs);
    coefs
}

struct Weighted<R, const N: usize>(R);
impl<R: Real, const N: usize> Sink<R> for Weighted<R, N> {
    type Result = [R; N];
    #[inline(always)]
    fn take<const K: usize>(&self, y: R, coefs: &mut [R; N]) {
        coefs[K] = coefs[K] + self.0 * y;
    }
}
/// Adds a sample of a function to its projection: `c_k += value·Y_k(direction)`. `value` holds the quadrature weight: the
/// function's value times 4π/count for evenly spread directions, or divided by the density of random ones times their count.
#[inline(always)]
pub fn accumulate<R: Real, const N: usize>(coefs: &mut [R; N], direction: [R; 3], value: R) {
    walk(const { order_of(N) }, direction, &Weighted::<R, N>(value), coefs);
}
/// Multiplies every band with its factor: convolution with the kernel that the factors stand for. For the CPU; buffers of
/// coefficients go through the kernel `sh_filter`.
#[cfg(not(target_arch = "spirv"))]
pub fn convolve<const N: usize>(coefs: &[f32; N], factors: &[f32; BANDS]) -> [f32; N] {
    core::array::from_fn(|k| coefs[k] * factors[band(k) as usize])
}

/// The factors of every band, from a function of the band.
pub fn factors(f: impl Fn(u32) -> f32) -> [f32; BANDS] {
    let mut out = [0.0; BANDS];
    for l in 0..BANDS {
        out[l] = f(l as u32);
    }
    out
}
/// Coefficient of m = 0 in band `l` of the zonal function with factor `λ_l`: `λ_l √((2l+1)/4π)`.
pub fn zonal_coefficient(l: u32, factor: f32) -> f32 {
    factor * super::float::sqrt((2 * l + 1) as f32 / (4.0 * PI))
}

/// `2π ∫₀¹ uⁿ P_l(u) du`: factor of the lobe cosⁿθ over the upper hemisphere, not normalized, any real `n ≥ 0` and any
/// band. By `I_l = I_{l−2} (n − l + 2)/(n + l + 1)`, from `I_0 = 1/(n+1)` and `I_1 = 1/(n+2)`.
pub const fn cosine_power_factor(l: u32, n: f32) -> f32 {
    let mut i = if l & 1 == 0 { 1.0 / (n + 1.0) } else { 1.0 / (n + 2.0) };
    let mut j = 2 + l % 2;
    while j <= l {
        i *= (n - j as f32 + 2.0) / (n + j as f32 + 1.0);
        j += 2;
    }
    2.0 * PI * i
}
/// Factor `A_l` of the clamped cosine, which turns radiance into irradiance: π, 2π/3, π/4, 0, −π/24, … (Ramamoorthi &
/// Hanrahan 2001, eq. 8). Any band.
pub const fn clamped_cosine_factor(l: u32) -> f32 {
    cosine_power_factor(l, 1.0)
}
/// Factor of the normalized lobe `(n+1)/2π cosⁿθ`: what blurs an environment for a Phong reflection of exponent `n`.
pub const fn phong_factor(l: u32, n: f32) -> f32 {
    cosine_power_factor(l, n) * (n + 1.0) / (2.0 * PI)
}
/// Factor of a uniform cone: 1 within `half_angle` (rad) of the axis, 0 outside. Any band. Divide by
/// `2π(1 − cos)` for a mean over the cone. `2π ∫_c^1 P_l = 2π (1 − c²) P_l'(c)/(l(l+1))`, which does not cancel in narrow cones.
pub fn cone_factor(l: u32, half_angle: f32) -> f32 {
    let (s, c) = sin_cos(half_angle);
    if l == 0 {
        return 2.0 * PI * super::sampling::one_minus_cos(half_angle);
    }
    // (P, P') of j − 1 and j, upwards: P'_{j+1} = P'_{j−1} + (2j+1) P_j.
    let (mut p_below, mut p, mut d_below, mut d) = (1.0, c, 0.0, 1.0);
    for j in 1..l {
        let w = (2 * j + 1) as f32;
        let next = (w * c * p - j as f32 * p_below) / (j + 1) as f32;
        (d_below, d) = (d, d_below + w * p);
        (p_below, p) = (p, next);
    }
    2.0 * PI * s * s * d / (l * (l + 1)) as f32
}

/// Hanning window of a width in bands (Sloan 2008, "Windowing"): `(1 + cos(πl/width))/2`, 0 from `width` on. Narrower
/// removes more ringing and more detail; `order + 1` keeps some of the last band.
pub fn hanning_window(l: u32, width: f32) -> f32 {
    if (l as f32) < width { 0.5 + 0.5 * cos(PI * l as f32 / width) } else { 0.0 }
}
/// Lanczos window of a width in bands (Sloan 2008): `sinc(πl/width)`, 0 from `width` on. Keeps more detail and more ringing
/// than [`hanning_window`].
pub fn lanczos_window(l: u32, width: f32) -> f32 {
    let t = PI * l as f32 / width;
    if l == 0 {
        1.0
    } else if (l as f32) < width {
        sin(t) / t
    } else {
        0.0
    }
}
/// Window that minimizes squared error plus `lambda` times the squared Laplacian (Sloan 2008): `1/(1 + λ l²(l+1)²)`.
pub fn laplacian_window(l: u32, lambda: f32) -> f32 {
    let d = (l * (l + 1)) as f32;
    1.0 / (1.0 + lambda * d * d)
}

/// The smallest `lambda` of [`laplacian_window`] that brings the squared Laplacian `Σ l²(l+1)² c²` of an expansion down to
/// `fraction` of what it is (Sloan 2008). 0 where it need not fall. Relative error 1e-4.
#[cfg(not(target_arch = "spirv"))]
pub fn lambda_for_laplacian<const N: usize>(coefs: &[f32; N], fraction: f32) -> f32 {
    let squared_laplacian = |lambda: f32| {
        (0..N).fold(0.0, |sum, k| {
            let d = (band(k) * (band(k) + 1)) as f32 * coefs[k] * laplacian_window(band(k), lambda);
            sum + d * d
        })
    };
    let goal = squared_laplacian(0.0) * fraction;
    smallest_lambda(|lambda| squared_laplacian(lambda) <= goal).unwrap_or(LARGEST_LAMBDA)
}

/// The smallest `lambda` of [`laplacian_window`] with which an expansion is nowhere negative, judged in 4096 evenly
/// spread directions (Sloan 2017, "Deringing Spherical Harmonics", looks along the optimal linear direction instead).
/// `None` where the mean is not positive, so that no window helps. Relative error 1e-4.
#[cfg(not(target_arch = "spirv"))]
pub fn lambda_for_positivity<const N: usize>(coefs: &[f32; N]) -> Option<f32> {
    const DIRECTIONS: u32 = 4096;
    // The share of every band in every direction: windows then only weigh the shares.
    let shares: alloc::vec::Vec<[f32; BANDS]> = (0..DIRECTIONS)
        .map(|i| {
            let y = basis::<f32, N>(super::sampling::spherical_fibonacci(i, DIRECTIONS).to_array());
            let mut bands = [0.0; BANDS];
            (0..N).for_each(|k| bands[band(k) as usize] += coefs[k] * y[k]);
            bands
        })
        .collect();
    smallest_lambda(|lambda| {
        let window = factors(|l| laplacian_window(l, lambda));
        coefs[0] > 0.0 && shares.iter().all(|s| (0..BANDS).fold(0.0, |sum, l| sum + window[l] * s[l]) >= 0.0)
    })
}

/// Beyond this a window leaves less than 1e-6 of band 1.
#[cfg(not(target_arch = "spirv"))]
const LARGEST_LAMBDA: f32 = 1e6;
/// Bisection, in ratios, for the smallest value from which on a property holds.
#[cfg(not(target_arch = "spirv"))]
fn smallest_lambda(holds: impl Fn(f32) -> bool) -> Option<f32> {
    if holds(0.0) {
        return Some(0.0);
    }
    if !holds(LARGEST_LAMBDA) {
        return None;
    }
    let (mut low, mut high) = (1e-9f32, LARGEST_LAMBDA);
    while high > low * 1.0001 {
        let middle = super::float::sqrt(low * high);
        if holds(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::sampling::spherical_fibonacci;
    use alloc::vec::Vec;

    /// Gauss–Legendre nodes and weights on [−1, 1] (Newton on the Legendre recurrence).
    fn gauss_legendre(n: u32) -> Vec<(f64, f64)> {
        let node = |i: u32| {
            let mut x = (core::f64::consts::PI * (f64::from(i) + 0.75) / (f64::from(n) + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..20 {
                let (mut below, mut p) = (1.0, x);
                for j in 1..n {
                    let j = f64::from(j);
                    (below, p) = (p, ((2.0 * j + 1.0) * x * p - j * below) / (j + 1.0));
                }
                slope = f64::from(n) * (x * p - below) / (x * x - 1.0);
                x -= p / slope;
            }
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        };
        (0..n).map(node).collect()
    }
    /// Directions and weights that integrate every polynomial of degree 19 over the sphere exactly.
    fn quadrature() -> Vec<([f32; 3], f64)> {
        const AZIMUTHS: u32 = 24;
        let mut out = Vec::new();
        for (z, weight) in gauss_legendre(12) {
            for j in 0..AZIMUTHS {
                let phi = core::f64::consts::TAU * (f64::from(j) + 0.3) / f64::from(AZIMUTHS);
                let r = (1.0 - z * z).sqrt();
                let d = [(r * phi.cos()) as f32, (r * phi.sin()) as f32, z as f32];
                out.push((d, weight * core::f64::consts::TAU / f64::from(AZIMUTHS)));
            }
        }
        out
    }
    fn directions() -> Vec<[f32; 3]> {
        (0..200).map(|i| spherical_fibonacci(i, 200).to_array()).collect()
    }
    fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }
    /// `∫ 2π h(u) P_l(u) du` in f64 by Gauss–Legendre over [low, 1].
    fn factor_by_quadrature(l: u32, low: f64, h: impl Fn(f64) -> f64) -> f64 {
        let half = 0.5 * (1.0 - low);
        let term = |(t, weight): (f64, f64)| {
            let u = low + half * (t + 1.0);
            let (mut below, mut p) = (1.0, u);
            for j in 1..l.max(1) {
                let j = f64::from(j);
                (below, p) = (p, ((2.0 * j + 1.0) * u * p - j * below) / (j + 1.0));
            }
            weight * half * h(u) * if l == 0 { 1.0 } else { p }
        };
        core::f64::consts::TAU * gauss_legendre(48).into_iter().map(term).sum::<f64>()
    }

    #[test]
    fn indices_and_bands() {
        for l in 0..=MAX_ORDER {
            for m in -(l as i32)..=l as i32 {
                let k = index(l, m);
                assert_eq!((band(k), condon_shortley(k)), (l, if m % 2 == 0 { 1.0 } else { -1.0 }));
            }
            assert_eq!(index(l, l as i32) + 1, count(l));
        }
        assert_eq!((count(MAX_ORDER), MAX_COUNT), (100, 100));
    }

    #[test]
    fn functions_are_orthonormal() {
        let nodes: Vec<_> = quadrature().into_iter().map(|(d, w)| (basis::<f32, 100>(d), w)).collect();
        for a in 0..MAX_COUNT {
            for b in 0..=a {
                let product: f64 = nodes.iter().map(|(y, w)| f64::from(y[a]) * f64::from(y[b]) * w).sum();
                assert!((product - f64::from(u32::from(a == b))).abs() < 1e-5, "{a}, {b}: {product}");
            }
        }
    }

    /// Cosine between two directions in double precision: P₉ has a slope of 45 at 1, where rounded lengths would show.
    fn cosine(a: [f32; 3], b: [f32; 3]) -> f64 {
        let dot = |a: [f32; 3], b: [f32; 3]| (0..3).map(|i| f64::from(a[i]) * f64::from(b[i])).sum::<f64>();
        dot(a, b) / (dot(a, a) * dot(b, b)).sqrt()
    }

    #[test]
    fn addition_theorem_holds_in_every_band() {
        // Σ_m Y_lm(a) Y_lm(b) = (2l+1)/4π P_l(a·b)  (Unsöld)
        for (a, b) in directions().into_iter().zip(directions().into_iter().rev()) {
            for (a, b) in [(a, b), (a, a), (b, [0.0, 1.0, 0.0])] {
                let (ya, yb, u) = (basis::<f32, 100>(a), basis::<f32, 100>(b), cosine(a, b));
                let (mut below, mut p) = (0.0, 1.0);
                for l in 0..=MAX_ORDER {
                    let sum: f64 =
                        (count(l) - (2 * l as usize + 1)..count(l)).map(|k| f64::from(ya[k]) * f64::from(yb[k])).sum();
                    let w = f64::from(2 * l + 1);
                    assert!((sum - w / (2.0 * core::f64::consts::TAU) * p).abs() < 1e-5, "band {l} at {a:?}, {b:?}");
                    let j = f64::from(l);
                    (below, p) = (p, (w * u * p - j * below) / (j + 1.0));
                }
            }
        }
    }

    /// Values of the Python package sphericart 2.0.4 (Bigi et al. 2023), `SphericalHarmonics(9).compute(d)` in double
    /// precision, at (2/7, −3/7, 6/7) and (−0.36, 0.8, −0.48).
    #[rustfmt::skip]
    const SPHERICART: [([f32; 3], [f32; 100]); 2] = [
        (
            [2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0],
            [
        0.282094792, -0.209401077, 0.418802153, 0.139600718, -0.133781440, -0.401344321, 0.379757191, 0.267562881, -0.055742267, -0.015482193,
        -0.303387790, -0.523670552, 0.215419574, 0.349113701, -0.126411579, -0.079131210, 0.031278754, -0.039811354, -0.479983665, -0.526654714,
        -0.015729046, 0.351103142, -0.199993194, -0.203480255, -0.031018098, 0.023315291, 0.088919906, -0.072045266, -0.605787596, -0.397861094,
        -0.242863102, 0.265240730, -0.252411498, -0.368231361, -0.088178907, 0.004764599, 0.004808170, 0.072055265, 0.178582754, -0.105283733,
        -0.630339959, -0.165175674, -0.399135313, 0.110117116, -0.262641649, -0.538116858, -0.177094565, 0.014724861, 0.011817182, -0.003820283,
        0.015961683, 0.157615449, 0.291258061, -0.130131129, -0.528167835, 0.111367298, -0.439395956, -0.074244865, -0.220069931, -0.665114661,
        -0.288830910, 0.032209522, 0.039229499, 0.005627811, -0.003611251, -0.013501225, 0.037541421, 0.280815064, 0.406086329, -0.137497904,
        -0.309046900, 0.356921284, -0.352402472, -0.237947523, -0.128769541, -0.702767067, -0.402702276, 0.057385993, 0.092266657, 0.019889194,
        -0.000030220, -0.001046753, -0.013492354, -0.033822805, 0.072039837, 0.430034261, 0.494227539, -0.121617673, -0.017815204, 0.503498484,
        -0.163608782, -0.335665656, -0.007423002, -0.621601440, -0.490108976, 0.087879698, 0.177054430, 0.049825727, -0.000112909, -0.001598960,
            ],
        ),
        (
            [-0.36, 0.8, -0.48],
            [
        0.282094792, 0.390882010, -0.234529206, -0.175896904, -0.314653948, -0.419538597, -0.097392915, 0.188792369, -0.278818359, -0.118575160,
        0.399598126, 0.055576769, 0.331022334, -0.025009546, 0.354088339, 0.380309056, 0.367979396, 0.170748230, -0.166986966, 0.356390924,
        -0.217289268, -0.160375916, -0.147969006, -0.547645040, -0.044601961, -0.176361562, -0.585815802, -0.105553484, -0.204628953, -0.402518339,
        -0.124414677, 0.181133253, -0.181323989, 0.338544311, 0.071005425, -0.291911622, -0.176982343, 0.305222714, 0.455217313, -0.041373307,
        0.370215576, 0.035846085, 0.336646984, -0.016130738, 0.328052135, 0.132697637, -0.055175874, 0.505201114, 0.256229597, 0.278128151,
        0.329015841, -0.278182869, 0.001405958, 0.145116252, -0.168414622, 0.366693147, -0.197825573, -0.165011916, -0.149234068, -0.465434959,
        -0.000170413, -0.460445074, -0.476339021, 0.051075085, -0.061090063, -0.550440836, -0.338691072, 0.067630081, -0.433181782, -0.109636412,
        -0.199984624, -0.389894984, -0.147307971, 0.175452743, -0.177208597, 0.351639589, 0.052504997, 0.111940529, 0.490346523, -0.101082226,
        -0.248303266, -0.181490818, 0.127816997, 0.625105630, 0.143459255, 0.183313222, 0.462146911, -0.031282378, 0.363922077, 0.009815125,
        0.339104216, -0.004416806, 0.322475396, 0.100332749, -0.056015795, 0.303417930, -0.207695899, 0.114793570, 0.519517845, 0.142049906,
            ],
        ),
    ];

    #[test]
    fn values_are_an_independent_programs() {
        for (d, expected) in &SPHERICART {
            let y = basis::<f32, 100>(*d);
            for k in 0..MAX_COUNT {
                assert!((y[k] - expected[k]).abs() < 2e-6, "{k}: {} against {}", y[k], expected[k]);
            }
        }
    }

    #[test]
    fn first_bands_are_the_papers_polynomials() {
        // Ramamoorthi & Hanrahan 2001, eq. 3.
        let [x, y, z] = [0.36f32, 0.48, 0.8];
        let expected = [
            0.282095,
            0.488603 * y,
            0.488603 * z,
            0.488603 * x,
            1.092548 * x * y,
            1.092548 * y * z,
            0.315392 * (3.0 * z * z - 1.0),
            1.092548 * x * z,
            0.546274 * (x * x - y * y),
        ];
        let got = basis::<f32, 9>([x, y, z]);
        for k in 0..9 {
            assert!((got[k] - expected[k]).abs() < 1e-6, "{k}: {} against {}", got[k], expected[k]);
        }
        // The light propagation volumes' basis: 0.2820948 and 0.4886025·(−y, z, −x).
        let lpv = [0.282_094_8, -0.488_602_5 * y, 0.488_602_5 * z, -0.488_602_5 * x];
        for k in 0..4 {
            assert!((got[k] * condon_shortley(k) - lpv[k]).abs() < 1e-6);
        }
    }

    #[test]
    fn every_order_is_the_start_of_the_highest() {
        fn check<const N: usize>(d: [f32; 3]) {
            let (all, some) = (basis::<f32, 100>(d), basis::<f32, N>(d));
            assert_eq!(some[..], all[..N]);
            let mut coefs = [0.0; N];
            accumulate(&mut coefs, d, 2.0);
            assert!((evaluate(&coefs, d) - 2.0 * N as f32 / (4.0 * PI)).abs() < 1e-4, "Σ Y² = (n+1)²/4π");
        }
        for d in directions() {
            let checks = [check::<1>, check::<4>, check::<9>, check::<16>, check::<25>, check::<36>, check::<49>];
            checks.into_iter().chain([check::<64>, check::<81>, check::<100>]).for_each(|check| check(d));
            let all = basis::<f32, 100>(d);
            for k in 0..100 {
                let single = Function::new(k, MAX_ORDER).value(d);
                assert!((single - all[k as usize]).abs() < 2e-6, "{k} at {d:?}: {single} {}", all[k as usize]);
                assert_eq!(Function::new(k, 3).value(d) == 0.0, k >= 16 || single == 0.0);
            }
        }
    }

    #[test]
    fn clamped_cosine_has_the_papers_closed_form() {
        // Ramamoorthi & Hanrahan 2001, eq. 8, for even l: 2π (−1)^(l/2−1)/((l+2)(l−1)) · l!/(2^l ((l/2)!)²).
        let factorial = |n: u32| (1..=n).map(f64::from).product::<f64>();
        for l in 0..=20u32 {
            let expected = match l {
                0 => core::f64::consts::PI,
                1 => core::f64::consts::TAU / 3.0,
                l if l % 2 == 1 => 0.0,
                l => {
                    let sign = if l % 4 == 2 { 1.0 } else { -1.0 };
                    core::f64::consts::TAU * sign / (f64::from(l + 2) * (f64::from(l) - 1.0)) * factorial(l)
                        / (2f64.powi(l as i32) * factorial(l / 2).powi(2))
                }
            };
            assert!((f64::from(clamped_cosine_factor(l)) - expected).abs() < 1e-6, "{l}");
        }
    }

    #[test]
    fn factors_are_their_integrals() {
        for l in 0..=12 {
            for n in [0.0, 1.0, 5.0, 20.0] {
                let truth = factor_by_quadrature(l, 0.0, |u| u.powf(n));
                assert!((f64::from(cosine_power_factor(l, n as f32)) - truth).abs() < 2e-6, "cos^{n}, band {l}");
            }
            for angle in [0.001f32, 0.05, 0.7, 1.5, 2.8] {
                let truth = factor_by_quadrature(l, f64::from(angle).cos(), |_| 1.0);
                let error = f64::from(cone_factor(l, angle)) - truth;
                assert!(
                    error.abs() < 4e-6 * truth.abs() + 3e-6 * f64::from(angle).powi(2),
                    "cone {angle}, band {l}: {error}"
                );
            }
        }
        assert!((phong_factor(0, 7.5) - 1.0).abs() < 1e-6, "a normalized lobe keeps the mean");
        assert!((zonal_coefficient(1, clamped_cosine_factor(1)) - 1.023_326_7).abs() < 1e-6, "Kaplanyan's constant");
    }

    #[test]
    fn irradiance_is_the_cosine_integral_of_radiance() {
        // Radiance 1 + 2 d·a + 3 (d·b)²: order 2, so that its expansion is exact and its irradiance has a closed form.
        let (a, b) = ([0.6f32, 0.0, 0.8], [0.0f32, 1.0, 0.0]);
        let mut coefs = [0.0f32; 100];
        for (d, w) in quadrature() {
            accumulate(&mut coefs, d, w as f32 * (1.0 + 2.0 * dot(d, a) + 3.0 * dot(d, b).powi(2)));
        }
        for n in directions() {
            let truth = PI + 2.0 * (2.0 * PI / 3.0) * dot(n, a) + 3.0 * (PI / 4.0) * (1.0 + dot(n, b).powi(2));
            let got = irradiance(&coefs, n);
            assert!((got - truth).abs() < 1e-5 * truth.abs().max(4.0), "{n:?}: {got} against {truth}");
            let few: [f32; 9] = core::array::from_fn(|k| coefs[k]);
            assert!((irradiance(&few, n) - truth).abs() < 1e-5 * truth.abs().max(4.0));
            let convolved = convolve(&coefs, &factors(clamped_cosine_factor));
            assert!((evaluate(&convolved, n) - got).abs() < 1e-5, "convolution, then value");
        }
    }

    #[test]
    fn lobes_turn_with_their_direction() {
        // A lobe is its own projection; around any direction it is the same function of the angle to it.
        let lobe_factors = factors(|l| cosine_power_factor(l, 3.0) * hanning_window(l, 10.0));
        let at_pole: [f32; 100] = zonal_lobe(&lobe_factors, [0.0, 0.0, 1.0]);
        for l in 0..BANDS as u32 {
            for m in -(l as i32)..=l as i32 {
                let expected = if m == 0 { zonal_coefficient(l, lobe_factors[l as usize]) } else { 0.0 };
                assert!((at_pole[index(l, m)] - expected).abs() < 2e-6, "{l} {m}");
            }
        }
        for axis in directions() {
            let turned: [f32; 100] = zonal_lobe(&lobe_factors, axis);
            for d in directions() {
                let u = dot(d, axis).clamp(-1.0, 1.0);
                let reference = evaluate(&at_pole, [(1.0 - u * u).sqrt(), 0.0, u]);
                assert!((evaluate(&turned, d) - reference).abs() < 1e-5, "{axis:?} {d:?}");
            }
        }
    }

    fn smallest_value(coefs: &[f32; 36]) -> f32 {
        (0..10_000).map(|i| evaluate(coefs, spherical_fibonacci(i, 10_000).to_array())).fold(f32::MAX, f32::min)
    }

    #[test]
    fn windows_remove_ringing() {
        // A narrow light, 30 times: an expansion that is far below zero beside and behind it.
        let light: [f32; 36] = zonal_lobe(&factors(|l| 30.0 * cone_factor(l, 0.1)), [0.48, 0.6, 0.64]);
        let ringing = smallest_value(&light);
        assert!(ringing < -0.3, "{ringing}");
        let windowed = |f: &dyn Fn(u32) -> f32| smallest_value(&convolve(&light, &factors(f)));
        assert!(windowed(&|l| hanning_window(l, 6.0)) > 0.1 * ringing);
        assert!(windowed(&|l| lanczos_window(l, 6.0)) > 0.3 * ringing);

        let lambda = lambda_for_positivity(&light).expect("the mean is positive");
        let least = windowed(&|l| laplacian_window(l, lambda));
        assert!(least > -1e-3, "{least}");
        assert!(windowed(&|l| laplacian_window(l, 0.8 * lambda)) < -1e-3, "no smaller window does it");
        assert_eq!(lambda_for_positivity(&light.map(|c| -c)), None);
        let calm: [f32; 36] = zonal_lobe(&factors(|l| if l == 0 { 1.0 } else { 0.0 }), [0.0, 0.0, 1.0]);
        assert_eq!(lambda_for_positivity(&calm), Some(0.0));
    }

    #[test]
    fn laplacian_falls_to_the_asked_fraction() {
        let light: [f32; 36] = zonal_lobe(&factors(|l| cone_factor(l, 0.1)), [0.48, 0.6, 0.64]);
        let energy = |c: &[f32; 36]| (0..36).map(|k| ((band(k) * (band(k) + 1)) as f32 * c[k]).powi(2)).sum::<f32>();
        for fraction in [0.9, 0.5, 0.1, 0.01] {
            let lambda = lambda_for_laplacian(&light, fraction);
            let window = convolve(&light, &factors(|l| laplacian_window(l, lambda)));
            assert!((energy(&window) / energy(&light) - fraction).abs() < 1e-3 * fraction.max(0.1), "{fraction}");
        }
        assert_eq!(lambda_for_laplacian(&light, 1.0), 0.0);
        assert_eq!((hanning_window(0, 4.0), hanning_window(5, 4.0), lanczos_window(0, 4.0)), (1.0, 0.0, 1.0));
        assert!((lanczos_window(2, 4.0) - 2.0 / PI).abs() < 1e-6 && lanczos_window(4, 4.0) == 0.0);
    }

    #[test]
    fn lanes_have_the_bits_of_scalars() {
        use crate::real::Lanes;
        let all = directions();
        for group in all.chunks_exact(16) {
            let lanes = [0, 1, 2].map(|axis| Lanes::<16>(core::array::from_fn(|i| group[i][axis])));
            let wide = basis::<Lanes<16>, 100>(lanes);
            for (i, d) in group.iter().enumerate() {
                let single = basis::<f32, 100>(*d);
                assert!((0..100).all(|k| single[k].to_bits() == wide[k].0[i].to_bits()));
            }
        }
    }
}
