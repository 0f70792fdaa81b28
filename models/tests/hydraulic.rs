//! Level `hydraulic`: the stiff luffing cylinder against an independent code.
#[path = "common/crane.rs"]
mod crane;
use lemnis_models::solver::rodas::{Run, Tolerance};
use lemnis_models::solver::System;

#[test]
fn probe() {
    let mut c = crane::hydraulic::<8>(None);
    let y0 = c.resting(65_f64.to_radians(), 20e5).unwrap();
    println!("{y0:?}");
    let (_, j) = c.jacobian(&y0).unwrap();
    for r in &j { println!("{r:?}"); }
    c.command = 0.5;
    for rel in [1e-4, 1e-6, 1e-8, 1e-10] {
        let tol = Tolerance { relative: rel, absolute: [1e-3*rel, 1e-3*rel, 1e6*rel,1e6*rel,1e6*rel,1e6*rel, 1e-1*rel, 1e1*rel] };
        let t = std::time::Instant::now();
        let mut run = Run::new(y0, 1e-4);
        for _ in 0..2500 { run.advance(&c, &tol, 1e-3, 1.0).unwrap(); }
        println!("{rel:e} {:?} {:?} {:?}", run.states(), run.count, t.elapsed());
    }
}
