//! The declaration language: one `kernel!` or `scatter!` makes the device entry point, the CPU function, the
//! description that executors and reflection tests read, and the row of [`crate::ALL`].
//!
//! Three forms. **Plain**: a body returns the one element that its invocation owns. **Lanes** (`lanes mod`): a body
//! generic over [`crate::real::Real`] returns one value per output plane. **Scatter**: a body writes only through
//! [`AtomicWords`]. See `smoke.rs` for one of each.

use core::ops::Index;
use interreflect_shared::Field;
use spirv_std::arch::IndexUnchecked;

/// Workgroups along x before a dispatch folds into y: a device allows 65,535 in one dimension.
pub const FOLD_WIDTH: u32 = 32_768;

/// How a kernel uses a binding.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Access {
    /// Uniform buffer of one record.
    Uniform,
    /// Read-only storage buffer.
    Read,
    /// Storage buffer of which every invocation stores its own element (in every plane).
    Write,
    /// Storage buffer of `u32` words that any invocation changes by order-independent atomics.
    Atomic,
}

/// One binding of a kernel, in descriptor set 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Binding {
    /// Binding number.
    pub index: u32,
    /// Name in the declaration.
    pub name: &'static str,
    /// How it is used.
    pub access: Access,
    /// Name of the element type.
    pub record: &'static str,
    /// Size of one element in bytes.
    pub stride_bytes: usize,
    /// Layout of one element.
    pub fields: &'static [Field],
}

impl Binding {
    /// A binding whose elements are `T`.
    pub const fn of<T: interreflect_shared::Record>(index: u32, name: &'static str, access: Access) -> Self {
        Self { index, name, access, record: T::NAME, stride_bytes: size_of::<T>(), fields: T::FIELDS }
    }
}

/// Everything an executor must know to run a kernel's SPIR-V; free of any graphics library's types.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct KernelDesc {
    /// Entry point and name of the compiled file.
    pub name: &'static str,
    /// Invocations per workgroup.
    pub workgroup_size: u32,
    /// Bindings in the order of the declaration: uniform, reads, writes.
    pub bindings: &'static [Binding],
}

impl KernelDesc {
    /// Workgroups in x and y for a number of invocations.
    pub const fn workgroups(&self, invocations: u32) -> [u32; 2] {
        let groups = invocations.div_ceil(self.workgroup_size);
        if groups <= FOLD_WIDTH { [groups, 1] } else { [FOLD_WIDTH, groups.div_ceil(FOLD_WIDTH)] }
    }
}

/// Index of an invocation in a folded dispatch.
#[inline(always)]
pub fn invocation(x: u32, y: u32, workgroup_size: u32) -> u32 {
    x + y * (FOLD_WIDTH * workgroup_size)
}

/// Where a kernel's invocations store: `count` rows of `len` elements each, row `r` at `first + r·pitch`, in every
/// plane of `plane` elements. Halo cells are elements that no row covers; they keep what they held.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rows {
    /// Rows.
    pub count: u32,
    /// Elements (invocations) of a row.
    pub len: u32,
    /// Elements from the start of one row to the start of the next.
    pub pitch: u32,
    /// Element that the first row starts at.
    pub first: u32,
    /// Elements of a plane of the output.
    pub plane: u32,
}

impl Rows {
    /// Every element of an output without planes: rows of one.
    #[inline(always)]
    pub fn all(count: u32) -> Self {
        Self { count, len: 1, pitch: 1, first: 0, plane: count }
    }
    /// `count` neighbouring elements from `first` on, in an output without planes.
    #[inline(always)]
    pub fn range(first: u32, count: u32) -> Self {
        Self { count, len: 1, pitch: 1, first, plane: first + count }
    }
    /// Invocations.
    #[inline(always)]
    pub fn invocations(&self) -> u32 {
        self.count * self.len
    }
    /// The element that an invocation owns.
    #[inline(always)]
    pub fn at(&self, invocation: u32) -> At {
        let row = invocation / self.len;
        self.cell(row, invocation - row * self.len)
    }
    /// The element at a row and a place in it.
    #[inline(always)]
    pub fn cell(&self, row: u32, x: u32) -> At {
        At { row, x, i: (self.first + row * self.pitch + x) as usize }
    }
}

/// One element of [`Rows`]; for lanes, the first of several neighbours in one row.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct At {
    /// Row.
    pub row: u32,
    /// Place in the row.
    pub x: u32,
    /// Index in the output plane.
    pub i: usize,
}

/// Asks a processor to bring element `i` of a slice into its cache; beyond the end, on a device, or where there is no such
/// instruction, nothing happens. Processors fetch ahead by themselves, but not beyond a page.
#[inline(always)]
#[allow(unsafe_code)]
pub fn prefetch<T>(slice: &[T], i: usize) {
    #[cfg(target_arch = "x86_64")]
    {
        use core::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: a prefetch reads nothing and faults nowhere; the address is computed without leaving its provenance.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(slice.as_ptr().wrapping_add(i).cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (slice, i);
}

/// Element `i` of a buffer, or of a table in a uniform buffer. Kernels never index out of bounds: the CPU checks that at
/// every access, on the same inputs. A device would pay for the check at every access too (a comparison and a branch, which
/// also keep a compiler from gathering accesses), so there it is left to the adapter: graphics interfaces' robust buffer
/// access, which wgpu always asks for.
#[inline(always)]
#[cfg_attr(target_arch = "spirv", allow(unsafe_code))]
pub fn fetch<T, B: ?Sized + IndexUnchecked<T> + Index<usize, Output = T>>(buffer: &B, i: usize) -> &T {
    #[cfg(target_arch = "spirv")]
    // SAFETY: the index lies inside, or the adapter keeps the access inside.
    unsafe {
        buffer.index_unchecked(i)
    }
    #[cfg(not(target_arch = "spirv"))]
    &buffer[i]
}

/// Element `i` of a buffer where there is one, otherwise `none`; for conditions that vary from element to element without a
/// pattern. A device branches; a processor, which would foresee half of these branches, always reads something.
#[inline(always)]
pub fn fetch_if<T: Copy>(is_there: bool, buffer: &[T], i: usize, none: T) -> T {
    #[cfg(target_arch = "spirv")]
    return if is_there { *fetch(buffer, i) } else { none };
    #[cfg(not(target_arch = "spirv"))]
    {
        let value = *fetch(buffer, if is_there { i } else { 0 });
        if is_there { value } else { none }
    }
}

/// Stores the element that an invocation owns: as [`fetch`], without a check of its own on a device.
#[cfg(target_arch = "spirv")]
#[inline(always)]
#[allow(unsafe_code)]
pub fn store(buffer: &mut [f32], i: usize, value: f32) {
    // SAFETY: hosts check that the rows fit the buffer before they dispatch; adapters keep the access inside.
    unsafe { *buffer.index_unchecked_mut(i) = value }
}

/// Words that many invocations change at once, in any order, with the same result.
pub trait AtomicWords {
    /// Adds to a word (wrapping) and returns what it was; do not let a result depend on what it was.
    fn add(&mut self, i: u32, value: u32) -> u32;
    /// Raises a word to a value if it is lower.
    fn max(&mut self, i: u32, value: u32);
    /// Sets bits of a word.
    fn or(&mut self, i: u32, bits: u32);
}

/// The device's side of [`AtomicWords`]: a storage buffer.
#[cfg(target_arch = "spirv")]
pub struct DeviceWords<'a>(pub &'a mut [u32]);

#[cfg(target_arch = "spirv")]
const QUEUE: u32 = spirv_std::memory::Scope::QueueFamily as u32;
#[cfg(target_arch = "spirv")]
const RELAXED: u32 = spirv_std::memory::Semantics::NONE.bits();

#[cfg(target_arch = "spirv")]
#[allow(unsafe_code)] // SAFETY: the word is in a storage buffer, and the index is checked like every other index.
impl AtomicWords for DeviceWords<'_> {
    #[inline(always)]
    fn add(&mut self, i: u32, value: u32) -> u32 {
        unsafe { spirv_std::arch::atomic_i_add::<u32, QUEUE, RELAXED>(&mut self.0[i as usize], value) }
    }
    #[inline(always)]
    fn max(&mut self, i: u32, value: u32) {
        unsafe { spirv_std::arch::atomic_u_max::<u32, QUEUE, RELAXED>(&mut self.0[i as usize], value) };
    }
    #[inline(always)]
    fn or(&mut self, i: u32, bits: u32) {
        unsafe { spirv_std::arch::atomic_or::<u32, QUEUE, RELAXED>(&mut self.0[i as usize], bits) };
    }
}

#[cfg(not(target_arch = "spirv"))]
pub use host::*;

#[cfg(not(target_arch = "spirv"))]
mod host {
    use super::{AtomicWords, KernelDesc, Rows};
    use alloc::vec::Vec;
    use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
    use interreflect_shared::Record;

    /// Instructions that CPU code is compiled for.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    pub enum Vectors {
        /// x86-64-v4: registers of 512 bits.
        Avx512,
        /// x86-64-v3: registers of 256 bits, multiply-add, counts of bits.
        Avx2,
        /// What every processor of the compiler's target has.
        Baseline,
    }

    /// What this processor has.
    #[inline]
    pub fn vectors() -> Vectors {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        {
            macro_rules! has {
                ($($name:tt)*) => { true $(&& std::is_x86_feature_detected!($name))* };
            }
            if has!("avx2" "fma" "popcnt" "lzcnt" "bmi1" "bmi2") {
                return if has!("avx512f" "avx512vl" "avx512bw" "avx512dq") { Vectors::Avx512 } else { Vectors::Avx2 };
            }
        }
        Vectors::Baseline
    }

    /// The CPU's side of [`AtomicWords`].
    pub struct HostWords<'a>(pub &'a [AtomicU32]);
    impl AtomicWords for HostWords<'_> {
        #[inline(always)]
        fn add(&mut self, i: u32, value: u32) -> u32 {
            self.0[i as usize].fetch_add(value, Relaxed)
        }
        #[inline(always)]
        fn max(&mut self, i: u32, value: u32) {
            // Most calls of a maximum change nothing; a load does not take the cache line away from other threads.
            if self.0[i as usize].load(Relaxed) < value {
                self.0[i as usize].fetch_max(value, Relaxed);
            }
        }
        #[inline(always)]
        fn or(&mut self, i: u32, bits: u32) {
            if self.0[i as usize].load(Relaxed) & bits != bits {
                self.0[i as usize].fetch_or(bits, Relaxed);
            }
        }
    }

    /// How far two executors' results may lie apart.
    #[derive(Clone, Copy, PartialEq, Debug)]
    pub enum Tolerance {
        /// Same bits.
        Exact,
        /// `|a − b| ≤ rel·max(|a|, |b|) + abs`; integers still exactly.
        RelAbs(f32, f32),
        /// Words are fixed-point sums of what were floats: at most this many units apart, as two's complement. Floats
        /// exactly.
        FixedPoint(u32),
    }
    impl Tolerance {
        /// Whether two integer words are close enough.
        pub fn accepts_words(self, a: u32, b: u32) -> bool {
            match self {
                Tolerance::FixedPoint(units) => (a.wrapping_sub(b) as i32).unsigned_abs() <= units,
                Tolerance::Exact | Tolerance::RelAbs(..) => a == b,
            }
        }
        /// Whether two floats are close enough. NaN is close to nothing, infinity to itself alone.
        pub fn accepts(self, a: f32, b: f32) -> bool {
            match self {
                Tolerance::Exact | Tolerance::FixedPoint(_) => a.to_bits() == b.to_bits() && !a.is_nan(),
                Tolerance::RelAbs(rel, abs) => {
                    a == b || ((a - b).is_finite() && (a - b).abs() <= rel * a.abs().max(b.abs()) + abs)
                }
            }
        }
    }

    /// Which form of declaration a kernel has.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    pub enum Form {
        /// One element per invocation.
        Plain,
        /// Lane-generic body over planes.
        Lanes,
        /// Order-independent atomics.
        Scatter,
    }

    /// One piece of a kernel's work for the CPU: rows `first_row ..` as many as the output slices hold.
    pub struct Piece<'a> {
        /// First row (plain, lanes) or first invocation (scatter).
        pub first_row: u32,
        /// Rows or invocations.
        pub row_count: u32,
        /// The uniform record.
        pub uniform: &'a [u32],
        /// Read bindings in the order of the declaration, each whole.
        pub reads: &'a [&'a [u32]],
        /// For every plane of the written binding the words that the piece's rows cover.
        pub planes: &'a mut [&'a mut [u32]],
        /// Atomic bindings in the order of the declaration, each whole.
        pub atomics: &'a [&'a [AtomicU32]],
    }

    /// See [`Kernel::operations`].
    pub type CountOperations = fn(uniform: &[u32], reads: &[&[u32]]) -> (u64, u64);

    /// A row of the kernel table.
    pub struct Kernel {
        /// What an executor needs for the device.
        pub desc: KernelDesc,
        /// Form of the declaration.
        pub form: Form,
        /// Planes of the written binding (1 unless lanes; 0 for scatter).
        pub plane_count: usize,
        /// Rows to run, from the uniform record and the number of elements of the written binding.
        pub rows: fn(uniform: &[u32], out_count: u32) -> Rows,
        /// Runs one piece on the CPU.
        pub cpu: fn(Piece<'_>),
        /// The same one element at a time, as a device does it, where `cpu` takes several: must give the same bits.
        pub scalar: Option<fn(Piece<'_>)>,
        /// Floating-point operations and elements of a sample, from the uniform record and the read bindings: what the
        /// arithmetic of a lane-generic body costs. Other forms do not count.
        pub operations: Option<CountOperations>,
        /// A valid input of a requested size and kind.
        pub case: fn(&mut CaseInput) -> Case,
        /// How far executors may lie apart.
        pub tolerance: Tolerance,
        /// Why this far.
        pub tolerance_reason: &'static str,
    }

    /// Buffers of a test case, one per binding in the order of the declaration.
    #[derive(Clone, Debug, Default)]
    pub struct Case {
        /// Words of each binding; written bindings hold what was there before.
        pub buffers: Vec<Vec<u32>>,
    }
    impl Case {
        /// Adds the uniform record.
        pub fn uniform<T: Record>(self, value: &T) -> Self {
            self.read(core::slice::from_ref(value))
        }
        /// Adds a read binding.
        pub fn read<T: Record>(mut self, values: &[T]) -> Self {
            let mut words = alloc::vec![0u32; size_of_val(values) / 4];
            bytemuck::cast_slice_mut::<u32, u8>(&mut words).copy_from_slice(bytemuck::cast_slice(values));
            self.buffers.push(words);
            self
        }
        /// Adds a written or atomic binding of `count` elements, all zero.
        pub fn zeroed<T: Record>(mut self, count: usize) -> Self {
            self.buffers.push(alloc::vec![0; count * size_of::<T>() / 4]);
            self
        }
    }

    /// Character of the numbers in a test case.
    #[derive(Clone, Copy, PartialEq, Eq, Debug)]
    pub enum Flavour {
        /// Numbers in (−1, 1).
        Ordinary,
        /// All zero.
        Zero,
        /// Denormals and the smallest normal numbers.
        Tiny,
        /// Magnitudes up to 1e15: squares still finite.
        Huge,
    }

    /// What a case function is asked for, and its source of numbers.
    pub struct CaseInput {
        /// Elements (invocations) wanted.
        pub count: usize,
        /// Character of the numbers.
        pub flavour: Flavour,
        state: u32,
    }
    impl CaseInput {
        /// A request; the same arguments give the same case.
        pub fn new(seed: u32, count: usize, flavour: Flavour) -> Self {
            Self { count, flavour, state: seed.wrapping_mul(0x9E37_79B9) ^ 0x85EB_CA6B }
        }
        /// Whether to make a case as a real scene does, to be timed: small ones try everything that is allowed.
        pub fn is_large(&self) -> bool {
            self.count >= 1 << 12
        }
        /// The next 32 bits (PCG hash of a counter; Jarzynski & Olano 2020).
        pub fn bits(&mut self) -> u32 {
            self.state = self.state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            let word = ((self.state >> ((self.state >> 28) + 4)) ^ self.state).wrapping_mul(277_803_737);
            (word >> 22) ^ word
        }
        /// Uniform in [0, 1), whatever the flavour.
        pub fn unit(&mut self) -> f32 {
            (self.bits() >> 8) as f32 / 16_777_216.0
        }
        /// A number of the requested flavour.
        pub fn float(&mut self) -> f32 {
            let x = self.unit() * 2.0 - 1.0;
            match self.flavour {
                Flavour::Ordinary => x,
                Flavour::Zero => 0.0,
                Flavour::Tiny => x * f32::MIN_POSITIVE * 2.0,
                Flavour::Huge => x * 1e15,
            }
        }
        /// `count` numbers of the requested flavour.
        pub fn floats(&mut self, count: usize) -> Vec<f32> {
            (0..count).map(|_| self.float()).collect()
        }
        /// A unit vector, whatever the flavour.
        pub fn direction(&mut self) -> glam::Vec3 {
            loop {
                let v = glam::Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0;
                if (0.01..1.0).contains(&v.length_squared()) {
                    return v / v.length_squared().sqrt();
                }
            }
        }
    }
}

/// Declares a gather kernel (plain, or generic over lanes). Grammar and meaning: module doc and `smoke.rs`.
macro_rules! kernel {
    ($(#[$doc:meta])* mod $name:ident = $body:path; entry $entry:literal threads($wg:literal);
     uniform $pb:literal $p:ident: $P:ty;
     $(read $ib:literal $i:ident: $I:ty;)*
     write $ob:literal $o:ident: $O:ty;
     $(over $rows:path;)?
     case $case:path; tolerance $tol:expr, $why:literal;) => {
        $(#[$doc])*
        pub mod $name {
            use super::*;
            #[allow(unused_imports)]
            use $crate::kernel::{Access, Binding, KernelDesc, Rows};

            /// Name, workgroup and bindings.
            pub const DESC: KernelDesc = KernelDesc { name: $entry, workgroup_size: $wg, bindings: &[
                Binding::of::<$P>($pb, stringify!($p), Access::Uniform),
                $(Binding::of::<$I>($ib, stringify!($i), Access::Read),)*
                Binding::of::<$O>($ob, stringify!($o), Access::Write),
            ] };

            #[inline(always)]
            #[allow(unused_variables)]
            fn rows($p: &$P, out_count: u32) -> Rows {
                #[allow(unused_mut, unused_assignments)]
                let mut rows = Rows::all(out_count);
                $(rows = $rows($p);)?
                rows
            }

            /// Device entry point.
            #[cfg(target_arch = "spirv")]
            #[spirv_std::spirv(compute(threads($wg), entry_point_name = $entry))]
            pub fn entry(
                #[spirv(global_invocation_id)] gid: spirv_std::glam::UVec3,
                #[spirv(uniform, descriptor_set = 0, binding = $pb)] $p: &$P,
                $(#[spirv(storage_buffer, descriptor_set = 0, binding = $ib)] $i: &[$I],)*
                #[spirv(storage_buffer, descriptor_set = 0, binding = $ob)] $o: &mut [$O],
            ) {
                let rows = rows($p, $o.len() as u32);
                let id = $crate::kernel::invocation(gid.x, gid.y, $wg);
                if id < rows.invocations() {
                    $o[rows.at(id).i] = $body(id, $p, $($i,)*);
                }
            }

            /// Every invocation on this thread, over whole buffers.
            #[cfg(not(target_arch = "spirv"))]
            pub fn cpu($p: &$P, $($i: &[$I],)* $o: &mut [$O]) {
                let rows = rows($p, $o.len() as u32);
                piece(&rows, 0, rows.count, $p, $($i,)* &mut $o[rows.first as usize..]);
            }

            #[cfg(not(target_arch = "spirv"))]
            #[inline(always)]
            fn piece_body(rows: &Rows, first_row: u32, row_count: u32, $p: &$P, $($i: &[$I],)* $o: &mut [$O]) {
                // Rows without a gap are one long row.
                let (runs, len) =
                    if rows.pitch == rows.len { (1, row_count * rows.len) } else { (row_count, rows.len) };
                for run in 0..runs {
                    let at = (run * rows.pitch) as usize;
                    let first_id = (first_row + run) * rows.len;
                    for (x, out) in $o[at..at + len as usize].iter_mut().enumerate() {
                        *out = $body(first_id + x as u32, $p, $($i,)*);
                    }
                }
            }
            $crate::kernel::widest_vectors!(piece = piece_body,
                (rows: &Rows, first_row: u32, row_count: u32, $p: &$P, $($i: &[$I],)* $o: &mut [$O]));

            /// The row of the kernel table.
            #[cfg(not(target_arch = "spirv"))]
            pub const KERNEL: $crate::kernel::Kernel = $crate::kernel::Kernel {
                desc: DESC,
                form: $crate::kernel::Form::Plain,
                plane_count: 1,
                rows: |uniform, out_count| rows(&bytemuck::cast_slice::<u32, $P>(uniform)[0], out_count),
                cpu: |job| {
                    let &[$($i,)*] = job.reads else { unreachable!("{}: wrong number of read bindings", $entry) };
                    let [$o] = job.planes else { unreachable!("{}: a plain kernel has one plane", $entry) };
                    let $p = &bytemuck::cast_slice::<u32, $P>(job.uniform)[0];
                    let $o = bytemuck::cast_slice_mut::<u32, $O>($o);
                    let mut rows = rows($p, 0);
                    // Without `over` the rows are single elements.
                    if rows.count == 0 { rows = Rows::all(job.row_count); }
                    piece(&rows, job.first_row, job.row_count, $p, $(bytemuck::cast_slice::<u32, $I>($i),)* $o);
                },
                scalar: None,
                operations: None,
                case: $case,
                tolerance: $tol,
                tolerance_reason: $why,
            };
        }
    };
    ($(#[$doc:meta])* lanes mod $name:ident = $body:path; entry $entry:literal threads($wg:literal);
     uniform $pb:literal $p:ident: $P:ty;
     $(read $ib:literal $i:ident: $I:ty;)*
     write $ob:literal $o:ident: f32 x $planes:literal;
     over $rows:path;
     case $case:path; tolerance $tol:expr, $why:literal;) => {
        $(#[$doc])*
        pub mod $name {
            use super::*;
            #[allow(unused_imports)]
            use $crate::kernel::{Access, Binding, KernelDesc, Rows};
            #[allow(unused_imports)]
            use $crate::real::Real;

            /// Name, workgroup and bindings.
            pub const DESC: KernelDesc = KernelDesc { name: $entry, workgroup_size: $wg, bindings: &[
                Binding::of::<$P>($pb, stringify!($p), Access::Uniform),
                $(Binding::of::<$I>($ib, stringify!($i), Access::Read),)*
                Binding::of::<f32>($ob, stringify!($o), Access::Write),
            ] };
            /// Planes of the output.
            pub const PLANES: usize = $planes;
            const _: () = assert!($planes <= 24, "the device's entry point stores 24 planes at most");

            /// Device entry point: the body with `f32`.
            #[cfg(target_arch = "spirv")]
            #[spirv_std::spirv(compute(threads($wg), entry_point_name = $entry))]
            pub fn entry(
                #[spirv(global_invocation_id)] gid: spirv_std::glam::UVec3,
                #[spirv(uniform, descriptor_set = 0, binding = $pb)] $p: &$P,
                $(#[spirv(storage_buffer, descriptor_set = 0, binding = $ib)] $i: &[$I],)*
                #[spirv(storage_buffer, descriptor_set = 0, binding = $ob)] $o: &mut [f32],
            ) {
                let rows: Rows = $rows($p);
                let id = $crate::kernel::invocation(gid.x, gid.y, $wg);
                if id < rows.invocations() {
                    let at = rows.at(id);
                    let values: [f32; $planes] = $body(at, $p, $($i,)*);
                    // Constant indices: an array that is indexed at run time lives in memory.
                    $crate::unroll!(PLANE in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23 => {
                        if PLANE < $planes {
                            const VALUE: usize = if PLANE < $planes { PLANE } else { 0 };
                            $crate::kernel::store(&mut *$o, PLANE * rows.plane as usize + at.i, values[VALUE]);
                        }
                    });
                }
            }

            /// Every row on this thread; `planes` from element 0 of each plane on.
            #[cfg(not(target_arch = "spirv"))]
            pub fn cpu($p: &$P, $($i: &[$I],)* planes: &mut [&mut [f32]; $planes]) {
                let rows: Rows = $rows($p);
                let mut cut: alloc::vec::Vec<&mut [f32]> =
                    planes.iter_mut().map(|plane| &mut plane[rows.first as usize..]).collect();
                piece(&rows, 0, rows.count, $p, $($i,)* &mut cut);
            }

            #[cfg(not(target_arch = "spirv"))]
            #[inline(always)]
            fn piece_body<R: Real>(rows: &Rows, first_row: u32, row_count: u32, $p: &$P, $($i: &[$I],)* planes: &mut [&mut [f32]]) {
                let len = rows.len as usize;
                let planes: &mut [&mut [f32]; $planes] = planes.try_into().expect("as many planes as the kernel writes");
                for row in 0..row_count {
                    let start = (row * rows.pitch) as usize;
                    let mut x = 0;
                    while x + R::LANES <= len {
                        let values: [R; $planes] = $body(rows.cell(first_row + row, x as u32), $p, $($i,)*);
                        for plane in 0..$planes { values[plane].store(planes[plane], start + x); }
                        x += R::LANES;
                        // The last lanes of a row overlap what is done: the same bits again, and no scalar rest.
                        if x < len && len - x < R::LANES { x = len - R::LANES; }
                        if x == len { break; }
                    }
                    while x < len {
                        let values: [f32; $planes] = $body(rows.cell(first_row + row, x as u32), $p, $($i,)*);
                        for plane in 0..$planes { planes[plane][start + x] = values[plane]; }
                        x += 1;
                    }
                }
            }
            $crate::kernel::widest_vectors!(piece = piece_body over lanes,
                (rows: &Rows, first_row: u32, row_count: u32, $p: &$P, $($i: &[$I],)* planes: &mut [&mut [f32]]));

            /// What [`piece`] must agree with: the device's body, one element at a time.
            #[cfg(not(target_arch = "spirv"))]
            fn scalar_piece(rows: &Rows, first_row: u32, row_count: u32, $p: &$P, $($i: &[$I],)* planes: &mut [&mut [f32]]) {
                for row in 0..row_count {
                    for x in 0..rows.len {
                        let values: [f32; $planes] = $body(rows.cell(first_row + row, x), $p, $($i,)*);
                        for plane in 0..$planes { planes[plane][(row * rows.pitch + x) as usize] = values[plane]; }
                    }
                }
            }

            #[cfg(not(target_arch = "spirv"))]
            fn run(
                job: $crate::kernel::Piece<'_>,
                piece: fn(&Rows, u32, u32, &$P, $(&[$I],)* &mut [&mut [f32]]),
            ) {
                let &[$($i,)*] = job.reads else { unreachable!("{}: wrong number of read bindings", $entry) };
                let $p = &bytemuck::cast_slice::<u32, $P>(job.uniform)[0];
                let mut planes: alloc::vec::Vec<&mut [f32]> =
                    job.planes.iter_mut().map(|plane| bytemuck::cast_slice_mut::<u32, f32>(plane)).collect();
                piece(&$rows($p), job.first_row, job.row_count, $p, $(bytemuck::cast_slice::<u32, $I>($i),)* &mut planes);
            }

            /// The row of the kernel table.
            #[cfg(not(target_arch = "spirv"))]
            pub const KERNEL: $crate::kernel::Kernel = $crate::kernel::Kernel {
                desc: DESC,
                form: $crate::kernel::Form::Lanes,
                plane_count: $planes,
                rows: |uniform, _| $rows(&bytemuck::cast_slice::<u32, $P>(uniform)[0]),
                cpu: |job| run(job, piece),
                scalar: Some(|job| run(job, scalar_piece)),
                operations: Some(|uniform, reads| {
                    let &[$($i,)*] = reads else { unreachable!("{}: wrong number of read bindings", $entry) };
                    let $p = &bytemuck::cast_slice::<u32, $P>(uniform)[0];
                    $crate::real::count_operations(&$rows($p), |at| {
                        let _: [$crate::real::Counted; $planes] =
                            $body(at, $p, $(bytemuck::cast_slice::<u32, $I>($i),)*);
                    })
                }),
                case: $case,
                tolerance: $tol,
                tolerance_reason: $why,
            };
        }
    };
}

/// Declares a scatter kernel: `items` gives the number of invocations from the parameters; writes go through atomics.
macro_rules! scatter {
    ($(#[$doc:meta])* mod $name:ident = $body:path; entry $entry:literal threads($wg:literal);
     uniform $pb:literal $p:ident: $P:ty; items $items:path;
     $(read $ib:literal $i:ident: $I:ty;)*
     $(atomic $ab:literal $a:ident;)+
     case $case:path; tolerance $tol:expr, $why:literal;) => {
        $(#[$doc])*
        pub mod $name {
            use super::*;
            #[allow(unused_imports)]
            use $crate::kernel::{Access, Binding, KernelDesc, Rows};

            /// Name, workgroup and bindings.
            pub const DESC: KernelDesc = KernelDesc { name: $entry, workgroup_size: $wg, bindings: &[
                Binding::of::<$P>($pb, stringify!($p), Access::Uniform),
                $(Binding::of::<$I>($ib, stringify!($i), Access::Read),)*
                $(Binding::of::<u32>($ab, stringify!($a), Access::Atomic),)+
            ] };

            /// Device entry point.
            #[cfg(target_arch = "spirv")]
            #[spirv_std::spirv(compute(threads($wg), entry_point_name = $entry))]
            pub fn entry(
                #[spirv(global_invocation_id)] gid: spirv_std::glam::UVec3,
                #[spirv(uniform, descriptor_set = 0, binding = $pb)] $p: &$P,
                $(#[spirv(storage_buffer, descriptor_set = 0, binding = $ib)] $i: &[$I],)*
                $(#[spirv(storage_buffer, descriptor_set = 0, binding = $ab)] $a: &mut [u32],)+
            ) {
                let id = $crate::kernel::invocation(gid.x, gid.y, $wg);
                if id < $items($p) {
                    $body(id, $p, $($i,)* $(&mut $crate::kernel::DeviceWords($a),)+);
                }
            }

            #[cfg(not(target_arch = "spirv"))]
            #[inline(always)]
            fn piece_body(first: u32, count: u32, $p: &$P, $($i: &[$I],)* $($a: &[core::sync::atomic::AtomicU32],)+) {
                for id in first..first + count {
                    $body(id, $p, $($i,)* $(&mut $crate::kernel::HostWords($a),)+);
                }
            }
            $crate::kernel::widest_vectors!(piece = piece_body,
                (first: u32, count: u32, $p: &$P, $($i: &[$I],)* $($a: &[core::sync::atomic::AtomicU32],)+));

            /// Every invocation on this thread.
            #[cfg(not(target_arch = "spirv"))]
            pub fn cpu($p: &$P, $($i: &[$I],)* $($a: &[core::sync::atomic::AtomicU32],)+) {
                piece(0, $items($p), $p, $($i,)* $($a,)+);
            }

            /// The row of the kernel table.
            #[cfg(not(target_arch = "spirv"))]
            pub const KERNEL: $crate::kernel::Kernel = $crate::kernel::Kernel {
                desc: DESC,
                form: $crate::kernel::Form::Scatter,
                plane_count: 0,
                rows: |uniform, _| Rows::all($items(&bytemuck::cast_slice::<u32, $P>(uniform)[0])),
                cpu: |job| {
                    let &[$($i,)*] = job.reads else { unreachable!("{}: wrong number of read bindings", $entry) };
                    let &[$($a,)+] = job.atomics else { unreachable!("{}: wrong number of atomic bindings", $entry) };
                    let $p = &bytemuck::cast_slice::<u32, $P>(job.uniform)[0];
                    piece(job.first_row, job.row_count, $p, $(bytemuck::cast_slice::<u32, $I>($i),)* $($a,)+);
                },
                scalar: None,
                operations: None,
                case: $case,
                tolerance: $tol,
                tolerance_reason: $why,
            };
        }
    };
}

/// Compiles a function again for the wider vector units of x86 and picks at run time; `over lanes` also hands it the
/// register as its type parameter. Results do not change: Rust never contracts or reorders float operations by itself.
/// Only what is inlined is compiled so: bodies, and what they call most, are `#[inline(always)]` (without it `floor` and
/// `count_ones` are function calls and bit tricks, and kernels that trace, march or count take 1.1 to 1.5 times as long).
macro_rules! widest_vectors {
    ($name:ident = $inner:ident over lanes, $args:tt) => {
        $crate::kernel::widest_vectors!(@pick $name = ($inner::<$crate::real::x86::Avx512>)
            ($inner::<$crate::real::x86::Avx2>) ($inner::<$crate::real::Lanes<{ $crate::real::WIDTH }>>), $args);
    };
    ($name:ident = $inner:ident, $args:tt) => {
        $crate::kernel::widest_vectors!(@pick $name = ($inner) ($inner) ($inner), $args);
    };
    (@pick $name:ident = ($wide:expr) ($middle:expr) ($any:expr), ($($arg:ident: $ty:ty),* $(,)?)) => {
        #[cfg(not(target_arch = "spirv"))]
        #[allow(unsafe_code)]
        fn $name($($arg: $ty),*) {
            #[cfg(all(feature = "std", target_arch = "x86_64"))]
            {
                use $crate::kernel::{Vectors, vectors};
                #[target_feature(enable = "avx512f,avx512vl,avx512bw,avx512dq,avx2,fma,popcnt,lzcnt,bmi1,bmi2")]
                fn avx512($($arg: $ty),*) { $wide($($arg),*) }
                #[target_feature(enable = "avx2,fma,popcnt,lzcnt,bmi1,bmi2")]
                fn avx2($($arg: $ty),*) { $middle($($arg),*) }
                match vectors() {
                    // SAFETY: the processor has these instructions.
                    Vectors::Avx512 => return unsafe { avx512($($arg),*) },
                    // SAFETY: likewise.
                    Vectors::Avx2 => return unsafe { avx2($($arg),*) },
                    Vectors::Baseline => {}
                }
            }
            $any($($arg),*)
        }
    };
}
pub(crate) use widest_vectors;
