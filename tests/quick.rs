use casteljau::*;
use serde_json::Value as J;
fn rat(v:&J)->Rational{ match v { J::String(s)=>s.parse().unwrap(), J::Number(n)=>n.to_string().parse().unwrap(), _=>panic!() } }
fn list(v:&J)->Vec<Rational>{ v.as_array().unwrap().iter().map(rat).collect() }
fn lists(v:&J)->Vec<Vec<Rational>>{ v.as_array().unwrap().iter().map(list).collect() }
fn frame(v:&J)->Interval{ let f=list(v); Interval::new(f[0].clone(),f[1].clone()).unwrap() }
fn curve(v:&J)->Curve{ Curve::new(lists(&v["coeffs"])).unwrap() }
fn pts(s:&Segment)->Vec<Vec<Rational>>{ s.points().map(|p|p.to_vec()).collect() }
#[test] fn vectors(){
 let mut n=0;
 for f in ["textbook","general"]{
  let d:J=serde_json::from_str(&std::fs::read_to_string(format!("tests/vectors/{f}.json")).unwrap()).unwrap();
  for c in d["cases"].as_array().unwrap(){
   let (i,e)=(&c["input"],&c["expect"]);
   let id=c["id"].as_str().unwrap();
   let seg=||Segment::from_points(lists(&i["points"]), if i.get("frame").is_some(){frame(&i["frame"])}else{Interval::unit()}).unwrap();
   match c["op"].as_str().unwrap(){
    "curve.points"=>assert_eq!(pts(&curve(&i["curve"]).segment(&frame(&i["frame"])).unwrap()),lists(&e["points"]),"{id}"),
    "curve.equation"=>assert_eq!(seg().curve().unwrap(),curve(&e["curve"]),"{id}"),
    "curve.blossom"=>assert_eq!(curve(&i["curve"]).blossom(&list(&i["args"])).unwrap(),list(&e["value"]),"{id}"),
    "curve.blossom_homogeneous"=>{let a:Vec<Parameter>=lists(&i["args"]).into_iter().map(|p|Parameter::homogeneous(p[1].clone(),p[0].clone())).collect();
      assert_eq!(curve(&i["curve"]).blossom_homogeneous(&a).unwrap(),list(&e["value"]),"{id}");
      assert_eq!(curve(&i["curve"]).segment(&frame(&serde_json::json!(["2/3","-1"]))).unwrap().blossom_homogeneous(&a).unwrap(),list(&e["value"]),"{id}");}
    "curve.casteljau"=>{let s=seg().scheme(&rat(&i["t"])).unwrap();
      for (l,x) in s.layers().zip(e["layers"].as_array().unwrap()){assert_eq!(l.map(|p|p.to_vec()).collect::<Vec<_>>(),lists(x),"{id}")}
      assert_eq!(s.left().map(|p|p.to_vec()).collect::<Vec<_>>(),lists(&e["left"]),"{id}");
      assert_eq!(s.right().map(|p|p.to_vec()).collect::<Vec<_>>(),lists(&e["right"]),"{id}");
      if let Ok((l,r))=seg().split(&rat(&i["t"])){assert_eq!(pts(&l),lists(&e["left"]));assert_eq!(pts(&r),lists(&e["right"]));}}
    "curve.reframe"=>assert_eq!(pts(&seg().reframe(&frame(&i["new_frame"])).unwrap()),lists(&e["points"]),"{id}"),
    "curve.elevate"=>assert_eq!(pts(&seg().elevate(i["by"].as_u64().unwrap() as usize)),lists(&e["points"]),"{id}"),
    "curve.reduce"=>{let r=seg().reduce().unwrap();assert_eq!(pts(&r.segment),lists(&e["points"]),"{id}");assert_eq!(r.true_degree as u64,e["true_degree"].as_u64().unwrap());assert_eq!(J::Bool(r.zero),e["zero"]);}
    "curve.derivative"=>assert_eq!(curve(&i["curve"]).derivative(i["order"].as_u64().unwrap() as usize).value(&rat(&i["t"])),list(&e["value"]),"{id}"),
    _=>continue }
   n+=1;
  }}
  println!("{n}");
}
