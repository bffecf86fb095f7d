//! The pages in a real browser: they load without an error, every picture shows, every table sorts by every column both
//! ways, and nothing sticks out of a window as wide as a phone. `INTERREFLECT_SCREENSHOTS=DIR` keeps pictures of them.

use interreflect_tests::browser;
use libtest_mimic::{Arguments, Failed, Trial};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, OnceLock};

/// Widths and heights of windows: a desktop and a phone.
const WINDOWS: [(&str, u32, u32); 2] = [("desktop", 1280, 1700), ("phone", 390, 1700)];
/// Smallest text that a person reads on a phone.
const LEAST_TEXT_PX: f64 = 10.0;

/// A page: its name, the command that makes it, and what it must hold.
struct Page {
    name: &'static str,
    args: &'static [&'static str],
    least_pictures: u64,
    least_tables: u64,
}

const PAGES: &[Page] = &[
    Page {
        name: "compare",
        args: &[
            "compare",
            "cornell-box",
            "--methods",
            "direct,ambient,vct",
            "--set",
            "vct.resolution=32",
            "--spp",
            "64",
            "--size",
            "64x48",
        ],
        least_pictures: 10,
        least_tables: 1,
    },
    Page {
        name: "chart",
        args: &[
            "chart",
            "cornell-box",
            "furnace",
            "--methods",
            "direct,ambient,vct",
            "--spp",
            "64",
            "--size",
            "64x48",
            "--repeats",
            "2",
            "--rung-timeout",
            "30",
        ],
        least_pictures: 16,
        least_tables: 2,
    },
    Page {
        name: "fit",
        args: &["fit", "cornell-box", "--methods", "vct,lpv", "--error", "0.5", "--size", "64x48"],
        least_pictures: 2,
        least_tables: 2,
    },
    Page {
        name: "stress",
        args: &["stress", "--methods", "vct", "--rung", "0", "--families", "leak,furnace,rotation,lights,degenerate"],
        least_pictures: 5,
        least_tables: 1,
    },
];

fn main() {
    let missing = browser::find().is_none();
    let ignored = missing && !browser::required();
    let mut trials = Vec::new();
    for page in PAGES {
        for (window, width, height) in WINDOWS {
            let name = format!("{} on a {window}", page.name);
            let trial = Trial::test(name, move || check(page, window, width, height));
            trials.push(trial.with_ignored_flag(ignored));
        }
    }
    trials.push(Trial::test("the probe sees what is wrong", the_probe_sees_what_is_wrong).with_ignored_flag(ignored));
    if ignored {
        eprintln!("no Chromium: the tests of the pages are ignored (set {}=1 to fail them)", browser::REQUIRE_BROWSER);
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// Names of the pages that were made, and how that ended.
type Made = Vec<(String, Result<(), String>)>;

/// The page's folder, made once for all windows.
fn made(page: &Page) -> Result<&'static Path, Failed> {
    static FOLDER: OnceLock<tempfile::TempDir> = OnceLock::new();
    static MADE: OnceLock<Mutex<Made>> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| tempfile::tempdir().expect("a folder")).path();
    let mut made = MADE.get_or_init(Default::default).lock().unwrap_or_else(|e| e.into_inner());
    if !made.iter().any(|(name, _)| name == page.name) {
        let out = folder.join(page.name);
        let mut command = Command::new(env!("CARGO_BIN_EXE_interreflect-under-test"));
        command.args(page.args).args(["--backend", "cpu"]);
        let output = command.arg("--cache").arg(folder.join("cache")).arg("--out").arg(out).output()?;
        let result = match output.status.success() {
            true => Ok(()),
            false => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
        };
        made.push((page.name.into(), result));
    }
    let (_, result) = made.iter().find(|(name, _)| name == page.name).expect("made above");
    result.clone().map_err(Failed::from)?;
    Ok(Box::leak(folder.join(page.name).into_boxed_path()))
}

fn check(page: &Page, window: &str, width: u32, height: u32) -> Result<(), Failed> {
    let folder = made(page)?;
    let screenshot = std::env::var_os("INTERREFLECT_SCREENSHOTS")
        .map(|dir| PathBuf::from(dir).join(format!("{}-{window}.png", page.name)));
    let seen = browser::probe(&folder.join("index.html"), width, height, screenshot.as_deref())?;
    let mut wrong = Vec::new();
    let mut must = |right: bool, what: &str| {
        if !right {
            wrong.push(what.to_string());
        }
    };
    let empty = |key: &str| seen[key].as_array().is_some_and(Vec::is_empty);
    must(seen["width"] == width, "the window has its width");
    must(empty("errors"), "no errors");
    must(seen["pictures"].as_u64() >= Some(page.least_pictures), "all pictures are there");
    must(empty("broken"), "all pictures show");
    must(seen["tables"].as_u64() >= Some(page.least_tables), "all tables are there");
    must(empty("unsorted"), "all tables sort");
    must(seen["overflow_px"].as_f64() <= Some(0.0), "nothing sticks out");
    must(seen["text_px"].as_f64() >= Some(LEAST_TEXT_PX), "the text is large enough");
    must(seen["words"].as_u64() > Some(100), "there are words");
    if wrong.is_empty() { Ok(()) } else { Err(format!("not so: {}\n{seen:#}", wrong.join("; ")).into()) }
}

/// A page with one of every fault: the checks above can fail.
fn the_probe_sees_what_is_wrong() -> Result<(), Failed> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("index.html");
    std::fs::write(
        &path,
        "<!doctype html><html><head></head><body><p style=\"font-size:4px;width:900px\">small and wide</p>\
         <img src=\"data:image/png;base64,AAAA\" alt=\"no picture\"><table class=\"sortable\"><thead><tr><th><button>n</button></th>\
         </tr></thead><tbody><tr><td data-v=\"2\">2</td></tr><tr><td data-v=\"1\">1</td></tr></tbody></table>\
         <script>nothing.at.all()</script></body></html>",
    )?;
    let seen = browser::probe(&path, 390, 800, None)?;
    let full = |key: &str| seen[key].as_array().is_some_and(|v| !v.is_empty());
    let noticed = full("errors")
        && full("broken")
        && full("unsorted")
        && seen["overflow_px"].as_f64() > Some(0.0)
        && seen["text_px"].as_f64() < Some(LEAST_TEXT_PX);
    if noticed { Ok(()) } else { Err(format!("{seen:#}").into()) }
}
