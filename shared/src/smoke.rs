//! Parameters of the smallest kernels (`kernels/src/smoke.rs`).

crate::record! {
    /// Parameters of the smoke kernels.
    pub struct SmokeParams: 16 {
        /// Elements.
        pub count: u32,
        /// Mixed into every hash.
        pub seed: u32,
        /// The factor of `axpy`.
        pub scale: f32,
        /// Zero.
        pub _pad: u32,
    }
}
