//! The compiled kernels, embedded: SPIR-V and WGSL of every entry point, and the manifest that describes them.
//!
//! `cargo xtask kernels` writes the files in `kernels/compiled`; `cargo xtask kernels --check` tells whether they are
//! what today's source gives. One module per entry point: see [`MODULES`].

/// One entry point, compiled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Module {
    /// Entry point (`KernelDesc::name`).
    pub name: &'static str,
    /// SPIR-V 1.5 (Vulkan 1.2): little-endian words, not aligned.
    pub spirv: &'static [u8],
    /// The same entry point as WGSL, for hosts without SPIR-V (browsers).
    pub wgsl: &'static str,
}

impl Module {
    /// The SPIR-V as words, as graphics libraries take it.
    pub fn spirv_words(&self) -> alloc::vec::Vec<u32> {
        self.spirv.chunks_exact(4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
    }
}

/// Every compiled entry point, sorted by name.
pub const MODULES: &[Module] = include!(concat!(env!("OUT_DIR"), "/modules.rs"));

/// `manifest.json` as text; empty when no kernel has been compiled.
pub const MANIFEST: &str = include!(concat!(env!("OUT_DIR"), "/manifest.rs"));

/// The compiled module of an entry point; `None` when it has not been compiled.
pub fn module(name: &str) -> Option<&'static Module> {
    MODULES.binary_search_by(|module| module.name.cmp(name)).ok().map(|k| &MODULES[k])
}
