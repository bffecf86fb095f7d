//! A kernel's case on one executor, and what must be true of its output alone.
//!
//! Every case runs twice over two different patterns in the written buffer. Then each word tells on its own what
//! became of it: owned by an invocation and the same both times (written); the pattern both times (untouched);
//! anything else is a fault.

use crate::compare::Output;
use crate::failure::Failure;
use interreflect::exec::{BufferId, ExecError, Executor, ExecutorExt};
use interreflect_kernels::kernel::{Access, Case, Kernel, Rows};
use interreflect_shared::Word;

/// Patterns of the written buffer: a NaN, and a number that no test expects.
pub const POISON: [u32; 2] = [0x7FC0_DEAD, 0xA5A5_5A5A];

/// Runs a case and checks its output. Written bindings come back as after the first pattern.
///
/// # Errors
/// Any [`Failure`] that one output shows by itself.
pub fn run_case(exec: &mut dyn Executor, kernel: &'static Kernel, case: &Case) -> Result<Vec<Output>, Failure> {
    let executor = exec.device().backend;
    let run = |exec: &mut dyn Executor, poison| {
        run_once(exec, kernel, case, poison)
            .map_err(|error| Failure::Exec { executor: executor.clone(), error: error.to_string() })
    };
    let first = run(exec, POISON[0])?;
    let second = run(exec, POISON[1])?;
    for (a, b) in first.iter().zip(&second) {
        let expected = bound_words(kernel, case, a);
        for output in [a, b] {
            if output.words.len() != expected {
                let (executor, binding, got) = (executor.clone(), a.binding.name, output.words.len());
                return Err(Failure::Length { executor, binding, expected, got });
            }
        }
        check_words(kernel, case, a, b)?;
    }
    Ok(first)
}

/// Words of the buffer that a case binds where an output was.
fn bound_words(kernel: &Kernel, case: &Case, output: &Output) -> usize {
    let k = kernel.desc.bindings.iter().position(|b| b.index == output.binding.index);
    k.map_or(0, |k| case.buffers[k].len())
}

fn run_once(
    exec: &mut dyn Executor,
    kernel: &'static Kernel,
    case: &Case,
    poison: u32,
) -> Result<Vec<Output>, ExecError> {
    let mark = exec.mark();
    let mut ids: Vec<BufferId> = Vec::new();
    for (binding, words) in kernel.desc.bindings.iter().zip(&case.buffers) {
        ids.push(match binding.access {
            Access::Write => exec.upload_slice(binding.name, &vec![poison; words.len()])?,
            _ => exec.upload_slice(binding.name, words)?,
        });
    }
    exec.run(kernel, &ids)?;
    let executor = exec.device().backend;
    let mut outputs = Vec::new();
    for (binding, &id) in kernel.desc.bindings.iter().zip(&ids) {
        if matches!(binding.access, Access::Write | Access::Atomic) {
            outputs.push(Output { executor: executor.clone(), binding: *binding, words: exec.read_slice(id)? });
        }
    }
    exec.free_since(mark);
    Ok(outputs)
}

fn check_words(kernel: &Kernel, case: &Case, a: &Output, b: &Output) -> Result<(), Failure> {
    let owned = owned_words(kernel, case, a);
    for i in 0..a.words.len() {
        let words = [a.words[i], b.words[i]];
        let fault = match (owned[i], words == POISON, words[0] == words[1]) {
            (true, true, _) => Failure::Unwritten(a.place(i)),
            (true, false, false) => Failure::DependsOnBefore(a.place(i)),
            (false, false, _) => Failure::Overwritten(a.place(i)),
            (true, false, true) if a.kind(i) == Word::F32 && f32::from_bits(words[0]).is_nan() => {
                Failure::NotANumber(a.place(i))
            }
            _ => continue,
        };
        return Err(fault);
    }
    Ok(())
}

/// Which words of an output the kernel's invocations own. In atomic bindings all: they hold the case's words before.
fn owned_words(kernel: &Kernel, case: &Case, output: &Output) -> Vec<bool> {
    if output.binding.access == Access::Atomic {
        return vec![true; output.words.len()];
    }
    let stride = output.binding.stride_bytes / 4;
    let rows = rows(kernel, case, output.words.len() / stride);
    let mut owned = vec![false; output.words.len()];
    for plane in 0..kernel.plane_count {
        for row in 0..rows.count {
            let start = plane * rows.plane as usize + rows.cell(row, 0).i;
            owned[start * stride..(start + rows.len as usize) * stride].fill(true);
        }
    }
    owned
}

fn rows(kernel: &Kernel, case: &Case, out_count: usize) -> Rows {
    let uniform = kernel.desc.bindings.iter().position(|b| b.access == Access::Uniform);
    let words = uniform.map_or(&[][..], |k| &case.buffers[k][..kernel.desc.bindings[k].stride_bytes / 4]);
    (kernel.rows)(words, out_count as u32)
}
