//! What the control points of degree 1000 take of memory. A program of its own: where time is measured, counting would be felt.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicBool, AtomicIsize, Ordering::Relaxed};

use casteljau::{Curve, Interval, Rational};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn main() {
    // Thousandths in no particular order.
    let coefficients = (0..=1000).map(|k| Rational::new(k * 379 % 2001 - 1000, 1000)).collect();
    let curve = Curve::new(vec![coefficients]).unwrap();
    let frame = Interval::new(Rational::new(-1, 3), Rational::new(7, 5)).unwrap();
    let (peak, held) = of(|| curve.segment(&frame).unwrap());
    println!(
        "\nMemory, control points of degree 1000: {:.2} MB at most during the call, {:.2} MB held by the result: {:.2} times.",
        peak as f64 / 1e6,
        held as f64 / 1e6,
        peak as f64 / held as f64
    );
}

static COUNTING: AtomicBool = AtomicBool::new(false);
static LIVE: AtomicIsize = AtomicIsize::new(0);
static PEAK: AtomicIsize = AtomicIsize::new(0);

struct Counting;

fn count(change: isize) {
    if COUNTING.load(Relaxed) {
        let live = LIVE.load(Relaxed) + change;
        LIVE.store(live, Relaxed);
        PEAK.store(PEAK.load(Relaxed).max(live), Relaxed);
    }
}

// SAFETY: every request goes to the system's allocator as it is.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        count(-(layout.size() as isize));
        unsafe { System.dealloc(block, layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(layout.size() as isize);
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size as isize - layout.size() as isize);
        unsafe { System.realloc(block, layout, size) }
    }
}

/// The most bytes live at any moment of the call, and those that its result still holds; both beyond what was live
/// before. (Only one thread may allocate meanwhile.)
fn of<T>(call: impl FnOnce() -> T) -> (usize, usize) {
    LIVE.store(0, Relaxed);
    PEAK.store(0, Relaxed);
    COUNTING.store(true, Relaxed);
    let result = call();
    COUNTING.store(false, Relaxed);
    let held = LIVE.load(Relaxed);
    drop(result);
    (PEAK.load(Relaxed) as usize, held.max(0) as usize)
}
