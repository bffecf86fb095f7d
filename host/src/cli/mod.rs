//! The program: verbs, progress, exit codes. Everything it does is in the library; this only asks and prints.

mod animate;
mod args;
mod bake;
mod chart;
mod compare;
mod fit;
mod list;
mod progress;
mod reference;
mod render;
mod setup;
mod stress;

pub use args::{Cli, Verb};

use crate::error::Error;

/// Runs a command line.
///
/// # Errors
/// What the verb returns; [`Error::exit_code`] is the program's exit code.
pub fn run(cli: Cli) -> Result<(), Error> {
    crate::exec::start_threads(cli.threads.map_or(0, usize::from));
    let done = match cli.verb {
        Verb::Compare(args) => compare::run(&args, cli.json),
        Verb::Render(args) => render::run(&args, cli.json),
        Verb::Reference(args) => reference::run(&args, cli.json),
        Verb::Bake(args) => bake::run(&args, cli.json),
        Verb::Chart(args) => chart::run(&args, cli.threads, cli.json),
        Verb::Stress(args) => stress::run(&args, cli.json),
        Verb::Fit(args) => fit::run(&args, cli.json),
        Verb::Methods => list::methods(cli.json),
        Verb::Scenes => list::scenes(cli.json),
        Verb::Devices => list::devices(cli.json),
        Verb::Trial { folder } => crate::chart::trial::execute(&folder),
    };
    done.and(crate::output::finish())
}

/// Prints a value as JSON on standard output.
fn print_json(value: &impl serde::Serialize) {
    say!("{}", serde_json::to_string_pretty(value).expect("reports hold finite numbers and text keys"));
}
