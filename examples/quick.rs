use casteljau::*;
use std::time::Instant;
fn main(){
 let q=|a,b|Rational::new(a,b);
 let mut seed=12345u64; let mut rnd=move||{seed=seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);(seed>>33) as i64};
 for n in [3usize,10,30,100,300,1000]{
  let c=Curve::new(vec![(0..=n).map(|_|q(rnd()%2001-1000,1000)).collect()]).unwrap();
  let f=Interval::new(q(-1,3),q(7,5)).unwrap();
  let reps= (2_000_000/(n*n)).max(1).min(200000);
  let mut best=f64::MAX; for _ in 0..5{ let t=Instant::now(); for _ in 0..reps{ std::hint::black_box(c.segment(std::hint::black_box(&f)).unwrap()); } best=best.min(t.elapsed().as_secs_f64()/reps as f64);}
  print!("n={n} points {:.3}us",best*1e6);
  if n<=100 {
  let args:Vec<Rational>=(0..n).map(|_|q(rnd()%255-127,rnd()%255+1)).collect();
  let mut best=f64::MAX; for _ in 0..5{ let t=Instant::now(); for _ in 0..reps{ std::hint::black_box(c.blossom(std::hint::black_box(&args)).unwrap()); } best=best.min(t.elapsed().as_secs_f64()/reps as f64);}
  print!(" polar {:.3}us",best*1e6);
  let s=Segment::new(3,(0..3*n+3).map(|_|q(rnd()%2001-1000,1000)).collect(),Interval::unit()).unwrap();
  let t3=q(1,3);
  let mut best=f64::MAX; for _ in 0..5{ let t=Instant::now(); for _ in 0..reps{ std::hint::black_box(s.split(std::hint::black_box(&t3)).unwrap()); } best=best.min(t.elapsed().as_secs_f64()/reps as f64);}
  print!(" split {:.3}us",best*1e6);
  }
  println!();
 }
}
