//! Interreflect on the command line.

use clap::Parser;
use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: interreflect::memory::LargePages = interreflect::memory::LargePages;

fn main() -> ExitCode {
    let cli = interreflect::cli::Cli::parse();
    let json = cli.json;
    match interreflect::cli::run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            if json {
                println!("{}", serde_json::json!({ "error": error.to_string() }));
            }
            eprintln!("error: {error}");
            ExitCode::from(error.exit_code())
        }
    }
}
