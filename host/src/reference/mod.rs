//! The truth: a path tracer that shares no kernel with what it judges.
