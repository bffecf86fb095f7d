//! Interreflect on the command line.

fn main() {}
