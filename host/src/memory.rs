//! Memory in large pages.
//!
//! A ray that leaves a surface and a kernel that reads twenty planes at once touch more pages of 4 KiB than a processor
//! remembers the places of. Linux gives pages of 2 MiB to those who ask for them. A program asks for all its large blocks by
//!
//! ```
//! #[global_allocator]
//! static ALLOCATOR: interreflect::memory::LargePages = interreflect::memory::LargePages;
//! ```

use std::alloc::{GlobalAlloc, Layout, System};

/// Blocks from this size on, in bytes: half of one at least holds whole large pages, wherever it begins.
const LEAST_BYTES: usize = 4 << 20;

/// The system's allocator, which asks for large pages for blocks of 4 MiB and more where there are such (Linux).
pub struct LargePages;

#[expect(unsafe_code, reason = "an allocator")]
// SAFETY: every block is the system's own; `advise` changes neither its contents nor its place.
unsafe impl GlobalAlloc for LargePages {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are the system's conditions.
        advised(unsafe { System.alloc(layout) }, layout.size())
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
        advised(unsafe { System.alloc_zeroed(layout) }, layout.size())
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(block, layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as above.
        advised(unsafe { System.realloc(block, layout, size) }, size)
    }
}

/// Asks for large pages for what lies whole within a block; without them nothing is lost but time.
#[inline]
fn advised(block: *mut u8, size: usize) -> *mut u8 {
    if size >= LEAST_BYTES && !block.is_null() {
        advise(block, size);
    }
    block
}

#[cfg(target_os = "linux")]
#[cold]
#[expect(unsafe_code, reason = "a system call")]
fn advise(block: *mut u8, size: usize) {
    // The most that a page has on the processors that Linux runs on.
    const PAGE: usize = 64 << 10;
    let skipped = block.addr().next_multiple_of(PAGE) - block.addr();
    let bytes = (size - skipped) / PAGE * PAGE;
    // SAFETY: whole pages inside a block that the system just gave; advice changes nothing in them.
    unsafe { libc::madvise(block.add(skipped).cast(), bytes, libc::MADV_HUGEPAGE) };
}

#[cfg(not(target_os = "linux"))]
fn advise(_block: *mut u8, _size: usize) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_keep_what_they_hold_as_they_grow() {
        let mut layout = Layout::from_size_align(64, 64).unwrap();
        #[expect(unsafe_code, reason = "calls an allocator")]
        // SAFETY: one block, of the layout that it has at every call, touched within its size.
        unsafe {
            let mut block = LargePages.alloc_zeroed(layout);
            for size in [1 << 12, LEAST_BYTES - 1, LEAST_BYTES + 12_345, 40 << 20, LEAST_BYTES] {
                let kept = layout.size().min(size);
                block.add(kept - 1).write((size % 251) as u8);
                block = LargePages.realloc(block, layout, size);
                layout = Layout::from_size_align(size, 64).unwrap();
                assert_eq!(block.addr() % 64, 0);
                assert_eq!((block.read(), block.add(kept - 1).read()), (0, (size % 251) as u8));
            }
            LargePages.dealloc(block, layout);
            let layout = Layout::from_size_align(32 << 20, 64).unwrap();
            let block = LargePages.alloc_zeroed(layout);
            assert!((0..layout.size()).step_by(4096).all(|i| block.add(i).read() == 0));
            LargePages.dealloc(block, layout);
        }
    }
}
