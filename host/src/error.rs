//! The program's errors and the exit code of each.

use crate::exec::ExecError;
use crate::image_io::ImageError;
use crate::methods::MethodError;
use crate::metrics::MetricsError;
use crate::reference::ReferenceError;
use crate::report::ReportError;
use crate::scene::SceneError;
use std::path::PathBuf;

/// Anything that ends a command early.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The scene cannot be had.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A kernel, buffer or adapter failed.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// A method failed or was given wrong settings.
    #[error(transparent)]
    Method(#[from] MethodError),
    /// The path tracer failed.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// A picture cannot be read or written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// Two pictures cannot be compared.
    #[error(transparent)]
    Metrics(#[from] MetricsError),
    /// A report cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The output folder cannot be made.
    #[error("cannot make the output folder {path}: {source}")]
    OutputFolder {
        /// Folder.
        path: PathBuf,
        /// The system's words.
        source: std::io::Error,
    },
    /// Standard output takes no more.
    #[error("cannot write to standard output: {source}")]
    Output {
        /// The system's words.
        source: std::io::Error,
    },
    /// No settings of any method keep the limits that were asked for.
    #[error("nothing fits: {0}")]
    NothingFits(String),
    /// A method panicked where that is an answer, as in `stress`.
    #[error("it panicked: {0}")]
    Panic(String),
    /// The command line asks for something that does not exist.
    #[error("{0}")]
    Usage(String),
}

impl Error {
    /// 2 where the command was used wrongly, 1 where it failed.
    pub fn exit_code(&self) -> u8 {
        match self {
            Error::Usage(_) => 2,
            Error::Scene(SceneError::Unknown { .. } | SceneError::Camera { .. }) => 2,
            Error::Method(
                MethodError::UnknownMethod { .. } | MethodError::UnknownSetting { .. } | MethodError::BadValue { .. },
            ) => 2,
            _ => 1,
        }
    }
}
