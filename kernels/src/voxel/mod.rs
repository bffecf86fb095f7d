//! (see the method's documentation)

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&crate::kernel::Kernel] = &[];
