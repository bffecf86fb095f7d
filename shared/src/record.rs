//! Layout description of plain-old-data records: what lies in which 32-bit word.

use bytemuck::Pod;
use glam::{IVec4, Mat4, UVec4, Vec4};

/// What one 32-bit word holds: decides how two words are compared (integers exactly, floats within a tolerance).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Word {
    /// IEEE-754 single precision.
    F32,
    /// Unsigned integer, bit pattern, or packed data.
    U32,
    /// Two's-complement integer.
    I32,
}

/// One field of a [`Record`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Field {
    /// Name in the Rust source; empty for a record that is a single scalar or vector.
    pub name: &'static str,
    /// Offset from the start of the record in bytes.
    pub offset_bytes: usize,
    /// Number of 32-bit words.
    pub word_count: usize,
    /// What each of the words holds.
    pub word: Word,
}

/// A type that may be a field of a [`Record`]: every word of it holds the same kind.
pub trait FieldType: Pod {
    /// What each word holds.
    const WORD: Word;
}
impl FieldType for f32 {
    const WORD: Word = Word::F32;
}
impl FieldType for u32 {
    const WORD: Word = Word::U32;
}
impl FieldType for i32 {
    const WORD: Word = Word::I32;
}
impl FieldType for Vec4 {
    const WORD: Word = Word::F32;
}
impl FieldType for Mat4 {
    const WORD: Word = Word::F32;
}
impl FieldType for UVec4 {
    const WORD: Word = Word::U32;
}
impl FieldType for IVec4 {
    const WORD: Word = Word::I32;
}
impl<T: FieldType, const N: usize> FieldType for [T; N]
where
    [T; N]: Pod,
{
    const WORD: Word = T::WORD;
}

/// A plain-old-data type that a kernel binds, with its layout.
pub trait Record: Pod {
    /// Name of the type.
    const NAME: &'static str;
    /// Fields in order of offset; together they cover every word.
    const FIELDS: &'static [Field];
}

macro_rules! scalar_record {
    ($($t:ty),*) => { $(
        impl Record for $t {
            const NAME: &'static str = stringify!($t);
            const FIELDS: &'static [Field] =
                &[Field { name: "", offset_bytes: 0, word_count: size_of::<$t>() / 4, word: <$t as FieldType>::WORD }];
        }
    )* };
}
scalar_record!(f32, u32, i32, Vec4, UVec4, IVec4);

/// Declares a `repr(C)` Pod struct with its [`Record`] description; `size` is asserted at compile time.
///
/// ```
/// interreflect_shared::record! {
///     /// A point light in a buffer.
///     pub struct Spot: 32 { /// Position (m) and radius (m).
///         pub position_radius: glam::Vec4, /// Radiant intensity (W/sr), unused.
///         pub intensity: glam::Vec4 }
/// }
/// use interreflect_shared::Record;
/// assert_eq!(Spot::FIELDS[1].offset_bytes, 16);
/// ```
#[macro_export]
macro_rules! record {
    ($(#[$meta:meta])* pub struct $name:ident: $size:literal { $($(#[$field_meta:meta])* pub $field:ident: $ty:ty),* $(,)? }) => {
        $(#[$meta])*
        #[repr(C)]
        #[derive(Clone, Copy, PartialEq, Debug, $crate::__private::Pod, $crate::__private::Zeroable)]
        #[bytemuck(crate = "::interreflect_shared::__private::bytemuck")]
        pub struct $name { $($(#[$field_meta])* pub $field: $ty),* }
        const _: () = assert!(size_of::<$name>() == $size, "the declared size is not the real one");
        impl $crate::Record for $name {
            const NAME: &'static str = stringify!($name);
            const FIELDS: &'static [$crate::Field] = &[$($crate::Field {
                name: stringify!($field),
                offset_bytes: core::mem::offset_of!($name, $field),
                word_count: size_of::<$ty>() / 4,
                word: <$ty as $crate::FieldType>::WORD,
            }),*];
        }
    };
}
