//! Where the energy of a run came from and went.

use crate::component::sheet::{self, Integral, Power};
use crate::drive::symbols as d;
use crate::kernel::symbol::Symbol;
use crate::luffing::moving::hoisting::HoistKind;
use crate::luffing::moving::powers::Powers;
use crate::luffing::moving::scene::Moving;
use crate::luffing::moving::symbols as m;
use crate::parts::hydraulics::symbols as h;

/// Where energy came from and went, in J.
#[derive(Default)]
pub(super) struct Energy {
    pub start: f64,
    pub end: f64,
    pub work: Powers,
    pub blows: f64,
    pub rest: f64,
    /// How much of the rest rounding may be: all of it where nothing moves.
    pub rounding: f64,
    /// Of the bodies' motion, at most: a load that swings by itself turns over nothing else.
    pub kinetic: f64,
}

impl Energy {
    /// A step of the run to a next energy (J), with what blows have taken.
    pub(super) fn add(&mut self, step: &Powers, after: f64) {
        self.rest += net(step) - (after - self.end);
        self.rounding += rounding(self.end, after);
        self.end = after;
        self.work = sum(&[(&self.work, 1.0), (step, 1.0)]);
    }

    pub(super) fn list(&self, moving: &Moving) -> sheet::Energy {
        let (oil, work) = (moving.oil.is_some(), &self.work);
        let (slews, hangs) = (moving.slewing.is_some(), moving.rope.is_some());
        let air = moving.rope.is_some_and(|rope| rope.air.is_some());
        let there = |lines: &[(bool, &'static Symbol, f64)]| {
            let lines = lines.iter().filter(|(there, _, _)| *there);
            lines.map(|&(_, symbol, value)| (symbol, value)).collect()
        };
        sheet::Energy {
            given: there(&[
                (!oil, &m::W_A, work.drive),
                (slews, &m::W_SL, work.slewing),
                (hangs && moving.hoists(), &m::W_H, work.hoist),
                (oil, &m::W_P, work.pump),
                (is_blown(moving), &m::W_WIND, work.wind),
                (moving.meets.slewing, &m::W_OMEGA, work.slewed),
            ]),
            stored: there(&[
                (true, &m::DELTA_E, self.end - self.start - self.blows),
                (oil, &m::E_OIL, work.compression),
            ]),
            taken: there(&[
                (true, &m::W_R, work.friction),
                (oil, &m::W_T, work.throttles),
                (air, &m::W_AIR, work.air),
                (!oil || slews || hangs, &m::W_BLOW, self.blows),
                (true, &m::W_E, self.rest),
            ]),
        }
    }
}

/// Whether wind acts on its bodies or on all that slews.
fn is_blown(moving: &Moving) -> bool {
    moving.meets.pressure || moving.area.is_some()
}

/// What is left of the powers for the bodies.
pub(super) fn net(p: &Powers) -> f64 {
    p.drive + p.slewing + p.hoist + p.pump + p.wind + p.slewed - p.friction - p.throttles - p.compression - p.air
}

/// What rounding may leave between two energies.
pub(super) fn rounding(before: f64, after: f64) -> f64 {
    f64::EPSILON * (before.abs() + after.abs())
}

/// What was given and taken.
pub(super) fn turnover(work: &Powers) -> f64 {
    let given = work.pump.abs() + work.slewing.abs() + work.hoist.abs() + work.wind.abs() + work.slewed.abs();
    given + work.throttles + work.friction + work.compression.abs() + work.air.abs()
}

/// Powers, each times a number.
pub(super) fn sum(parts: &[(&Powers, f64)]) -> Powers {
    let of = |power: fn(&Powers) -> f64| parts.iter().map(|(powers, factor)| power(powers) * factor).sum();
    Powers {
        drive: of(|p| p.drive),
        slewing: of(|p| p.slewing),
        hoist: of(|p| p.hoist),
        pump: of(|p| p.pump),
        friction: of(|p| p.friction),
        throttles: of(|p| p.throttles),
        compression: of(|p| p.compression),
        air: of(|p| p.air),
        wind: of(|p| p.wind),
        slewed: of(|p| p.slewed),
    }
}

/// What the works are sums of, with the rate of the driving link.
pub(super) fn integrals(moving: &Moving, rate: &'static Symbol) -> Vec<Integral> {
    let of = |negative: bool, factors: &[&'static Symbol], over: Option<&'static Symbol>| Power {
        negative,
        factors: factors.to_vec(),
        over,
    };
    let integral = |there: bool, symbol: &'static Symbol, of: Vec<Power>| there.then_some(Integral { symbol, of });
    let (oil, slews, hangs) = (moving.oil.is_some(), moving.slewing.is_some(), moving.rope.is_some());
    let air = moving.rope.is_some_and(|rope| rope.air.is_some());
    let (motor, hauled) = (moving.has_motor(), moving.is_hauled());
    let elastic = moving.rope.is_some_and(|rope| rope.give.is_some());
    let hoist = match moving.rope.map(|rope| rope.hoist) {
        Some(HoistKind::Motor(..)) => of(true, &[&m::M_M_H, &m::M_H, &m::V_R], Some(&m::R_H)),
        _ => of(true, &[&m::S_R, &m::V_R], None),
    };
    let friction = [
        Some(of(true, &[&m::M_R, rate], None)),
        slews.then(|| of(true, &[&m::M_R_SL, &m::OMEGA_SL], None)),
        motor.then(|| of(false, &[&m::M_R_H, &m::M_H, &m::V_R], Some(&m::R_H))),
        elastic.then(|| of(false, &[&m::S_RD, &m::D_DELTA_R], None)),
        hauled.then(|| of(false, &[&m::P_BL], None)),
    ];
    let wind = [
        moving.meets.pressure.then(|| of(false, &[&m::M_WIND, rate], None)),
        moving.area.map(|_| of(false, &[&m::M_WS, &m::OMEGA_SL], None)),
    ];
    let stored = [
        [&m::V_1, &m::P_1, &m::D_P_1],
        [&m::V_1, &m::P_2, &m::D_P_2],
        [&h::V_A, &m::P_A, &m::D_P_A],
        [&h::V_B, &m::P_B, &m::D_P_B],
    ];
    let compression = |negative: bool| {
        stored
            .iter()
            .map(|factors| of(negative, factors, Some(&m::BETA_E)))
            .collect()
    };
    let limited = moving.oil_parts.is_some_and(|parts| parts.pump.is_some());
    let pump = || of(false, &[if limited { &h::P_S } else { &m::P_P }, &h::Q_0], None);
    // What the pump gives, the oil does not store and the rod does not take.
    let mut resisted = vec![pump(), of(true, &[&m::F_C, &d::V_D], None)];
    resisted.extend(compression(true));
    let all = [
        integral(
            !oil,
            &m::W_A,
            vec![match hauled {
                true => of(false, &[&m::P_ML], None),
                false => of(false, &[&m::M_A, rate], None),
            }],
        ),
        integral(slews, &m::W_SL, vec![of(false, &[&m::M_SL, &m::OMEGA_SL], None)]),
        integral(hangs && moving.hoists(), &m::W_H, vec![hoist]),
        integral(oil, &m::W_P, vec![pump()]),
        integral(is_blown(moving), &m::W_WIND, wind.into_iter().flatten().collect()),
        integral(
            moving.meets.slewing,
            &m::W_OMEGA,
            vec![of(false, &[&m::M_OMEGA, rate], None)],
        ),
        integral(oil, &m::E_OIL, compression(false)),
        integral(true, &m::W_R, friction.into_iter().flatten().collect()),
        integral(oil, &m::W_T, resisted),
        integral(air, &m::W_AIR, vec![of(false, &[&m::P_AIR], None)]),
    ];
    all.into_iter().flatten().collect()
}
