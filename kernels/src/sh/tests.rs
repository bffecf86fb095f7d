//! The family against plain expansions of [`crate::math::sh`], and its lanes against its scalars.

use crate::kernel::{At, CaseInput, Flavour, Kernel, Piece};
use crate::math::{float::PI, sampling::spherical_fibonacci, sh};
use alloc::vec::Vec;
use interreflect_shared::sh::{ShFilterParams, ShLayout, ShParams};

/// Runs a whole case through a row of the kernel table, as an executor does.
fn run(kernel: &Kernel, buffers: &[Vec<u32>]) -> Vec<f32> {
    let (uniform, rest) = buffers.split_first().expect("a uniform");
    // Records with vectors need the alignment that an executor's buffers have.
    let mut aligned = [glam::Vec4::ZERO; 8];
    bytemuck::cast_slice_mut(&mut aligned)[..uniform.len()].copy_from_slice(uniform);
    let uniform = &bytemuck::cast_slice(&aligned)[..uniform.len()];
    let (out, reads) = rest.split_last().expect("an output");
    let rows = (kernel.rows)(uniform, 0);
    let mut out = out.clone();
    if rows.count > 0 && rows.len > 0 {
        let mut planes: Vec<&mut [u32]> = out.chunks_exact_mut(rows.plane as usize).collect();
        let reads: Vec<&[u32]> = reads.iter().map(Vec::as_slice).collect();
        let job =
            Piece { first_row: 0, row_count: rows.count, uniform, reads: &reads, planes: &mut planes, atomics: &[] };
        (kernel.cpu)(job);
    }
    out.into_iter().map(f32::from_bits).collect()
}
fn words<T: bytemuck::Pod>(values: &[T]) -> Vec<u32> {
    let mut words = alloc::vec![0; size_of_val(values) / 4];
    bytemuck::cast_slice_mut::<u32, u8>(&mut words).copy_from_slice(bytemuck::cast_slice(values));
    words
}

#[test]
fn lanes_have_the_bits_of_the_scalar_body() {
    fn check<const PLANES: usize>(kernel: &Kernel, scalar: impl Fn(At, &[u32], &[&[f32]]) -> [f32; PLANES]) {
        assert_eq!(kernel.plane_count, PLANES);
        for (seed, count) in [0usize, 1, 15, 16, 17, 63, 64, 65, 200].into_iter().enumerate() {
            for flavour in [Flavour::Ordinary, Flavour::Zero, Flavour::Tiny, Flavour::Huge] {
                let case = (kernel.case)(&mut CaseInput::new(seed as u32 + 10 * flavour as u32, count, flavour));
                let got = run(kernel, &case.buffers);
                let uniform = &case.buffers[0];
                let rows = (kernel.rows)(uniform, 0);
                let reads: Vec<&[f32]> =
                    case.buffers[1..case.buffers.len() - 1].iter().map(|b| bytemuck::cast_slice(b)).collect();
                for id in 0..rows.invocations() {
                    let at = rows.at(id);
                    for (plane, value) in scalar(at, uniform, &reads).into_iter().enumerate() {
                        let i = plane * rows.plane as usize + at.i;
                        assert!(value.is_finite(), "{}", kernel.desc.name);
                        assert_eq!(value.to_bits(), got[i].to_bits(), "{} {count} {flavour:?}", kernel.desc.name);
                    }
                }
            }
        }
    }
    let p = |u: &[u32]| bytemuck::cast_slice::<u32, ShParams>(u)[0];
    check(&super::basis::sh_basis::KERNEL, |at, u, r| super::basis::table::<f32>(at, &p(u), r[0]));
    check(&super::project::sh_project::KERNEL, |at, u, r| super::project::coefficients::<f32>(at, &p(u), r[0], r[1]));
    check(&super::project_rays::sh_project_rays::KERNEL, |at, u, r| {
        super::project_rays::coefficients::<f32>(at, &p(u), r[0], r[1])
    });
    check(&super::filter::sh_filter::KERNEL, |at, u, r| {
        super::filter::filtered::<f32>(
            at,
            &bytemuck::pod_read_unaligned::<ShFilterParams>(bytemuck::cast_slice(u)),
            r[0],
        )
    });
    check(&super::irradiance::sh_irradiance::KERNEL, |at, u, r| {
        super::irradiance::irradiance::<f32>(at, &p(u), r[0], r[1])
    });
}

const ELEMENTS: u32 = 70;
const SAMPLES: u32 = 600;

fn direction(sample: u32) -> [f32; 3] {
    spherical_fibonacci(sample, SAMPLES).to_array()
}
/// Radiance of an element: a constant and a lobe that differ by element and channel.
fn radiance(element: u32, channel: u32, d: [f32; 3]) -> f32 {
    let axis = spherical_fibonacci(element, ELEMENTS).to_array();
    let u = d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
    0.3 + channel as f32 + (u.max(0.0)).powi(3) * (1.0 + element as f32 * 0.1)
}
/// The expansion of that radiance by plain sums.
fn expansion(element: u32, channel: u32) -> [f32; 100] {
    let mut coefs = [0.0; 100];
    for d in (0..SAMPLES).map(direction) {
        sh::accumulate(&mut coefs, d, radiance(element, channel, d) * 4.0 * PI / SAMPLES as f32);
    }
    coefs
}
fn params(order: u32) -> ShParams {
    ShParams { element_count: ELEMENTS, sample_count: SAMPLES, order, weight: 4.0 * PI / SAMPLES as f32 }
}
fn samples(value: impl Fn(u32, u32, u32) -> f32) -> Vec<f32> {
    let mut out = alloc::vec![0.0; ShLayout::new(ELEMENTS, 0).samples_len(SAMPLES)];
    for i in 0..ELEMENTS * SAMPLES * 3 {
        let (element, sample, axis) = (i / (3 * SAMPLES), i / 3 % SAMPLES, i % 3);
        out[ShLayout::sample(element, sample, axis, SAMPLES)] = value(element, sample, axis);
    }
    out
}
fn radiance_samples() -> Vec<f32> {
    samples(|element, sample, channel| radiance(element, channel, direction(sample)))
}
/// The table of basis functions by its kernel.
fn table(p: &ShParams) -> Vec<f32> {
    let mut planes: Vec<f32> = (0..3 * SAMPLES).map(|i| direction(i % SAMPLES)[(i / SAMPLES) as usize]).collect();
    planes.extend((0..SAMPLES).map(|_| 1.0));
    let len = 4 * super::basis::rows(p).plane as usize;
    run(&super::basis::sh_basis::KERNEL, &[words(&[*p]), words(&planes), alloc::vec![0; len]])
}
fn assert_expansions(name: &str, order: u32, got: &[f32]) {
    let layout = ShLayout::new(ELEMENTS, order);
    for element in [0, 1, 37, 63, 64, 69] {
        for channel in 0..3 {
            let truth = expansion(element, channel);
            for k in 0..layout.blocks * 4 {
                let expected = if (k as usize) < sh::count(order) { truth[k as usize] } else { 0.0 };
                let value = got[layout.coef(channel, k, element)];
                assert!(
                    (value - expected).abs() < 2e-4,
                    "{name} order {order}, {element} {channel} {k}: {value} {expected}"
                );
            }
        }
    }
}

#[test]
fn table_holds_the_basis_functions() {
    for order in 0..=9 {
        let p = params(order);
        let table = table(&p);
        for s in [0, 17, SAMPLES - 1] {
            let y = sh::basis::<f32, 100>(direction(s));
            for k in 0..ShLayout::new(1, order).blocks * 4 {
                let expected = if (k as usize) < sh::count(order) { y[k as usize] } else { 0.0 };
                let got = table[super::basis::table_index(k, s, &p)];
                assert!((got - expected).abs() < 2e-6, "order {order}, {k}: {got} {expected}");
            }
        }
    }
}

#[test]
fn projections_are_the_plain_sums_for_every_order() {
    let light = radiance_samples();
    let rays = samples(|_, sample, axis| direction(sample)[axis as usize]);
    for order in 0..=9 {
        let (p, out) = (params(order), alloc::vec![0; ShLayout::new(ELEMENTS, order).len()]);
        let shared = [words(&[p]), words(&table(&p)), words(&light), out.clone()];
        assert_expansions("shared", order, &run(&super::project::sh_project::KERNEL, &shared));
        let own = [words(&[p]), words(&rays), words(&light), out];
        assert_expansions("own", order, &run(&super::project_rays::sh_project_rays::KERNEL, &own));
    }
}

#[test]
fn filtered_coefficients_give_the_irradiance() {
    let light = radiance_samples();
    for order in 0..=9 {
        let (mut p, layout) = (params(order), ShLayout::new(ELEMENTS, order));
        let out = alloc::vec![0; layout.len()];
        let coefs =
            run(&super::project::sh_project::KERNEL, &[words(&[p]), words(&table(&p)), words(&light), out.clone()]);
        let window = sh::factors(|l| sh::hanning_window(l, 10.0));
        let filter = ShFilterParams::new(ELEMENTS, order, &window);
        let filtered = run(&super::filter::sh_filter::KERNEL, &[words(&[filter]), words(&coefs), out]);
        let n = layout.padded_elements();
        let normals: Vec<f32> =
            (0..3 * n).map(|i| spherical_fibonacci(i % n + 5, n + 9).to_array()[(i / n) as usize]).collect();
        p.weight = 1.0;
        let irradiance = run(
            &super::irradiance::sh_irradiance::KERNEL,
            &[words(&[p]), words(&filtered), words(&normals), alloc::vec![0; 3 * n as usize]],
        );
        for element in [0, 40, 69] {
            let normal = spherical_fibonacci(element + 5, n + 9).to_array();
            for channel in 0..3 {
                let truth = expansion(element, channel);
                let kept: [f32; 100] = core::array::from_fn(|k| if k < sh::count(order) { truth[k] } else { 0.0 });
                let expected = sh::irradiance(&sh::convolve(&kept, &window), normal);
                let got = irradiance[(channel * n + element) as usize];
                assert!((got - expected).abs() < 2e-4 * expected.abs().max(1.0), "order {order}: {got} {expected}");
            }
        }
    }
}
