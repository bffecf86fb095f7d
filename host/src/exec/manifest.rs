//! Reads `manifest.json`: what a program must know to run the compiled kernels, without Rust and without this crate's
//! executors. Free of any graphics library.
//!
//! ```
//! let manifest = interreflect::exec::manifest::Manifest::embedded()?;
//! for kernel in &manifest.kernels {
//!     println!("{}: {} bindings", kernel.entry, kernel.bindings.len());
//! }
//! # Ok::<(), interreflect::exec::manifest::ManifestError>(())
//! ```

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Version of the file's format that this reader knows.
pub const FORMAT: u32 = 1;

/// Why a manifest cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ManifestError {
    /// The file cannot be read.
    #[error("cannot read {path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// The system's words.
        source: std::io::Error,
    },
    /// The text is no manifest.
    #[error("{path} is not a kernel manifest: {source}")]
    Json {
        /// The file.
        path: PathBuf,
        /// The parser's words, with line and column.
        source: serde_json::Error,
    },
    /// Another version of the format.
    #[error("{path} has format {got}; this program reads format {FORMAT}")]
    Format {
        /// The file.
        path: PathBuf,
        /// Its format.
        got: u32,
    },
    /// No kernel of that name.
    #[error("no compiled kernel `{entry}`; there are: {known}")]
    NoKernel {
        /// What was asked for.
        entry: String,
        /// What there is.
        known: String,
    },
    /// A file that should hold SPIR-V does not.
    #[error("{path} is not SPIR-V")]
    NotSpirv {
        /// The file.
        path: PathBuf,
    },
}

/// The compiled kernels of one build.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Manifest {
    /// Version of this format: [`FORMAT`].
    pub format: u32,
    /// SHA-256 over `sources` and `crates`.
    pub source_sha256: String,
    /// What compiled them.
    pub compilers: Compilers,
    /// Workgroups along x before a dispatch folds into y (see [`Manifest::workgroups`]).
    pub fold_width: u32,
    /// Every entry point, sorted by name.
    pub kernels: Vec<KernelEntry>,
    /// Layout of every record that a binding holds, by name.
    pub records: BTreeMap<String, RecordLayout>,
    /// SHA-256 of every source file (with `\n` line ends), by path from the workspace root.
    pub sources: BTreeMap<String, String>,
    /// Version of every crate whose code ends up in kernels or which writes the compiled files.
    pub crates: BTreeMap<String, String>,
    /// Where the files lie; none when embedded.
    #[serde(skip)]
    pub directory: Option<PathBuf>,
}

/// Versions of the compilers.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Compilers {
    /// `rustc -V` of the rust-gpu toolchain.
    pub rustc: String,
    /// Version of rust-gpu (spirv-builder, spirv-std and the code generator).
    pub rust_gpu: String,
    /// SPIR-V target.
    pub target: String,
    /// Version of naga, which writes the WGSL.
    pub naga: String,
}

/// One entry point.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct KernelEntry {
    /// Entry point.
    pub entry: String,
    /// `plain`, `lanes` or `scatter`.
    pub form: String,
    /// Invocations per workgroup in x, y, z.
    pub workgroup: [u32; 3],
    /// Planes of the written binding: its element `i` of plane `p` is element `p · plane length + i` (0 for scatter).
    pub planes: u32,
    /// File of the SPIR-V, beside the manifest.
    pub spirv: String,
    /// SHA-256 of that file.
    pub spirv_sha256: String,
    /// File of the WGSL, beside the manifest.
    pub wgsl: String,
    /// SHA-256 of that file.
    pub wgsl_sha256: String,
    /// Bindings of descriptor set (bind group) 0.
    pub bindings: Vec<BindingEntry>,
}

/// One binding.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct BindingEntry {
    /// Binding number.
    pub binding: u32,
    /// Name in the declaration.
    pub name: String,
    /// How it is used.
    pub access: AccessKind,
    /// Bytes from one element to the next (the record's size, for a uniform).
    pub stride_bytes: u32,
    /// Name of the element's type in [`Manifest::records`].
    pub record: String,
}

/// How a kernel uses a binding.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AccessKind {
    /// Uniform buffer of one record.
    Uniform,
    /// Read-only storage buffer.
    Read,
    /// Storage buffer that is written (and, for a device, read).
    Write,
    /// Storage buffer of `u32` words changed by atomics: clear it before the first dispatch.
    Atomic,
}

/// Layout of a record.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct RecordLayout {
    /// Size in bytes.
    pub size_bytes: u32,
    /// Fields in order of offset.
    pub fields: Vec<FieldLayout>,
}

/// One field of a record.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct FieldLayout {
    /// Name in the Rust source; empty for a record that is one scalar or vector.
    pub name: String,
    /// Bytes from the start of the record.
    pub offset_bytes: u32,
    /// 32-bit words.
    pub words: u32,
    /// `f32`, `u32` or `i32`: what each word holds.
    pub word: String,
}

impl Manifest {
    /// Reads a `manifest.json`; the kernels' files are looked for beside it.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ManifestError> {
        let path = path.as_ref();
        let text = std::fs::read_to_string(path).map_err(|source| ManifestError::Io { path: path.into(), source })?;
        let mut manifest = Self::parse(path, &text)?;
        manifest.directory = Some(path.parent().unwrap_or(Path::new("")).into());
        Ok(manifest)
    }

    /// The manifest of the kernels that this program was built with.
    pub fn embedded() -> Result<Self, ManifestError> {
        Self::parse(Path::new("(embedded manifest)"), interreflect_kernels::compiled::MANIFEST)
    }

    fn parse(path: &Path, text: &str) -> Result<Self, ManifestError> {
        #[derive(Deserialize)]
        struct Version {
            format: u32,
        }
        let json = |source| ManifestError::Json { path: path.into(), source };
        // The version first: another format may lack other fields too.
        let Version { format } = serde_json::from_str(text).map_err(json)?;
        if format != FORMAT {
            return Err(ManifestError::Format { path: path.into(), got: format });
        }
        serde_json::from_str(text).map_err(json)
    }

    /// The entry of a kernel.
    pub fn kernel(&self, entry: &str) -> Result<&KernelEntry, ManifestError> {
        self.kernels.iter().find(|kernel| kernel.entry == entry).ok_or_else(|| {
            let known: Vec<&str> = self.kernels.iter().map(|kernel| kernel.entry.as_str()).collect();
            ManifestError::NoKernel { entry: entry.into(), known: known.join(", ") }
        })
    }

    /// The SPIR-V words of a kernel: from its file, or the embedded ones.
    pub fn spirv(&self, entry: &str) -> Result<Vec<u32>, ManifestError> {
        let kernel = self.kernel(entry)?;
        let path = self.directory.clone().unwrap_or_default().join(&kernel.spirv);
        let words = match &self.directory {
            Some(_) => {
                let bytes = std::fs::read(&path).map_err(|source| ManifestError::Io { path: path.clone(), source })?;
                bytes.chunks(4).map(|b| b.try_into().map_or(0, u32::from_le_bytes)).collect()
            }
            None => interreflect_kernels::compiled::module(entry).map(|m| m.spirv_words()).unwrap_or_default(),
        };
        if words.first() == Some(&SPIRV_MAGIC) { Ok(words) } else { Err(ManifestError::NotSpirv { path }) }
    }

    /// Workgroups in x, y, z that cover a number of invocations of a kernel.
    pub fn workgroups(&self, kernel: &KernelEntry, invocations: u32) -> [u32; 3] {
        let groups = invocations.div_ceil(kernel.workgroup[0].max(1));
        if groups <= self.fold_width { [groups, 1, 1] } else { [self.fold_width, groups.div_ceil(self.fold_width), 1] }
    }
}

/// First word of a SPIR-V module (SPIR-V specification §2.3).
const SPIRV_MAGIC: u32 = 0x0723_0203;
