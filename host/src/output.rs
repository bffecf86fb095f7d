//! What the program says on standard output and standard error.
//!
//! `println!` panics where nobody reads any more (`interreflect methods | head -1`) or a disk is full. Here a reader who closed
//! the pipe has read enough, and any other failure is kept for [`finish`].

use crate::error::Error;
use std::fmt::Arguments;
use std::io::{ErrorKind, Write, stderr, stdout};
use std::sync::Mutex;

/// The first failure of standard output.
static FAILURE: Mutex<Option<std::io::Error>> = Mutex::new(None);

/// Prints a line on standard output.
macro_rules! say {
    ($($text:tt)*) => { $crate::output::line(format_args!($($text)*)) };
}

/// Prints a line on standard error: notes, warnings, news of long runs.
macro_rules! tell {
    ($($text:tt)*) => { $crate::output::aside(format_args!($($text)*)) };
}

/// What `say!` calls.
pub fn line(text: Arguments<'_>) {
    keep(writeln!(stdout(), "{text}"));
}

/// What `tell!` calls. There is nowhere left to report a failure of standard error.
pub fn aside(text: Arguments<'_>) {
    let _ = writeln!(stderr(), "{text}");
}

/// Writes out what is buffered.
///
/// # Errors
/// [`Error::Output`] where a line got lost, but for a reader who left.
pub fn finish() -> Result<(), Error> {
    keep(stdout().flush());
    let failure = FAILURE.lock().ok().and_then(|mut failure| failure.take());
    failure.map_or(Ok(()), |source| Err(Error::Output { source }))
}

fn keep(result: std::io::Result<()>) {
    if let Err(error) = result
        && error.kind() != ErrorKind::BrokenPipe
        && let Ok(mut failure) = FAILURE.lock()
    {
        failure.get_or_insert(error);
    }
}
