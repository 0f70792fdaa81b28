//! Independent ways to what the cases ask for.

use std::num::NonZeroUsize;

use gauss_quad::GaussLegendre;

use crate::component::extreme::fine;
use crate::component::probe::slots;
use crate::component::sheet::Check;
use crate::component::standing::Standing;
use crate::kernel::calc::Calc;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::bodies::spread;
use crate::luffing::resistances::given::CasesChoice;
use crate::luffing::resistances::loads::Loads;
use crate::luffing::resistances::placed::{BARS, MovedBars};
use crate::luffing::resistances::scene::Cases;
use crate::luffing::resistances::symbols as s;
use crate::luffing::resistances::told::{Felt, Resists, felt};
use crate::parts::plane::{Point, dot};

/// Relative to the greatest moment: the drive's moment at rest by equilibrium, named `m_d`; the power of all forces on the
/// bodies; the work over the range by the energies at its ends.
pub fn identities<T: Resists>(model: &Standing, cases: &Cases, m_d: &'static Symbol) -> Vec<Check> {
    let Some(choice) = &cases.choice else { return Vec::new() };
    let at_rest = slots(model, &s::M_R_OWN).next().zip(slots(model, m_d).next());
    let loaded = cases.cases.iter().position(|case| case.k_q > 0.0);
    let (mut rest, mut apart, mut scale) = (0.0_f64, 0.0_f64, f64::MIN_POSITIVE);
    let mut part = model.part().duplicate();
    let mut felt = felt::<T>(model);
    for at in fine(model.motion()) {
        let Ok(felt) = felt(at) else {
            apart = f64::INFINITY;
            continue;
        };
        for (loads, resisted) in felt.loads.iter().zip(&felt.resisted) {
            scale = scale.max(resisted.greatest());
            apart = apart.max((power(&felt.moved, loads) - resisted.sum).abs());
        }
        part.put(model.coordinate(), at);
        if let Some(((own, needed), loaded)) = at_rest.zip(loaded) {
            let mut value = |slot| {
                let mut value = 0.0;
                part.result(slot, &mut value).map_or(f64::INFINITY, |()| value)
            };
            let load = felt.resisted[loaded].load() / cases.cases[loaded].k_q;
            rest = rest.max((value(&own) + load + value(&needed)).abs());
        }
    }
    let range = model.motion().to - model.motion().from;
    let work = work::<T>(model, cases, choice) / range;
    let agree = |id, difference: f64, limit| Check::at_most(id, &s::AGREEMENT_R, difference / scale, limit);
    vec![
        agree("resistance_rest", rest, 1e-12),
        agree("resistance_power", apart, 1e-12),
        agree("resistance_energy", work, 1e-9),
    ]
}

/// Of all forces on the bodies, and of a hoist rope that the mechanism leads away from the head, for one radian of the
/// luffing angle, in N·m.
fn power(moved: &MovedBars<f64>, loads: &Loads<f64>) -> f64 {
    let travel = &moved.at[1];
    let bars = loads.bars.iter().zip(&travel.bars).enumerate();
    let bars = bars.map(|(i, ((force, moment), [joint, _]))| dot(*force, *joint) + moment * moved.turn(i)[0]);
    let led = loads.load * (travel.head.y - travel.load);
    bars.sum::<f64>() + dot(loads.head, travel.head) + dot(loads.counterweight, travel.counterweight) + led
}

/// How far, in J, the work over the range of what has an energy is from the difference of the energies, in the worst case.
fn work<T: Resists>(model: &Standing, cases: &Cases, choice: &CasesChoice) -> f64 {
    const POINTS: NonZeroUsize = NonZeroUsize::new(24).expect("not zero");
    const PIECES: u32 = 12;
    let rule = GaussLegendre::new(POINTS);
    let [from, to] = [model.motion().from, model.motion().to];
    let place = |piece: u32| from + (to - from) * f64::from(piece) / f64::from(PIECES);
    let mut felt = felt::<T>(model);
    let ends = [from, to].map(|at| felt(at).ok());
    let mut work = vec![0.0; cases.cases.len()];
    for (piece, (node, weight)) in (0..PIECES).flat_map(|piece| rule.iter().map(move |point| (piece, point))) {
        let half = 0.5 * (place(piece + 1) - place(piece));
        let felt = felt(place(piece) + half * (1.0 + node)).ok();
        for (case, work) in work.iter_mut().enumerate() {
            let moment = felt.as_ref().map_or(f64::NAN, |felt| felt.resisted[case].of_energy());
            *work += weight * half * moment;
        }
    }
    let of = |(case, work): (usize, f64)| {
        let [start, end] = ends
            .each_ref()
            .map(|felt| felt.as_ref().map_or(f64::NAN, |felt| energy(cases, choice, felt, case)));
        let apart = (work - (end - start)).abs();
        if apart.is_nan() { f64::INFINITY } else { apart }
    };
    work.into_iter().enumerate().map(of).fold(0.0, f64::max)
}

/// Of all that acts in a case but inertia and friction, in J, but for a constant: what it has given.
fn energy(cases: &Cases, choice: &CasesChoice, felt: &Felt, case: usize) -> f64 {
    let (given, resisted, moved) = (&cases.cases[case], &felt.resisted[case], &felt.moved);
    let (sin, cos) = Calc::sin_cos(given.sigma);
    let (q, half) = (felt.loads[case].load, resisted.slewing * resisted.slewing / 2.0);
    let of = |mass: f64, r: Point<f64>| {
        let x = r.x - moved.of.axis;
        mass * (moved.of.gravity * (sin * r.x - cos * r.y) + half * x * x)
    };
    let bar = |i: usize| {
        let (body, [_, along]) = (&moved.of.bodies[i], moved.at[0].bars[i]);
        of(body.mass, moved.point(i, body.centre)[0]) + half * spread(body.spread, along)
    };
    let areas = cases.bodies.iter().zip(&choice.bodies);
    let wind = areas.map(|(it, on)| resisted.pressure * it.area * it.drag * moved.on(*on, it.middle())[0].x);
    let (sway, placed) = (Calc::sin_cos(given.alpha), &moved.at[0]);
    let load = (sway.0 / sway.1 + sin) * placed.head.x + (1.0 - cos) * placed.head.y - placed.load;
    (0..BARS).map(bar).sum::<f64>() + of(moved.of.counterweight, placed.counterweight) + wind.sum::<f64>() + q * load
}
