//! Test harness of Interreflect.
