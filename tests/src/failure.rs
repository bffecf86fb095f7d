//! What a check can find wrong.

use std::fmt;

/// One 32-bit word of a kernel's output.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Place {
    /// Who wrote it: `cpu`, `gpu`, `gpu-passthrough`, …
    pub executor: String,
    /// Name of the binding.
    pub binding: &'static str,
    /// Index of the element in the binding.
    pub element: usize,
    /// Field of the element's record, empty for a scalar.
    pub field: &'static str,
    /// Word of the field.
    pub word: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}[{}]", self.executor, self.binding, self.element)?;
        if !self.field.is_empty() {
            write!(f, ".{}", self.field)?;
        }
        if self.word > 0 { write!(f, "[{}]", self.word) } else { Ok(()) }
    }
}

/// Where and how two outputs differ.
#[derive(Clone, PartialEq, Debug)]
pub struct Difference {
    /// Where, in the second output.
    pub place: Place,
    /// What the first output holds there.
    pub expected: String,
    /// What the second one holds.
    pub got: String,
    /// What is allowed.
    pub allowed: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {}, expected {} ({})", self.place, self.got, self.expected, self.allowed)
    }
}

/// Why a kernel's case failed. NaN, a short output, an empty table and a missing adapter are failures, never a pass.
#[derive(Clone, PartialEq, Debug)]
pub enum Failure {
    /// The executor returned an error.
    Exec {
        /// Which executor.
        executor: String,
        /// Its words.
        error: String,
    },
    /// An output does not have the length of the buffer that was bound.
    Length {
        /// Which executor.
        executor: String,
        /// Name of the binding.
        binding: &'static str,
        /// Words of the buffer.
        expected: usize,
        /// Words that came back.
        got: usize,
    },
    /// A float of an output is NaN.
    NotANumber(Place),
    /// An element that the kernel must write still holds the pattern from before.
    Unwritten(Place),
    /// An element that no invocation owns has changed.
    Overwritten(Place),
    /// What was written depends on what lay there before.
    DependsOnBefore(Place),
    /// Two outputs differ.
    Differs(Box<Difference>),
    /// The case covers nothing: no output word was compared at any size.
    NothingCompared,
    /// There is no kernel to test.
    EmptyTable,
    /// Two kernels have the same name.
    TwiceInTable(&'static str),
    /// No adapter, where one is required.
    NoAdapter(String),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Exec { executor, error } => write!(f, "{executor}: {error}"),
            Failure::Length { executor, binding, expected, got } => {
                write!(f, "{executor}: `{binding}` has {got} words, not {expected}")
            }
            Failure::NotANumber(place) => write!(f, "{place} is not a number"),
            Failure::Unwritten(place) => write!(f, "{place} was not written"),
            Failure::Overwritten(place) => write!(f, "{place} belongs to no invocation and was overwritten"),
            Failure::DependsOnBefore(place) => write!(f, "{place} depends on what the buffer held before"),
            Failure::Differs(difference) => difference.fmt(f),
            Failure::NothingCompared => write!(f, "the case has no output: nothing was compared"),
            Failure::EmptyTable => write!(f, "the kernel table is empty"),
            Failure::TwiceInTable(name) => write!(f, "kernel `{name}` is in the table twice"),
            Failure::NoAdapter(reason) => write!(f, "an adapter is required (INTERREFLECT_REQUIRE_GPU): {reason}"),
        }
    }
}

impl std::error::Error for Failure {}
