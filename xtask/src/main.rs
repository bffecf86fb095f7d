//! Development tasks of Interreflect.

fn main() {}
