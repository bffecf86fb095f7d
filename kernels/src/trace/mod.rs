//! Scene access of kernels: the BVH walk and the surface fetch.

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&crate::kernel::Kernel] = &[];
