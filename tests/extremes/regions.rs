//! The stable region of each solver, and of each level with its solver: where a step neither grows nor strays, on y′ = λ y over the plane
//! of z = λ h. Drawn to `docs/stability.svg` (`LEMNIS_WRITE=1` renews it).

use std::fmt::Write as _;
use std::path::Path;

use lemnis_models::parts::solver::rodas::SolverStep;
use lemnis_models::parts::solver::{System, runge_kutta};

use super::running;

/// λ as a system of two real states.
struct Linear {
    re: f64,
    im: f64,
}

impl System<2> for Linear {
    fn rates(&self, y: &[f64; 2]) -> Option<[f64; 2]> {
        Some([self.re * y[0] - self.im * y[1], self.im * y[0] + self.re * y[1]])
    }
    fn jacobian(&self, y: &[f64; 2]) -> Option<([f64; 2], [[f64; 2]; 2])> {
        Some((self.rates(y)?, [[self.re, -self.im], [self.im, self.re]]))
    }
}

fn explicit(re: f64, im: f64) -> Option<[f64; 2]> {
    let system = Linear { re, im };
    runge_kutta::step(&[1.0, 0.0], 1.0, |y| system.rates(y))
}

fn implicit(re: f64, im: f64) -> Option<[f64; 2]> {
    SolverStep::new(&Linear { re, im }, &[1.0, 0.0], 1.0).map(|step| step.to)
}

type Method = fn(f64, f64) -> Option<[f64; 2]>;

fn growth(method: Method, re: f64, im: f64) -> f64 {
    method(re, im).map_or(f64::INFINITY, |[a, b]| (a * a + b * b).sqrt())
}

/// Distance from the solution itself, e^z.
fn error(method: Method, re: f64, im: f64) -> f64 {
    let size = libm_exp(re);
    let (sin, cos) = lemnis_models::kernel::calc::Calc::sin_cos(im);
    method(re, im).map_or(f64::INFINITY, |[a, b]| {
        ((a - size * cos).powi(2) + (b - size * sin).powi(2)).sqrt()
    })
}

/// e^x by its series and squaring: for a drawing.
fn libm_exp(x: f64) -> f64 {
    let part = x / 1024.0;
    let mut sum = 1.0 + part * (1.0 + part / 2.0 * (1.0 + part / 3.0 * (1.0 + part / 4.0)));
    for _ in 0..10 {
        sum *= sum;
    }
    sum
}

/// Where the growth along a ray from the origin first exceeds one.
fn limit(method: Method, re: f64, im: f64) -> f64 {
    let (mut inside, mut outside) = (0.5, 10.0);
    for _ in 0..60 {
        let middle = f64::midpoint(inside, outside);
        if growth(method, re * middle, im * middle) <= 1.0 + 1e-13 {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    inside
}

/// RK4 ends at -2.785294 and ±2.828427 i (2 sqrt 2); Rodas is stable in the whole left half plane, and
/// damps what is infinitely stiff completely.
#[test]
fn limits_are_those_of_theory() {
    let [real, imaginary] = [limit(explicit, -1.0, 0.0), limit(explicit, 0.0, 1.0)];
    println!("RK4: {real} {imaginary}");
    assert!((real - 2.785_293_563_405_282).abs() < 1e-9 && (imaginary - 8_f64.sqrt()).abs() < 1e-6);
    for k in 0..=400 {
        let angle = std::f64::consts::FRAC_PI_2 * (1.0 + f64::from(k) / 400.0);
        let (sin, cos) = lemnis_models::kernel::calc::Calc::sin_cos(angle);
        for exponent in -3..=9 {
            let r = 10_f64.powi(exponent);
            let cos = cos.min(0.0);
            assert!(growth(implicit, r * cos, r * sin) <= 1.0 + 1e-9, "{r:e} {angle}");
        }
    }
    assert!(growth(implicit, -1e9, 0.0) < 1e-6 && growth(implicit, -1e6, 1e6) < 1e-3);
    // Accurate is not stable: a bounded step may still be far off.
    assert!(growth(explicit, -2.7, 0.0) < 1.0 && error(explicit, -2.7, 0.0) > 0.5);
    assert!(error(implicit, -2.7, 0.0) < 0.02);
}

/// Cells for each factor of ten, and the factors of ten from first to last, of |λ| h.
const CELLS: i32 = 6;
const DECADES: [i32; 2] = [-2, 7];

/// What each level makes of a longest step, over |λ| h: every step is taken within a twentieth of the known
/// motion, or refused.
fn levels() -> String {
    let (left, width, top) = (250.0, 590.0, 455.0);
    let cell = width / f64::from(CELLS * (DECADES[1] - DECADES[0]));
    let mut svg = String::from("<text x=\"20\" y=\"446\">Levels with their solvers: |λ|h of the longest step</text>\n");
    let rows = running::rows();
    let bottom = 26.0 * rows.len() as f64;
    for (row, y) in rows.into_iter().zip((0..).map(|i| 26.0 * f64::from(i))) {
        let _ = writeln!(
            svg,
            "<text x=\"20\" y=\"{}\" font-size=\"11\">{}</text>",
            top + y + 14.0,
            row.name
        );
        let mut refused = false;
        for i in 0..CELLS * (DECADES[1] - DECADES[0]) {
            let exponent = f64::from(DECADES[0]) + (f64::from(i) + 0.5) / f64::from(CELLS);
            let z = libm_exp(exponent * std::f64::consts::LN_10);
            // Of a stiff system, steps longer than the motion are none, and ones of microseconds without use.
            let step = z / row.fastest;
            if row.fastest > 1e3 && !(5e-5..0.5).contains(&step) {
                continue;
            }
            let error = (row.error)(step);
            assert!(
                error.is_none_or(|error| error < 0.05),
                "{}: |lambda| h = {z}: {error:?}",
                row.name
            );
            assert!(!refused || error.is_none(), "{}: taken again at {z}", row.name);
            refused |= error.is_none();
            let colour = match error {
                Some(error) if error <= 0.01 => "#2b6cb0",
                Some(_) => "#bcd4ea",
                None => "#d8d8d8",
            };
            let x = left + cell * f64::from(i);
            let _ = writeln!(
                svg,
                "<rect x=\"{x:.2}\" y=\"{}\" width=\"{cell:.2}\" height=\"20\" fill=\"{colour}\"/>",
                top + y
            );
        }
    }
    for decade in DECADES[0]..=DECADES[1] {
        let x = left + cell * f64::from(CELLS * (decade - DECADES[0]));
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.2} {top}v{bottom}\" stroke=\"white\" stroke-width=\"0.7\"/><text x=\"{x:.2}\" y=\"{}\" font-size=\"11\" \
             text-anchor=\"middle\">1e{decade}</text>",
            top + bottom + 14.0
        );
    }
    let _ = writeln!(
        svg,
        "<rect x=\"25\" y=\"{}\" width=\"10\" height=\"10\" fill=\"#d8d8d8\"/><text x=\"40\" y=\"{}\" font-size=\"11\">refused</text>",
        top + bottom + 16.0,
        top + bottom + 25.0
    );
    svg
}

#[test]
fn the_regions_are_drawn() {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 668\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"860\" height=\"668\" fill=\"white\"/>\n",
    );
    for (panel, (name, method)) in [
        ("RK4, explicit", explicit as Method),
        ("Rodas, linearly implicit", implicit),
    ]
    .into_iter()
    .enumerate()
    {
        let left = 20.0 + 430.0 * panel as f64;
        let colour = |i: i32, j: i32| {
            // From -6 to 2 and from -4 to 4, in cells of 0.1.
            let (re, im) = (-5.95 + 0.1 * f64::from(i), -3.95 + 0.1 * f64::from(j));
            match (growth(method, re, im) <= 1.0, error(method, re, im) <= 0.01) {
                (true, true) => Some("#2b6cb0"),
                (true, false) => Some("#bcd4ea"),
                (false, true) => Some("#a0c69c"),
                (false, false) => None,
            }
        };
        for j in 0..80 {
            // Neighbours of one colour are one rectangle.
            let mut from = 0;
            for i in 1..=80 {
                if i < 80 && colour(i, j) == colour(from, j) {
                    continue;
                }
                if let Some(colour) = colour(from, j) {
                    let (x, y) = (left + 4.875 * f64::from(from), 30.0 + 4.875 * f64::from(79 - j));
                    let width = 4.875 * f64::from(i - from);
                    let _ = writeln!(
                        svg,
                        "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"4.9\" fill=\"{colour}\"/>"
                    );
                }
                from = i;
            }
        }
        let (x, y) = (left + 60.0 * 4.875, 30.0 + 40.0 * 4.875);
        let _ = writeln!(
            svg,
            "<path d=\"M{left} {y}h390M{x} 30v390\" stroke=\"black\" stroke-width=\"0.7\"/>\n<text x=\"{left}\" y=\"20\">{name}: z = λh, −6 … 2 by −4i … 4i</text>"
        );
    }
    svg.push_str(
        "<g font-size=\"11\"><rect x=\"25\" y=\"375\" width=\"10\" height=\"10\" fill=\"#2b6cb0\"/><text x=\"40\" y=\"384\">bounded, within 1 % of the solution</text>\
         <rect x=\"25\" y=\"390\" width=\"10\" height=\"10\" fill=\"#bcd4ea\"/><text x=\"40\" y=\"399\">bounded, not accurate</text>\
         <rect x=\"25\" y=\"405\" width=\"10\" height=\"10\" fill=\"#a0c69c\"/><text x=\"40\" y=\"414\">growing, as the solution does</text></g>\n",
    );
    svg.push_str(&levels());
    svg.push_str("</svg>\n");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/stability.svg");
    if std::env::var_os("LEMNIS_WRITE").is_some() {
        std::fs::write(&path, &svg).expect("written");
    }
    let found = std::fs::read_to_string(&path).expect("docs/stability.svg; LEMNIS_WRITE=1 makes it");
    assert!(
        found == svg,
        "docs/stability.svg is stale: renew it with LEMNIS_WRITE=1"
    );
}
