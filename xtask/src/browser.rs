//! Sees to a browser: the tests of the pages need Chromium.

use crate::{vulkan, workspace};

/// Programs that the tests know, in the order in which they look for them (`tests/src/browser.rs`).
const PROGRAMS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/// Whether there is a browser, after installing Debian's Chromium where there is none and it may be installed. Pages are
/// not what this project is for: without one their tests are ignored, not failed.
pub fn ensure() -> bool {
    let found = || PROGRAMS.iter().any(|name| workspace::on_path(name).is_some());
    if !found() && vulkan::may_install() {
        println!("no browser: installing chromium");
        if let Err(error) = vulkan::install(&["chromium"]) {
            eprintln!("warning: chromium: {error:#}");
        }
    }
    if !found() {
        eprintln!("warning: no Chromium: the tests of the pages are ignored");
    }
    found()
}
