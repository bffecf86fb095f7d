//! Reading and writing pictures: linear EXR, PNG; files appear whole or not at all.
