//! `stress`: where methods fail.

use super::args::StressArgs;
use super::{print_json, setup};
use crate::error::Error;
use crate::image_io::write_whole;
use crate::methods::{MethodRow, Settings};
use crate::reference;
use crate::report;
use crate::stress::{self, Atlas, Effort, Entry, FAMILIES, Family, Lab, State};

/// Runs the families on the methods and writes `stress.json`, `stress.txt` and `index.html`.
pub fn run(args: &StressArgs, as_json: bool) -> Result<(), Error> {
    let methods = super::chart::methods(&args.methods)?;
    let families = families(&args.families)?;
    let _folder = setup::output_folder(&args.out)?;
    let mut entries: Vec<Entry> = Vec::new();
    let mut device = None;
    for row in methods.into_iter().filter(|m| !m.control || args.methods != "all") {
        let exec = setup::executor(&args.device)?;
        device = Some(exec.device());
        let mut lab = Lab {
            row,
            settings: rung(row, args.rung)?,
            seed: args.seed,
            cache: args.cache.clone().unwrap_or_else(reference::default_dir),
            exec,
            effort: if args.quick { Effort::Ends } else { Effort::Full },
            not_finite: false,
            last: None,
        };
        entries.extend(stress::run(&mut lab, &families, &mut |entry| tell!("{}", line(entry))));
    }
    entries.sort_by_key(|e| FAMILIES.iter().position(|f| f.key == e.family));
    let device = device.ok_or_else(|| Error::Usage("--methods names no method".into()))?;
    let atlas = Atlas { entries, device: (&device).into(), version: report::version() };
    let table: String = atlas.entries.iter().map(|e| line(e) + "\n").collect();
    write_whole(&args.out.join("stress.json"), report::to_json(&atlas)?.as_bytes())?;
    write_whole(&args.out.join("stress.txt"), table.as_bytes())?;
    write_whole(&args.out.join("index.html"), stress::page(&atlas).as_bytes())?;
    if as_json {
        print_json(&atlas);
    } else {
        say!("{}", table.trim_end());
        say!("{}", args.out.join("index.html").display());
    }
    Ok(())
}

/// The settings of a rung; the last one of a shorter ladder.
fn rung(row: &MethodRow, rung: usize) -> Result<Settings, Error> {
    match row.ladder.get(rung).or(row.ladder.last()) {
        Some((_, changes)) => Ok(row.with(changes.iter().copied())?),
        None => Ok(row.defaults()),
    }
}

fn families(list: &str) -> Result<Vec<&'static Family>, Error> {
    if list.trim() == "all" {
        return Ok(FAMILIES.iter().collect());
    }
    let find = |name: &str| {
        FAMILIES.iter().find(|f| f.key == name).ok_or_else(|| {
            let known: Vec<&str> = FAMILIES.iter().map(|f| f.key).collect();
            Error::Usage(format!("there is no family `{name}` (there are: {})", known.join(", ")))
        })
    };
    list.split(',').map(|name| find(name.trim())).collect()
}

fn line(entry: &Entry) -> String {
    let mark = match entry.state {
        State::NotApplicable => "  -   ",
        State::Broken => "BROKEN",
        State::Measured if entry.samples.iter().all(|s| s.value <= entry.bound) => "holds ",
        State::Measured => "fails ",
    };
    let variant = if entry.variant.is_empty() { String::new() } else { format!(" ({})", entry.variant) };
    let numbers = Some(entry.numbers()).filter(|n| !n.is_empty()).map(|n| format!(" [{n}]")).unwrap_or_default();
    format!("{mark} {}{variant}: {}{numbers}", entry.family, entry.sentence)
}
