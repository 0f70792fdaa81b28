//! Starts of a combustion engine, which idles in front of a clutch and then pulls along its curve of torque over speed.
//!
//! ```text
//! until the clutch holds: (J - J_M) dω/dt = T(n_id) - T_0, the engine at idle
//! then:                   J dω/dt = T(n) - T_0,  ω = 2π n
//! ```
//!
//! The curve is straight between its points, so that of each piece the integral of dn over what the torque has to spare is its
//! length over the logarithmic mean of both ends. What the case asks for is that of the place where the start begins, as with a
//! mean torque.

use std::f64::consts::{LN_2, TAU};

use crate::kernel::calc::Calc;
use crate::kernel::group::{by_map, quantities};
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::polyline::{named, straight};
use crate::parts::starts::slip::RULE;
use crate::parts::starts::{self as s, RatedPoint, Starting};

/// Names of a point's speed and torque.
pub const POINT: [&Symbol; 2] = [&s::N_EN, &s::T_EN];

/// What these are for where no formula has them.
pub const USE: (&str, &[&Symbol]) = ("engine_curve", listed!(s: N_EN, T_EN, N_IDLE, N_GOV));

quantities! {
    /// Speeds of an engine (1/s): at idle, and the greatest to which its governor lets it run.
    EngineSpeeds { idle: N_IDLE, most: N_GOV }
}

/// An engine with its torque curve: points (1/s, N·m) with rising speed, all over its speeds.
#[derive(Clone, Debug)]
pub struct EngineStart<C> {
    pub speeds: EngineSpeeds<C>,
    pub curve: Vec<[f64; 2]>,
}
by_map!(EngineStart: 2);

impl<C: Copy> EngineStart<C> {
    /// The symbols of what is no curve.
    pub const SYMBOLS: &'static [&'static Symbol] = EngineSpeeds::<C>::SYMBOLS;

    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> EngineStart<D> {
        EngineStart {
            speeds: self.speeds.map(f),
            curve: self.curve.clone(),
        }
    }
}

impl EngineStart<f64> {
    /// Whether it runs at a speed (1/s).
    #[must_use]
    pub fn runs(&self, n: f64) -> bool {
        n >= self.speeds.idle && n <= self.speeds.most
    }

    /// Speeds (1/s) and torques (N·m) behind the clutch, from rest to the governed speed.
    #[must_use]
    pub fn over_speed(&self) -> Vec<[f64; 2]> {
        let slips = [0.0, self.at_idle()];
        std::iter::once(slips).chain(self.through(self.speeds.most)).collect()
    }
}

impl<C: Calc> EngineStart<C> {
    /// Torque (N·m) at a speed (1/s); beyond the curve that at its end.
    fn torque(&self, n: C) -> C {
        straight(&self.curve, n, 0, POINT).unwrap_or_else(|| {
            let last = self.curve.len() - 1;
            let end = if n.value() < self.curve[0][0] { 0 } else { last };
            named::<C>(POINT, end as u16 + 1, self.curve[end])[1].over(n)
        })
    }

    /// Torque (N·m) at idle.
    pub fn at_idle(&self) -> C {
        self.torque(self.speeds.idle)
    }

    /// Speeds (1/s) and torques (N·m) from idle to a speed (1/s): at both ends, and at all points of the curve between.
    fn through(&self, n: C) -> impl Iterator<Item = [C; 2]> + Clone + '_ {
        let idle = self.speeds.idle;
        let inner = (1..).zip(&self.curve);
        let inner = inner.filter(move |(_, point)| point[0] > idle.value() && point[0] < n.value());
        let inner = inner.map(|(number, point)| named(POINT, number, *point));
        let ends = [idle, n].map(|end| [end, self.torque(end)]);
        std::iter::once(ends[0]).chain(inner).chain(std::iter::once(ends[1]))
    }

    /// The greatest torque (N·m) from idle to a speed (1/s).
    pub fn most(&self, n: C) -> C {
        picked(self.through(n), C::greater)
    }
}

/// The greatest or the least torque of these.
fn picked<C: Calc>(all: impl Iterator<Item = [C; 2]>, of: fn(C, C) -> C) -> C {
    all.map(|point| point[1]).reduce(of).expect("two ends")
}

/// Of a number that goes straight from one value above zero to another: the mean of its reciprocal, which is
/// ln(a/b)/(a − b). Halves give the natural logarithm of two each, the rest is found by Gauss's rule.
fn reciprocal<C: Calc>(one: C, other: C) -> C {
    let half = C::constant(0.5);
    let (most, least) = if one.value() > other.value() {
        (one, other)
    } else {
        (other, one)
    };
    let (mut top, mut halves) = (most, 0.0);
    while top.value() > 2.0 * least.value() {
        (top, halves) = (half * top, halves + 1.0);
    }
    let (center, wide) = (half * (top + least), half * (top - least));
    let mut mean = C::constant(0.0);
    for [node, weight] in RULE {
        let away = wide * C::constant(node);
        let both = C::constant(1.0) / (center - away) + C::constant(1.0) / (center + away);
        mean += half * C::constant(weight) * both;
    }
    if halves == 0.0 {
        return mean;
    }
    (C::constant(halves * LN_2) + mean * (top - least)) / (most - least)
}

/// A start of an engine.
#[derive(Clone, Copy, Debug)]
pub struct Engined<C> {
    pub peak: C,
    pub reserve: C,
    pub idle: C,
    pub least: C,
    pub clutch: C,
    pub spared: C,
    pub time: C,
    pub quickens: C,
}

impl<C: Calc> Engined<C> {
    /// t_c = (J − J_M) ω_id/(T(n_id) − T_0), t = t_c + J ω_id/T_max · I. [Ports001, 6.5.3, derived; by integration]
    pub fn new(rated: &RatedPoint<C>, start: &EngineStart<C>, run: &Starting<C>) -> Engined<C> {
        let peak = start.most(start.speeds.most).def(&s::T_E_MAX);
        let idle = start.at_idle().def(&s::T_ID);
        let none = C::constant(0.0).over(peak);
        let mut found = Engined {
            peak,
            reserve: (peak / rated.torque).def(&s::K_E),
            idle,
            least: none,
            clutch: none,
            spared: none,
            time: none,
            quickens: none,
        };
        if !run.moves {
            return found;
        }
        let (n, speeds) = (run.n.abs(), start.speeds);
        let runs = n.value() >= speeds.idle.value() && n.value() <= speeds.most.value();
        found.least = picked(start.through(n), C::smaller).def(&s::T_E_LEAST);
        let spare = found.least - run.against;
        if spare.value() <= 0.0 || !runs {
            let never = |symbol| C::known(symbol, f64::INFINITY).over(spare);
            (found.clutch, found.spared, found.time) = (never(&s::T_CL), never(&s::I_E), never(&s::T_ENG));
        } else {
            let turning = C::constant(TAU) * speeds.idle;
            found.clutch = ((run.inertia - run.own) * turning / (idle - run.against)).def(&s::T_CL);
            let pieces = start.through(n).zip(start.through(n).skip(1));
            let spared = pieces.map(|([from, before], [to, behind])| {
                (to - from) / speeds.idle * (peak * reciprocal(before - run.against, behind - run.against))
            });
            found.spared = spared
                .reduce(|sum, one| sum + one)
                .expect("one piece")
                .tabled(&s::I_E)
                .def(&s::I_E);
            found.time = (found.clutch + run.inertia * turning / peak * found.spared).def(&s::T_ENG);
        }
        found.quickens = (run.head / found.time).def(&s::A_ENG);
        found
    }
}
