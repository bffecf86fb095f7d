//! How far a picture is from the truth: NRMSE, block NRMSE, bias, 95th percentile, FLIP.
//!
//! The four numerical measures judge *indirect irradiance* (W/m², albedo divided out) at the visible points of a
//! camera, so that textures neither hide nor exaggerate errors of the lighting. FLIP judges the final picture as people
//! see it. All sums are f64. Nothing here returns NaN or infinity: what has no answer is a [`MetricsError`].

use crate::image_io::{Image, Rgb8};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Side in pixels of the blocks of [`ErrorMetrics::nrmse_block`].
pub const BLOCK_PX: u32 = 8;

/// Smallest denominator of a relative error, as a share of the truth's mean: a black corner that is off by a
/// thousandth of the room's brightness is not an error of 1000 %.
pub const RELATIVE_GUARD: f64 = 0.01;

/// Why there is no error to state.
#[derive(Clone, PartialEq, Debug, thiserror::Error)]
pub enum MetricsError {
    /// Pictures, masks or variances of different sizes.
    #[error("{what} has {got} pixels, the truth has {expected}")]
    SizeMismatch {
        /// Which of the inputs.
        what: &'static str,
        /// Its size.
        got: String,
        /// The truth's size.
        expected: String,
    },
    /// The camera sees no surface.
    #[error("the camera sees no surface: there is no irradiance to compare")]
    NoVisiblePoint,
    /// The truth is black at every visible point, so no relative error exists.
    #[error("the truth is zero at every visible point: relative errors do not exist")]
    ZeroTruth,
    /// NaN, infinite or (in a variance) negative values.
    #[error("{what} has {count} values that are not finite or not allowed")]
    BadValues {
        /// Which of the inputs.
        what: &'static str,
        /// How many pixels.
        count: usize,
    },
}

/// Errors of one method on one view.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct ErrorMetrics {
    /// Root mean square error over visible points and channels, divided by the truth's mean. 0 is perfect; no light at
    /// all gives at least 1.
    pub nrmse: f64,
    /// The same on means over blocks of 8×8 pixels: noise averages out, wrong light stays.
    pub nrmse_block: f64,
    /// Mean of the method divided by mean of the truth: above 1 too bright, below 1 too dark.
    pub bias: f64,
    /// 95th percentile of the relative error per visible point, `Σ|e − t| / max(Σt, guard)` over channels, where the
    /// guard is 1 % of the truth's mean.
    pub p95: f64,
    /// Mean FLIP (Andersson et al. 2020) of the tone-mapped final pictures, 0…1; absent where there is no picture.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flip: Option<f64>,
}

/// What the truth's own remaining noise adds to a perfect method's error.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct NoiseFloor {
    /// Expected [`ErrorMetrics::nrmse`] of a perfect method.
    pub nrmse: f64,
    /// Expected [`ErrorMetrics::nrmse_block`] of a perfect method, if pixels are independent.
    pub nrmse_block: f64,
}

/// Compares indirect irradiance with the truth where `visible` is true (row by row, as the pictures). `flip` stays
/// empty: see [`flip`].
///
/// Blocks average their visible pixels only and weigh as many as they have.
///
/// # Errors
/// Every variant of [`MetricsError`].
///
/// ```
/// use interreflect::{image_io::Image, metrics};
/// let flat = |v| Image::new(8, 8, vec![glam::Vec3::splat(v); 64]).unwrap();
/// let error = metrics::compare_irradiance(&flat(2.0), &flat(1.5), &[true; 64])?;
/// assert_eq!((error.nrmse, error.bias), (0.25, 0.75));
/// # Ok::<(), metrics::MetricsError>(())
/// ```
pub fn compare_irradiance(truth: &Image, estimate: &Image, visible: &[bool]) -> Result<ErrorMetrics, MetricsError> {
    check_pair("the estimate", truth, estimate)?;
    let mean = truth_mean(truth, visible)?;
    check_values("the estimate", estimate, visible, |p| p.is_finite())?;
    let mut squares = 0.0;
    let mut total = 0.0;
    let mut relative = Vec::new();
    for (t, e) in visible_pairs(truth, estimate, visible) {
        squares += (e - t).length_squared();
        total += e.element_sum();
        relative.push((e - t).abs().element_sum() / t.element_sum().max(3.0 * RELATIVE_GUARD * mean));
    }
    let channels = 3.0 * relative.len() as f64;
    let block_squares: f64 = blocks(truth, visible, |k| at(estimate, k) - at(truth, k))
        .map(|(sum, count)| sum.length_squared() / count)
        .sum();
    Ok(ErrorMetrics {
        nrmse: (squares / channels).sqrt() / mean,
        nrmse_block: (block_squares / channels).sqrt() / mean,
        bias: total / channels / mean,
        p95: percentile(&mut relative, 0.95),
        flip: None,
    })
}

/// The error that the truth's own noise causes, from `variance`: per pixel and channel, the variance of the truth's
/// *mean* (that is, sample variance divided by the number of samples).
///
/// # Errors
/// Every variant of [`MetricsError`].
pub fn noise_floor(truth: &Image, variance: &Image, visible: &[bool]) -> Result<NoiseFloor, MetricsError> {
    check_pair("the variance", truth, variance)?;
    let mean = truth_mean(truth, visible)?;
    check_values("the variance", variance, visible, |p| p.is_finite() && p.min_element() >= 0.0)?;
    // A block's mean of n independent pixels has variance Σ var / n²; it weighs n.
    let (sum, block_sum, count) = blocks(truth, visible, |k| at(variance, k))
        .fold((0.0, 0.0, 0.0), |(s, b, c), (v, n)| (s + v.element_sum(), b + v.element_sum() / n, c + n));
    let channels = 3.0 * count;
    Ok(NoiseFloor { nrmse: (sum / channels).sqrt() / mean, nrmse_block: (block_sum / channels).sqrt() / mean })
}

/// FLIP of two sRGB pictures.
#[derive(Clone, PartialEq, Debug)]
pub struct Flip {
    /// Mean over all pixels, 0…1.
    pub mean: f64,
    /// Error of every pixel, row by row, 0…1.
    pub map: Vec<f32>,
}

/// LDR-FLIP (Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images"), by its authors' own code,
/// at their default viewing conditions: a 0.7 m wide monitor of 3840 pixels seen from 0.7 m, 67.02 pixels per degree.
///
/// # Errors
/// [`MetricsError::SizeMismatch`]; an empty picture is [`MetricsError::NoVisiblePoint`].
pub fn flip(truth: &Rgb8, estimate: &Rgb8) -> Result<Flip, MetricsError> {
    let (width, height) = truth.dimensions();
    if (width, height) != estimate.dimensions() {
        let size = |p: &Rgb8| format!("{} x {}", p.width(), p.height());
        return Err(MetricsError::SizeMismatch { what: "the picture", got: size(estimate), expected: size(truth) });
    }
    if width == 0 || height == 0 {
        return Err(MetricsError::NoVisiblePoint);
    }
    let load = |p: &Rgb8| nv_flip::FlipImageRgb8::with_data(width, height, p);
    let pixels_per_degree = nv_flip::pixels_per_degree(0.7, 3840.0, 0.7);
    let map = nv_flip::flip(load(truth), load(estimate), pixels_per_degree).to_vec();
    let mean = map.iter().map(|&v| f64::from(v)).sum::<f64>() / map.len() as f64;
    Ok(Flip { mean, map })
}

/// Mean of the truth over visible points and channels, W/m²: the denominator of every relative measure.
///
/// # Errors
/// [`MetricsError::SizeMismatch`] (mask), [`MetricsError::NoVisiblePoint`], [`MetricsError::BadValues`],
/// [`MetricsError::ZeroTruth`].
pub fn truth_mean(truth: &Image, visible: &[bool]) -> Result<f64, MetricsError> {
    if visible.len() != truth.pixels().len() {
        return Err(MetricsError::SizeMismatch {
            what: "the mask",
            got: visible.len().to_string(),
            expected: truth.pixels().len().to_string(),
        });
    }
    check_values("the truth", truth, visible, |p| p.is_finite())?;
    let (sum, count) =
        blocks(truth, visible, |k| at(truth, k)).fold((0.0, 0.0), |(s, c), (v, n)| (s + v.element_sum(), c + n));
    if count == 0.0 {
        return Err(MetricsError::NoVisiblePoint);
    }
    let mean = sum / (3.0 * count);
    if mean > 0.0 { Ok(mean) } else { Err(MetricsError::ZeroTruth) }
}

fn at(picture: &Image, k: usize) -> DVec3 {
    picture.pixels()[k].as_dvec3()
}

fn visible_pairs<'a>(
    truth: &'a Image,
    estimate: &'a Image,
    visible: &'a [bool],
) -> impl Iterator<Item = (DVec3, DVec3)> + 'a {
    (0..visible.len()).filter(|&k| visible[k]).map(|k| (at(truth, k), at(estimate, k)))
}

/// Sum of `value(pixel)` and number of visible pixels of each block that has any.
fn blocks<'a>(
    picture: &Image,
    visible: &'a [bool],
    value: impl Fn(usize) -> DVec3 + 'a,
) -> impl Iterator<Item = (DVec3, f64)> + 'a {
    let [width, height] = picture.size();
    let corners = (0..height.div_ceil(BLOCK_PX))
        .flat_map(move |y| (0..width.div_ceil(BLOCK_PX)).map(move |x| (x * BLOCK_PX, y * BLOCK_PX)));
    corners.filter_map(move |(x0, y0)| {
        let (mut sum, mut count) = (DVec3::ZERO, 0.0);
        for y in y0..(y0 + BLOCK_PX).min(height) {
            for x in x0..(x0 + BLOCK_PX).min(width) {
                let k = y as usize * width as usize + x as usize;
                if visible[k] {
                    sum += value(k);
                    count += 1.0;
                }
            }
        }
        (count > 0.0).then_some((sum, count))
    })
}

/// Percentile with linear interpolation between ranks (Hyndman & Fan's type 7, NumPy's default). `values` not empty.
fn percentile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let rank = share * (values.len() - 1) as f64;
    let (low, high) = (values[rank.floor() as usize], values[rank.ceil() as usize]);
    low + (high - low) * rank.fract()
}

fn check_pair(what: &'static str, truth: &Image, other: &Image) -> Result<(), MetricsError> {
    let size = |p: &Image| format!("{} x {}", p.width(), p.height());
    if truth.size() == other.size() {
        return Ok(());
    }
    Err(MetricsError::SizeMismatch { what, got: size(other), expected: size(truth) })
}

fn check_values(
    what: &'static str,
    picture: &Image,
    visible: &[bool],
    good: impl Fn(&glam::Vec3) -> bool,
) -> Result<(), MetricsError> {
    let count = picture.pixels().iter().zip(visible).filter(|(p, v)| **v && !good(p)).count();
    if count == 0 { Ok(()) } else { Err(MetricsError::BadValues { what, count }) }
}
