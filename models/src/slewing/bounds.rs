//! What a scene of slewing in motion may ask, and the step with which its solver sees that.

use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::number::short;
use crate::kernel::schema::Values;
use crate::kernel::symbol::Symbol;
use crate::parts::air::AIR;
use crate::parts::control::SpeedControl;
use crate::parts::control::reading::TABLE;
use crate::parts::hanging::too_short;
use crate::parts::motion::{Motion, short_step};
use crate::parts::turntable::{self as joint, SlewingJoint, too_fast};
use crate::parts::turntable_control::fastest;
use crate::slewing::coupling::SlipCoupling;
use crate::slewing::symbols as s;

/// Least time in which friction stops what slews, or a continuous controller changes its speed, as a part of that which the working range takes, and of that of a pendulum
/// as long as reach and rope.
const BRISKEST: [f64; 2] = [1e-4, 5e-3];
/// Least inertia of what slews, over that of what does not add to it: a load that swings, the weight that leans.
const LIGHTEST: f64 = 5e-4;
/// Least inertia of the drive's side of a coupling, over that of all that slews.
const LIGHTEST_DRIVE: f64 = 1e-6;
/// Shortest step that may be given, over that which sees all: below it a solver of fourth order adds up rounding.
const SHORTEST_STEP: f64 = 1e-2;

/// Longest step of the solver where the scene gives none: parts of the time in which friction slows it, of those in which it
/// swings on its slope and in its wind and its load on the rope, of that in
/// which the head moves by its rope's length at the start, and of that in which a continuous controller changes the speed.
const LONGEST: [f64; 5] = [0.25, 0.1, 0.1, 0.1, 0.1];
/// The same of the run through the working range, or, where that is shorter than a swing of a rope as long as rope and
/// reach, of its time.
const LONGEST_IDLE: [f64; 2] = [0.002, 0.01];

/// Refuses what has no inertia.
pub fn weightless(v: &Values) -> Diagnostic {
    let what = "nothing that slews has an inertia";
    let help = "make J_sl greater than zero, or let a load hang at a reach that does not swing";
    v.refuse(joint::J_SL.id, what, "nothing to turn", help)
}

/// A scene in motion, as far as it decides how quick that is.
pub struct Slewed<'a> {
    pub table: &'a Values,
    pub joint: &'a SlewingJoint,
    pub range: &'a Motion,
    pub gravity: f64,
    /// Its load swings.
    pub swings: bool,
    pub coupling: Option<SlipCoupling<f64>>,
    pub control: Option<SpeedControl>,
}

impl Slewed<'_> {
    fn of(&self, symbol: &'static Symbol) -> f64 {
        self.table.of(symbol).unwrap_or(0.0)
    }

    /// Time of the run through the working range, in s.
    fn lasts(&self) -> f64 {
        (self.range.to - self.range.from) / self.range.speed.abs()
    }

    /// Reach of the head and length of the rope on which the load swings, in m.
    fn lengths(&self) -> [f64; 2] {
        let rope = if self.swings { self.of(&s::L_R) } else { 0.0 };
        [self.of(&s::R), rope]
    }

    /// Moment of all weights across the slope, the load's under its head, in N·m.
    fn across(&self) -> f64 {
        let leaning = self.of(&s::G_U) * self.of(&s::R_U) + self.of(&s::Q) * self.of(&s::R);
        leaning * Calc::sin_cos(self.of(&s::GAMMA_S)).0
    }

    /// Greatest moment of the wind on what slews that the scene has, in N·m.
    fn blown(&self) -> f64 {
        let Some(air) = self.table.table(AIR.name) else {
            return 0.0;
        };
        let [speed, density] = [&s::V_AIR, &s::RHO_AIR].map(|symbol| air.greatest(symbol.id).unwrap_or(0.0));
        0.5 * density * speed * speed * self.of(&s::A_WS) * self.of(&s::R_WS).abs()
    }

    /// How far from the axis something slews, in m: the head, or the weight that leans.
    fn widest(&self) -> f64 {
        let leans = if self.of(&s::G_U) == 0.0 { 0.0 } else { self.of(&s::R_U) };
        self.of(&s::R).max(leans.abs())
    }

    /// √(l/g) of a pendulum as long as that and the rope, in s.
    fn pendulum(&self) -> f64 {
        let [_, rope] = self.lengths();
        ((self.widest() + rope) / self.gravity).sqrt()
    }

    /// Inertia of the load, in kg·m².
    fn load(&self) -> f64 {
        self.of(&s::Q) / self.gravity * self.of(&s::R).powi(2)
    }

    /// Inertia of what slews, in kg·m²: a load that swings is no part of it.
    fn inertia(&self) -> f64 {
        let load = if self.swings { 0.0 } else { self.load() };
        self.joint.turning.j_sl + load
    }

    /// How quickly a continuous controller changes the speed, in s: of the drive alone where its coupling slips.
    fn regulated(&self) -> f64 {
        let least = self.coupling.map_or_else(|| self.inertia(), |coupling| coupling.j_d);
        let time = self.control.and_then(|control| control.quickest(least));
        time.unwrap_or(f64::INFINITY)
    }

    /// Time (s) within which nothing may change by itself; see [`BRISKEST`].
    fn briskest(&self) -> f64 {
        let [run, swing] = BRISKEST;
        (run * self.lasts()).max(swing * self.pendulum())
    }

    /// A step (s) that sees all that the motion does; see [`LONGEST`].
    #[must_use]
    pub fn longest(&self) -> f64 {
        let turning = self.joint.turning;
        let [reach, rope] = self.lengths();
        // A load that swings leaves slewing by itself, and pulls it back the harder the heavier it is.
        let heavy = 1.0 + self.load() / turning.j_sl;
        let stiffness = self.across().abs() + self.blown();
        let mut times = [
            self.inertia() / turning.c_sl,
            (self.inertia() / stiffness).sqrt(),
            f64::INFINITY,
            f64::INFINITY,
            self.regulated(),
        ];
        if self.swings {
            times[2] = (rope / (self.gravity * heavy)).sqrt();
            times[3] = rope / (reach * self.joint.start[1].abs());
        }
        let [run, swing] = LONGEST_IDLE;
        let idle = (run * self.lasts()).max(swing * self.pendulum());
        let steps = times.iter().zip(LONGEST).map(|(time, part)| time * part);
        steps.fold(idle, f64::min)
    }

    /// Refuses what no crane has, and what a solver would follow for nothing.
    pub fn check(&self, found: &mut Vec<Diagnostic>) {
        let [reach, rope] = self.lengths();
        let rope = self
            .swings
            .then(|| too_short(self.table, rope, (&s::R, reach)))
            .flatten();
        let refused = [
            self.brisk(),
            self.abrupt(),
            self.spins(),
            self.light(),
            rope,
            self.short_step(),
        ];
        found.extend(refused.into_iter().flatten());
        found.extend(self.coupling.and_then(|coupling| self.coupled(&coupling)));
    }

    /// A coupling that would never let the drive slew, or not hold what slews, and a drive of next to no inertia.
    fn coupled(&self, coupling: &SlipCoupling<f64>) -> Option<Diagnostic> {
        let table = self.table.table("coupling")?;
        let SlipCoupling { j_d, m_lim } = *coupling;
        let (dry, across) = (self.joint.turning.m_f_sl, self.across().abs());
        let least = LIGHTEST_DRIVE * self.inertia();
        if m_lim <= dry {
            let what = format!("the coupling slips at M_lim = {}", s::M_LIM.written(m_lim));
            let label = format!(
                "less than the dry friction M_Fsl = {} of slewing",
                joint::M_F_SL.written(dry)
            );
            let help = "give more: by no moment of its drive would the crane begin to slew";
            return Some(table.refuse(s::M_LIM.id, what, label, help));
        }
        if m_lim + dry < across {
            let what = format!("the coupling slips at M_lim = {}", s::M_LIM.written(m_lim));
            let label = format!("the slope needs up to {}", s::M_GAMMA.written(across));
            let help = format!(
                "give at least {}, which with the dry friction M_Fsl holds the weights across the slope: else the crane \
                 turns downhill, whatever drive and brake do",
                s::M_LIM.written(across - dry)
            );
            return Some(table.refuse(s::M_LIM.id, what, label, help));
        }
        (j_d < least).then(|| {
            let what = format!(
                "J_d = {}, where all that slews has {}",
                s::J_D.written(j_d),
                s::J_TOT.written(self.inertia())
            );
            let help = format!(
                "give the inertia of motors and brakes at the slewing axis, J_M i_sl^2 of each, together at least {}",
                s::J_D.written(least)
            );
            table.refuse(s::J_D.id, what, "too little", help)
        })
    }

    /// Friction that stops at once what slews.
    fn brisk(&self) -> Option<Diagnostic> {
        let time = self.inertia() / self.joint.turning.c_sl;
        let ([run, swing], least) = (BRISKEST, self.briskest());
        (time < least).then(|| {
            let what = format!(
                "c_sl = {} stops all that slews within {} s",
                joint::C_SL.written(self.joint.turning.c_sl),
                short(time)
            );
            let help = format!(
                "give less friction or more inertia: {} s and more is modelled, {run:e} of the time of the working range and \
                 {swing} of √((R + l_R)/g)",
                short(least)
            );
            self.table.refuse(joint::C_SL.id, what, "too much", help)
        })
    }

    /// Gains of a continuous controller that change the speed at once.
    fn abrupt(&self) -> Option<Diagnostic> {
        let ([run, swing], least, time) = (BRISKEST, self.briskest(), self.regulated());
        let [k_p, k_i, cycle, ..] = self.control?.axis.settings;
        (time < least).then(|| {
            let table = self.table.table(TABLE).unwrap_or(self.table);
            let what = format!("a continuous controller that changes the speed within {} s", short(time));
            let help = format!(
                "give less {} and {}: J/{} and √(J/{}) of {} s and more are modelled, {run:e} of the time of the working range and \
                 {swing} of √((R + l_R)/g), where J is the inertia of what slews, of the drive's side of a coupling that slips; \
                 or add {} = \"20 ms\", the cycle of a sampled one",
                k_p.id,
                k_i.id,
                k_p.id,
                k_i.id,
                short(least),
                cycle.id
            );
            table.refuse(k_p.id, what, "too much", help)
        })
    }

    /// A speed at which no head, and no weight, would stay on its crane.
    fn spins(&self) -> Option<Diagnostic> {
        let motion = self.table.table("motion")?;
        let mut speeds = vec![
            (self.table, joint::OMEGA_SL.id, self.joint.start[1]),
            (motion, "speed", self.range.speed),
        ];
        speeds.extend(fastest(self.table));
        let head = self.of(&s::R) == self.widest();
        let place = if head {
            "at the head"
        } else {
            "at the weight that leans"
        };
        too_fast(&speeds, (self.widest(), place), self.gravity)
    }

    /// What slews has next to no inertia beside what it carries.
    fn light(&self) -> Option<Diagnostic> {
        let leaning = self.of(&s::G_U).abs() / self.gravity * self.of(&s::R_U).powi(2);
        let least = LIGHTEST * (leaning + if self.swings { self.load() } else { 0.0 });
        (self.inertia() < least).then(|| {
            let what = format!(
                "J_sl = {}, where load and leaning weight alone have {}",
                joint::J_SL.written(self.joint.turning.j_sl),
                joint::J_SL.written(least / LIGHTEST)
            );
            let help = format!(
                "give the inertia of all that slews, with what leans, at least {}",
                joint::J_SL.written(least)
            );
            self.table.refuse(joint::J_SL.id, what, "too little", help)
        })
    }

    /// A step that sees no more than a longer one.
    fn short_step(&self) -> Option<Diagnostic> {
        let longest = self.longest();
        short_step(
            self.table.table("dynamics")?,
            &s::STEP,
            [SHORTEST_STEP * longest, longest],
        )
    }
}
