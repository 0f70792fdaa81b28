//! What slews on a support in random scenes: bodies, load, slope, wind areas, cases.

use lemnis_models::supports::upper::symbols as s;

use crate::bodies::{list, row};
use crate::scene::Node;

/// So much weight at so great a size, the bodies and the load as many times that size from the axis as `far` says.
pub fn slewing(n: &mut Node, [size, weight, far]: [f64; 3]) {
    let bodies = n.draw.rng.usize(1..4);
    list(n, "upper", bodies, &mut |draw, _| {
        let (own, place) = (weight * draw.between(0.5, 1.0), far * size * draw.between(-0.1, 0.1));
        let high = size * draw.between(0.0, 0.5);
        row(draw, &[(&s::G_U, own), (&s::R_U, place), (&s::H_U, high)])
    });
    let (load, reach) = (n.draw.between(0.0, 0.1), n.draw.between(0.0, 0.5));
    n.set("Q", weight * load);
    n.set("R", far * size * reach);
    if let Some(mut slope) = n.child("slope") {
        let (gamma, high) = (slope.draw.between(0.0, 0.05), size * slope.draw.between(0.0, 1.0));
        slope.set("gamma", gamma);
        slope.set("h_Q", high);
    }
    let areas = n.draw.rng.usize(0..3);
    list(n, "areas", areas, &mut |draw, _| {
        let (area, height) = (size * size * draw.between(0.0, 1.0), size * draw.between(0.0, 1.0));
        row(draw, &[(&s::A_W, area), (&s::H_W, height)])
    });
    let cases = n.draw.rng.usize(1..4);
    list(n, "load_cases", cases, &mut |draw, _| {
        let (factor, to) = (draw.between(0.0, 1.5), draw.angle());
        let pressure = draw.between(0.0, 0.02) * weight / (size * size);
        row(draw, &[(&s::K_Q, factor), (&s::P_W, pressure), (&s::CHI_W, to)])
    });
}

/// Upper works that weigh nothing, or next to nothing.
pub fn weightless(n: &mut Node) {
    let (size, weight) = (n.draw.scale[0], n.draw.natural(&s::V));
    let own = weight * n.draw.pick(&[0.0, 1e-9]);
    list(n, "upper", 1, &mut |draw, _| {
        row(draw, &[(&s::G_U, own), (&s::R_U, size)])
    });
}
