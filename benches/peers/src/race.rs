//! Two implementations of one task, timed turn by turn in the same thread.

use std::array;

const ROUNDS: usize = 15;
const TURN: f64 = 0.02;

/// Seconds a call: the median of each implementation, and quartiles of the ratio of each round.
pub struct Outcome {
    pub medians: [f64; 2],
    pub ratio: [f64; 3],
}

pub fn race(mut contestants: [&mut dyn FnMut(); 2]) -> Outcome {
    let repetitions: [u32; 2] = array::from_fn(|who| enough(&mut contestants[who]));
    let rounds: [[f64; 2]; ROUNDS] = array::from_fn(|round| {
        let mut seconds = [0.0; 2];
        for who in if round % 2 == 0 { [0, 1] } else { [1, 0] } {
            seconds[who] = time(&mut contestants[who], repetitions[who]);
        }
        seconds
    });
    Outcome {
        medians: array::from_fn(|who| quartiles(rounds.map(|seconds| seconds[who]))[1]),
        ratio: quartiles(rounds.map(|[ours, theirs]| ours / theirs)),
    }
}

/// How many calls fill a turn. Finding out also warms up.
fn enough(call: &mut dyn FnMut()) -> u32 {
    let mut repetitions = 1;
    loop {
        let seconds = time(call, repetitions) * f64::from(repetitions);
        if seconds >= TURN / 2.0 {
            return (f64::from(repetitions) * TURN / seconds).ceil() as u32;
        }
        repetitions *= 2;
    }
}

fn time(call: &mut dyn FnMut(), repetitions: u32) -> f64 {
    let start = cpu_seconds();
    for _ in 0..repetitions {
        call();
    }
    (cpu_seconds() - start) / f64::from(repetitions)
}

/// The processor time of this thread: what other programs do meanwhile does not count.
fn cpu_seconds() -> f64 {
    let mut now = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: `now` is valid for writing.
    let status = unsafe { libc::clock_gettime(libc::CLOCK_THREAD_CPUTIME_ID, &mut now) };
    assert_eq!(status, 0, "no clock of thread processor time");
    now.tv_sec as f64 + now.tv_nsec as f64 * 1e-9
}

fn quartiles(mut values: [f64; ROUNDS]) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [values[ROUNDS / 4], values[ROUNDS / 2], values[ROUNDS - 1 - ROUNDS / 4]]
}
