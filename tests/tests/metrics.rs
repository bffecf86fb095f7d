//! Errors against values worked out by hand, and FLIP against its authors' own program.

use glam::Vec3;
use interreflect::image_io::{Image, Rgb8};
use interreflect::metrics::{self, MetricsError, compare_irradiance, noise_floor};

fn image(width: u32, height: u32, f: impl Fn(u32, u32) -> Vec3) -> Image {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| f(x, y)).collect();
    Image::new(width, height, pixels).expect("a picture with pixels")
}

fn flat(width: u32, height: u32, value: f32) -> Image {
    image(width, height, |_, _| Vec3::splat(value))
}

#[track_caller]
fn close(got: f64, want: f64) {
    assert!((got - want).abs() <= 1e-9 * want.abs().max(1.0), "got {got}, want {want}");
}

/// Four pixels, truth 1, 2, 3, 4 in red only; errors +0.5, 0, −1, 0. Mean over 12 values: 10/12.
/// RMSE = √((0.25 + 1)/12); one block: mean error −0.5/4 in one of three channels.
#[test]
fn four_pixels_by_hand() {
    let truth = image(4, 1, |x, _| Vec3::X * (x + 1) as f32);
    let estimate = image(4, 1, |x, _| Vec3::X * [1.5, 2.0, 2.0, 4.0][x as usize]);
    let error = compare_irradiance(&truth, &estimate, &[true; 4]).expect("comparable");
    let mean = 10.0 / 12.0;
    close(error.nrmse, (1.25_f64 / 12.0).sqrt() / mean);
    close(error.nrmse_block, (0.125_f64.powi(2) / 3.0).sqrt() / mean);
    close(error.bias, 0.95);
    // Relative errors 1/2, 0, 1/3, 0, sorted 0 0 1/3 1/2; rank 0.95 · 3 = 2.85.
    close(error.p95, 1.0 / 3.0 + 0.85 * (0.5 - 1.0 / 3.0));
    assert_eq!(error.flip, None);
}

/// A pixel outside the mask may hold anything: it changes no number.
#[test]
fn hidden_pixels_do_not_count() {
    let visible: Vec<bool> = (0..20 * 12).map(|k| k % 3 != 0).collect();
    let truth = image(20, 12, |x, y| Vec3::new(1.0, 2.0, 0.5) * (1.0 + (x * y) as f32 * 0.01));
    let estimate = image(20, 12, |x, y| Vec3::new(1.1, 1.7, 0.6) * (1.0 + (x + y) as f32 * 0.02));
    let poison = |clean: &Image, value: f32| {
        image(20, 12, |x, y| if (x + 20 * y) % 3 == 0 { Vec3::splat(value) } else { clean.pixel(x, y) })
    };
    let clean = compare_irradiance(&truth, &estimate, &visible).expect("comparable");
    let dirty = compare_irradiance(&poison(&truth, f32::NAN), &poison(&estimate, 1e30), &visible).expect("comparable");
    assert_eq!(clean, dirty);
    assert!(clean.nrmse_block > 0.0 && clean.nrmse_block < clean.nrmse);
}

/// Two blocks, one with 64 visible pixels that is right, one with a single visible pixel that is off by 1: the error
/// weighs 1 of 65 pixels.
#[test]
fn blocks_weigh_their_visible_pixels() {
    let truth = flat(16, 8, 2.0);
    let estimate = image(16, 8, |x, _| Vec3::splat(if x < 8 { 2.0 } else { 3.0 }));
    let visible: Vec<bool> = (0..128).map(|k| k % 16 < 8 || k == 8).collect();
    let error = compare_irradiance(&truth, &estimate, &visible).expect("comparable");
    close(error.nrmse_block, (1.0_f64 / 65.0).sqrt() / 2.0);
    close(error.nrmse, error.nrmse_block);
}

/// Noise that averages to zero within each block shows in `nrmse` and not in `nrmse_block`; an offset shows in both.
#[test]
fn block_means_ignore_noise_but_not_bias() {
    let truth = flat(24, 16, 1.0);
    let noisy =
        |offset: f32| image(24, 16, move |x, y| Vec3::splat(1.0 + offset + if (x + y) % 2 == 0 { 0.5 } else { -0.5 }));
    let visible = [true; 24 * 16];
    let noise = compare_irradiance(&truth, &noisy(0.0), &visible).expect("comparable");
    close(noise.nrmse, 0.5);
    close(noise.nrmse_block, 0.0);
    close(noise.bias, 1.0);
    let biased = compare_irradiance(&truth, &noisy(0.25), &visible).expect("comparable");
    close(biased.nrmse_block, 0.25);
    close(biased.bias, 1.25);
}

/// Pictures whose sides are no multiple of 8 have smaller blocks at their ends, and lose no pixel.
#[test]
fn ragged_blocks_cover_every_pixel() {
    let truth = flat(13, 11, 1.0);
    let estimate = image(13, 11, |x, y| Vec3::splat(if (x, y) == (12, 10) { 16.0 } else { 1.0 }));
    let error = compare_irradiance(&truth, &estimate, &[true; 143]).expect("comparable");
    // The last block has 5 × 3 pixels: its mean is off by 1, and it weighs 15 of 143.
    close(error.nrmse_block, (15.0_f64 / 143.0).sqrt());
    close(error.bias, 1.0 + 15.0 / 143.0);
}

/// No light at all is an error of at least 1; in a uniform field exactly 1.
#[test]
fn no_light_is_an_error_of_one() {
    let error = compare_irradiance(&flat(9, 9, 3.0), &flat(9, 9, 0.0), &[true; 81]).expect("comparable");
    close(error.nrmse, 1.0);
    close(error.nrmse_block, 1.0);
    close(error.bias, 0.0);
    close(error.p95, 1.0);
}

/// In the dark, the denominator of a relative error is 1 % of the truth's mean.
#[test]
fn relative_error_is_guarded_in_the_dark() {
    let truth = image(2, 1, |x, _| Vec3::splat(if x == 0 { 0.0 } else { 2.0 }));
    let estimate = image(2, 1, |x, _| Vec3::splat(if x == 0 { 0.02 } else { 2.0 }));
    let error = compare_irradiance(&truth, &estimate, &[true; 2]).expect("comparable");
    // Mean 1, guard 0.01: relative errors 2 and 0; rank 0.95.
    assert!((error.p95 - 1.9).abs() < 1e-6, "{}", error.p95);
}

/// The floor equals the error of a noisy copy on average: checkerboard noise of ±σ has variance σ² at every pixel.
#[test]
fn noise_floor_by_hand() {
    let truth = flat(16, 16, 2.0);
    let floor = noise_floor(&truth, &flat(16, 16, 0.04), &[true; 256]).expect("a floor");
    assert!((floor.nrmse - 0.2 / 2.0).abs() < 1e-7, "{floor:?}");
    assert!((floor.nrmse_block - 0.2 / 8.0 / 2.0).abs() < 1e-7, "{floor:?}");
}

#[test]
fn what_has_no_answer_is_an_error() {
    let one = flat(4, 4, 1.0);
    let all = [true; 16];
    let compare = |t: &Image, e: &Image, v: &[bool]| compare_irradiance(t, e, v).expect_err("no answer");
    assert_eq!(compare(&one, &one, &[false; 16]), MetricsError::NoVisiblePoint);
    assert_eq!(compare(&flat(4, 4, 0.0), &one, &all), MetricsError::ZeroTruth);
    assert!(matches!(compare(&one, &flat(4, 5, 1.0), &all), MetricsError::SizeMismatch { what: "the estimate", .. }));
    assert!(matches!(compare(&one, &one, &[true; 15]), MetricsError::SizeMismatch { what: "the mask", .. }));
    let holes = image(4, 4, |x, _| Vec3::splat(if x == 1 { f32::NAN } else { 1.0 }));
    assert_eq!(compare(&one, &holes, &all), MetricsError::BadValues { what: "the estimate", count: 4 });
    assert_eq!(compare(&holes, &one, &all), MetricsError::BadValues { what: "the truth", count: 4 });
    let negative = noise_floor(&one, &flat(4, 4, -1.0), &all).expect_err("a negative variance");
    assert_eq!(negative, MetricsError::BadValues { what: "the variance", count: 16 });
}

/// 96×64 pictures in integer arithmetic. The values are what FLIP's authors' package says of them (pip package
/// `flip-evaluator` 1.7, `evaluate(reference, test, "LDR")`, 67.0206 pixels per degree).
#[test]
fn flip_agrees_with_its_authors() {
    let picture = |f: fn(u32, u32) -> [u32; 3]| {
        Rgb8::from_fn(96, 64, |x, y| image::Rgb(f(x, y).map(|v| u8::try_from(v % 256).expect("below 256"))))
    };
    let truth = picture(|x, y| [x * 5 + y * 3, x * 2 + y * 7, (x / 8 + y / 8) % 2 * 160 + 40]);
    let test = picture(|x, y| [x * 5 + y * 3 + 20 * (x / 16 % 2), x * 2 + y * 7, (x / 8 + y / 8) % 2 * 120 + 50]);
    let ramp = picture(|x, y| [x * 2 + y, x * 2 + y, x * 2 + y]);
    let dots = picture(|x, y| [x * 2 + y + u32::from((x * y) % 11 == 3) * 25, x * 2 + y, x * 2 + y]);
    let mean = |a: &Rgb8, b: &Rgb8| metrics::flip(a, b).expect("equal sizes").mean;
    for (got, want) in
        [(mean(&truth, &test), 0.305_680), (mean(&ramp, &dots), 0.048_035), (mean(&ramp, &truth), 0.847_786)]
    {
        assert!((got - want).abs() < 1e-5, "got {got}, want {want}");
    }
    assert_eq!(mean(&truth, &truth), 0.0);
}

/// Two grey pictures, codes 128 and 160, by hand (Andersson et al. 2020, §4.1): lightness 53.585 and 65.868, no colour
/// and no features; HyAB = 12.28, to the power 0.7, scaled by 0.95 / (0.4 c_max) = 0.33302. The feature term is the square
/// root of what is zero up to f32 rounding, √1e-7 = 3e-4: that is the tolerance.
#[test]
fn flip_of_two_greys_by_hand() {
    let grey = |code: u8| Rgb8::from_pixel(40, 30, image::Rgb([code; 3]));
    let got = metrics::flip(&grey(128), &grey(160)).expect("equal sizes").mean;
    assert!((got - 0.333_022).abs() < 3e-4, "{got}");
}

#[test]
fn flip_refuses_pictures_of_different_or_no_size() {
    let different = metrics::flip(&Rgb8::new(4, 4), &Rgb8::new(4, 5)).expect_err("different sizes");
    assert!(matches!(different, MetricsError::SizeMismatch { .. }), "{different}");
    assert_eq!(metrics::flip(&Rgb8::new(0, 0), &Rgb8::new(0, 0)).expect_err("empty"), MetricsError::NoVisiblePoint);
}
