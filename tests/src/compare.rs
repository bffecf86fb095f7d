//! Outputs of two executors, word by word: integers exactly, floats within the kernel's tolerance.

use crate::failure::{Difference, Failure, Place};
use crate::run::POISON;
use interreflect_kernels::kernel::{Binding, Kernel, Tolerance};
use interreflect_shared::{Field, Word};

/// What one executor left in one written or atomic binding.
#[derive(Clone, PartialEq, Debug)]
pub struct Output {
    /// Who wrote it.
    pub executor: String,
    /// The binding.
    pub binding: Binding,
    /// Its words.
    pub words: Vec<u32>,
}

impl Output {
    /// The field that a word belongs to and its place in it.
    fn field(&self, word: usize) -> (&'static Field, usize) {
        let in_element = word % (self.binding.stride_bytes / 4);
        let last = self.binding.fields.iter().rev().find(|f| f.offset_bytes / 4 <= in_element);
        let field = last.unwrap_or(&self.binding.fields[0]);
        (field, in_element - field.offset_bytes / 4)
    }

    /// What a word holds.
    pub fn kind(&self, word: usize) -> Word {
        self.field(word).0.word
    }

    /// Where a word is, for messages.
    pub fn place(&self, word: usize) -> Place {
        let (field, word_in_field) = self.field(word);
        Place {
            executor: self.executor.clone(),
            binding: self.binding.name,
            element: word / (self.binding.stride_bytes / 4),
            field: field.name,
            word: word_in_field,
        }
    }

    fn text(&self, word: usize) -> String {
        let bits = self.words[word];
        match self.kind(word) {
            Word::F32 => format!("{:e} ({bits:#010x})", f32::from_bits(bits)),
            Word::U32 => format!("{bits} ({bits:#010x})"),
            Word::I32 => format!("{}", bits as i32),
        }
    }
}

/// How far two outputs may lie apart.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Allowed {
    /// The same bits: one machine, another number of threads or lanes.
    SameBits,
    /// What the kernel's declaration says of its floats: another device.
    Declared(Tolerance, &'static str),
}

impl Allowed {
    /// What a kernel's declaration says.
    pub fn declared(kernel: &Kernel) -> Self {
        Allowed::Declared(kernel.tolerance, kernel.tolerance_reason)
    }

    fn accepts(self, kind: Word, expected: u32, got: u32) -> bool {
        match (self, kind) {
            (Allowed::Declared(tolerance, _), Word::F32) => {
                tolerance.accepts(f32::from_bits(expected), f32::from_bits(got))
            }
            (Allowed::Declared(tolerance, _), Word::U32 | Word::I32) => tolerance.accepts_words(expected, got),
            (Allowed::SameBits, _) => expected == got,
        }
    }

    fn text(self, kind: Word) -> String {
        match (self, kind) {
            (Allowed::Declared(tolerance, reason), Word::F32)
            | (Allowed::Declared(tolerance @ Tolerance::FixedPoint(_), reason), _) => {
                format!("{tolerance:?}: {reason}")
            }
            _ => "must be equal".into(),
        }
    }
}

/// Compares all outputs of two executors. Gives the number of words compared.
///
/// # Errors
/// The first difference: [`Failure::Length`] or [`Failure::Differs`].
pub fn compare(expected: &[Output], got: &[Output], allowed: Allowed) -> Result<usize, Failure> {
    let mut compared = 0;
    for (a, b) in expected.iter().zip(got) {
        if a.words.len() != b.words.len() {
            return Err(Failure::Length {
                executor: b.executor.clone(),
                binding: b.binding.name,
                expected: a.words.len(),
                got: b.words.len(),
            });
        }
        for i in 0..a.words.len() {
            // What no invocation owns holds the pattern on both sides, as `run_case` has made sure: a NaN that is right.
            let untouched = a.words[i] == POISON[0] && b.words[i] == POISON[0];
            if !untouched && !allowed.accepts(a.kind(i), a.words[i], b.words[i]) {
                return Err(Failure::Differs(Box::new(Difference {
                    place: b.place(i),
                    expected: a.text(i),
                    got: b.text(i),
                    allowed: allowed.text(a.kind(i)),
                })));
            }
        }
        compared += a.words.len();
    }
    Ok(compared)
}
