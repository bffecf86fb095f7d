//! Exclusive prefix sums without workgroup memory: sums of 16 neighbours level by level, then offsets back down.
//!
//! One invocation of `scan_sum` adds up to 16 elements of one level; one of `scan_prefix` adds the elements before its own
//! in its group to its group's offset. n elements take ⌈log₁₆ n⌉ passes each way and no synchronisation inside a pass.
//! Sums stop at `u32::MAX` instead of wrapping, which the host reads as "too many".
//!
//! Pass before: whatever counts. Pass after: whatever compacts.

#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use interreflect_shared::voxel::{SCAN_RADIX, ScanParams};

#[inline(always)]
fn add(a: u32, b: u32) -> u32 {
    let sum = a.wrapping_add(b);
    if sum < a { u32::MAX } else { sum }
}

#[inline(always)]
fn element(p: &ScanParams, values: &[u32], i: u32) -> u32 {
    if i >= p.first && i < p.count { values[i as usize] } else { 0 }
}

/// Sum of the elements `16·i ..` of one level, as many as there are up to 16.
#[inline(always)]
pub fn sum(i: u32, p: &ScanParams, values: &[u32]) -> u32 {
    let mut total = 0;
    for k in i * SCAN_RADIX..(i + 1) * SCAN_RADIX {
        total = add(total, element(p, values, k));
    }
    total
}

/// Sum of all elements before element `i`: its group's offset (`parents`, one per 16 elements; of the topmost level one
/// zero) and the elements before it in the group.
pub fn prefix(i: u32, p: &ScanParams, values: &[u32], parents: &[u32]) -> u32 {
    let group = i / SCAN_RADIX;
    let mut total = parents[group as usize];
    for k in group * SCAN_RADIX..i {
        total = add(total, element(p, values, k));
    }
    total
}

#[cfg(not(target_arch = "spirv"))]
fn values(input: &mut CaseInput) -> (ScanParams, alloc::vec::Vec<u32>) {
    // Large values saturate now and then.
    let shift = if input.bits() & 7 == 0 { 2 } else { 20 };
    let values: alloc::vec::Vec<u32> = (0..input.count).map(|_| input.bits() >> shift).collect();
    let first = if input.bits() & 1 == 0 { 0 } else { input.count as u32 / 3 };
    (ScanParams { count: input.count as u32, first, _pad0: 0, _pad1: 0 }, values)
}

#[cfg(not(target_arch = "spirv"))]
fn sum_case(input: &mut CaseInput) -> Case {
    let (params, values) = values(input);
    Case::default().uniform(&params).read(&values).zeroed::<u32>(values.len().div_ceil(SCAN_RADIX as usize))
}

#[cfg(not(target_arch = "spirv"))]
fn prefix_case(input: &mut CaseInput) -> Case {
    let (params, values) = values(input);
    let parents: alloc::vec::Vec<u32> =
        (0..values.len().div_ceil(SCAN_RADIX as usize)).map(|_| input.bits() >> 4).collect();
    Case::default().uniform(&params).read(&values).read(&parents).zeroed::<u32>(values.len())
}

kernel! {
    /// Sums of 16 neighbours.
    mod scan_sum = super::sum; entry "scan_sum" threads(64);
    uniform 0 params: ScanParams;
    read 1 values: u32;
    write 2 out: u32;
    case super::sum_case; tolerance Tolerance::Exact, "integers";
}

kernel! {
    /// Sums of all elements before each, from the sums of their groups.
    mod scan_prefix = super::prefix; entry "scan_prefix" threads(64);
    uniform 0 params: ScanParams;
    read 1 values: u32;
    read 2 parents: u32;
    write 3 out: u32;
    case super::prefix_case; tolerance Tolerance::Exact, "integers";
}
