//! The points where sides end, by number.

use std::borrow::Cow;
use std::collections::HashMap;

use num_bigint::BigInt;

use crate::exact::Rational;

/// The points at the ends of sides, numbered; those nearer than the snap have one number.
#[derive(Default)]
pub(super) struct Corners<'a> {
    numbers: HashMap<Cow<'a, [Rational]>, u32>,
}

impl<'a> Corners<'a> {
    /// The number of a point.
    pub(super) fn number(&mut self, point: Cow<'a, [Rational]>) -> u32 {
        let next = u32::try_from(self.numbers.len()).unwrap_or(u32::MAX);
        *self.numbers.entry(point).or_insert(next)
    }

    /// A new number for every number: the same for points in reach of each other.
    pub(super) fn snapped(&self, snap: &Rational) -> Vec<u32> {
        let mut leader: Vec<u32> = (0..self.numbers.len() as u32).collect();
        fn find(leader: &mut [u32], mut k: u32) -> u32 {
            while leader[k as usize] != k {
                leader[k as usize] = leader[leader[k as usize] as usize];
                k = leader[k as usize];
            }
            k
        }
        let mut cells: HashMap<Vec<BigInt>, Vec<(&[Rational], u32)>> = HashMap::new();
        let mut points: Vec<(&[Rational], u32)> = self.numbers.iter().map(|(point, &number)| (point.as_ref(), number)).collect();
        points.sort_unstable_by_key(|&(_, number)| number);
        for (point, number) in points {
            let cell: Vec<BigInt> = point.iter().map(|x| floor(&(x / snap))).collect();
            // All cells around, by counting in base three.
            for code in 0..3usize.pow(u32::try_from(cell.len()).unwrap_or(0).min(8)) {
                let mut code = code;
                let neighbour: Vec<BigInt> = cell
                    .iter()
                    .map(|index| {
                        let step = code % 3;
                        code /= 3;
                        index + BigInt::from(step as i64 - 1)
                    })
                    .collect();
                for (other, known) in cells.get(&neighbour).into_iter().flatten() {
                    if is_near(point, other, snap) {
                        let (a, b) = (find(&mut leader, number), find(&mut leader, *known));
                        leader[a.max(b) as usize] = a.min(b);
                    }
                }
            }
            let list = cells.entry(cell).or_default();
            // Points beside one in the same cell add nothing but work.
            if list.len() < 64 {
                list.push((point, number));
            }
        }
        (0..leader.len() as u32).map(|k| find(&mut leader, k)).collect()
    }
}

fn floor(number: &Rational) -> BigInt {
    use num_integer::Integer as _;
    number.numer().div_floor(&number.denom())
}

/// Whether two points are at most that far from each other.
pub(super) fn is_near(a: &[Rational], b: &[Rational], snap: &Rational) -> bool {
    let squared: Rational = a.iter().zip(b).map(|(x, y)| (x - y).pow(2)).sum();
    a.len() == b.len() && squared <= snap.pow(2)
}
