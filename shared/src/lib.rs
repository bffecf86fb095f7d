//! Plain-old-data parameters and records that Interreflect's kernels and hosts share: one file per method family.
//!
//! Every struct is `repr(C)`, made of 32-bit words, padded by hand to 16-byte groups and described to the
//! tools by [`Record`], so that a manifest, a test or another renderer knows its layout without parsing Rust.
//! Build one with [`record!`]: the size is asserted at compile time.
#![cfg_attr(not(test), no_std)]

extern crate self as interreflect_shared;

pub mod cone;
pub mod lpv;
pub mod record;
pub mod scene;
pub mod sh;
pub mod smoke;
pub mod srp;
pub mod trace;
pub mod voxel;

pub use record::{Field, FieldType, Record, Word};

/// What [`record!`] needs from its dependencies; not for direct use.
#[doc(hidden)]
pub mod __private {
    pub use bytemuck::{self, Pod, Zeroable};
}
