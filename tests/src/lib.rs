//! Test harness of Interreflect.

