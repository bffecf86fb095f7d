//! Every kernel of the table: CPU = SPIR-V as it is = SPIR-V through naga, and the same bits on the CPU whatever the
//! number of threads and lanes. Three tests for each kernel, named after it.

use interreflect::exec::{CpuExecutor, Executor, ExecutorExt, SpirvPath};
use interreflect_kernels::kernel::FOLD_WIDTH;
use interreflect_kernels::smoke;
use interreflect_shared::smoke::SmokeParams;
use interreflect_tests::{gpu, suite};
use libtest_mimic::{Arguments, Failed, Trial};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let kernels = match suite::kernels(interreflect_kernels::ALL) {
        Ok(kernels) => kernels,
        Err(failure) => {
            eprintln!("{failure}");
            return ExitCode::FAILURE;
        }
    };
    let mut trials = vec![Trial::test("folded_dispatch::cpu", || folded_dispatch(&mut CpuExecutor::new()))];
    for path in gpu::SPIRV_PATHS {
        let name = format!("folded_dispatch::{}", gpu::path_name(path));
        trials.push(suite::gpu_trial(name, path, move || folded_dispatch(&mut *gpu::lock(path)?)));
    }
    for kernel in kernels {
        let name = kernel.desc.name;
        trials.push(Trial::test(format!("{name}::cpu"), || suite::same_bits_on_cpu(kernel).map_err(Into::into)));
        for path in gpu::SPIRV_PATHS {
            let name = format!("{name}::{}", gpu::path_name(path));
            trials.push(suite::gpu_trial(name, path, move || on_gpu(path, kernel)));
        }
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

fn on_gpu(path: SpirvPath, kernel: &'static interreflect_kernels::kernel::Kernel) -> Result<(), Failed> {
    suite::same_as_cpu(&mut *gpu::lock(path)?, kernel).map_err(Into::into)
}

/// More workgroups than one dimension holds, and a last row of them that is not full.
fn folded_dispatch(exec: &mut dyn Executor) -> Result<(), Failed> {
    const ONE_DIMENSION: u32 = 65_535;
    let workgroup = smoke::smoke_fill::DESC.workgroup_size;
    for groups in [FOLD_WIDTH, FOLD_WIDTH + 1, ONE_DIMENSION + 2] {
        let count = groups * workgroup - 1;
        let params = SmokeParams { count, seed: groups, scale: 0.0, _pad: 0 };
        let mark = exec.mark();
        let uniform = exec.upload_one("params", &params)?;
        let out = exec.zeroed_slice::<u32>("out", count as usize)?;
        exec.run(&smoke::smoke_fill::KERNEL, &[uniform, out])?;
        let words = exec.read_slice::<u32>(out)?;
        exec.free_since(mark);
        let wrong = (0..count).find(|&i| words[i as usize] != smoke::fill(i, &params));
        if let Some(i) = wrong {
            return Err(format!("{groups} workgroups: word {i} is {:#x}", words[i as usize]).into());
        }
    }
    Ok(())
}
