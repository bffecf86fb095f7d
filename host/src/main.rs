//! Interreflect on the command line.

use clap::Parser;
use interreflect::cli::{self, Cli};
use interreflect::output;
use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: interreflect::memory::LargePages = interreflect::memory::LargePages;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(refusal) => return refuse(&refusal),
    };
    let json = cli.json;
    match cli::run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            if json {
                print_error(&error.to_string());
            }
            output::aside(format_args!("error: {error}"));
            ExitCode::from(error.exit_code())
        }
    }
}

/// A command line that is none, or a question for help.
fn refuse(refusal: &clap::Error) -> ExitCode {
    if refusal.use_stderr() && std::env::args_os().any(|word| word == "--json") {
        print_error(refusal.render().to_string().trim_start_matches("error: ").trim_end());
    }
    // Nobody may be reading.
    let _ = refusal.print();
    ExitCode::from(u8::try_from(refusal.exit_code()).unwrap_or(2))
}

fn print_error(words: &str) {
    output::line(format_args!("{}", serde_json::json!({ "error": words })));
    // What is wrong already decides the exit code.
    let _ = output::finish();
}
