//! The hopper of a crane as scenes describe it and books tell it.

use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::Draw;
use crate::component::mechanism::{Entry, Solver};
use crate::component::moving::MovingComponent;
use crate::component::moving::smooth::SmoothPieces;
use crate::component::outline::{Limit, Outline};
use crate::component::running::Running;
use crate::component::sheet::{Check, Drawing};
use crate::component::standing::Standing;
use crate::component::telling::sample;
use crate::hopper::balance::{FeederCommand, GrabCycle, HopperFeeder, HopperSize};
use crate::hopper::flow::{BrimMemory, PassedMass};
use crate::hopper::outline::OUTLINE;
use crate::hopper::stages::{Given, HopperCrane};
use crate::hopper::symbols as s;
use crate::kernel::calc::Calc;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::motion::{Motion, short_step};
use crate::parts::plane::Point;

/// Keys of `[hopper]`.
pub const KEYS: &[Key] = keys! { s:
    M_MAX > 0, RHO_B > 0, M_G > 0, T_C > 0, T_D >= 0 [usually(0.0)], T_P >= 0 [usually(0.0)], Q_F > 0,
    M_H >= 0 [optional], Q_IN >= 0 [over_time, optional], Y_F >= 0 [over_time, optional];
    Key::choice(
        "fidelity",
        &["static", "flow"],
        "How deep the hopper is modelled: \"static\" (its contents are an input), \"flow\" (they follow from what grab and \
         feeder do, and it gets full and empty).",
    ),
    Key::part("dynamics", DYNAMICS, "How the flow is solved."),
    Key::table("motion", MOTION, "Working range of the contents."),
    Key::part("limits", LIMITS, "What results may come to at most, or at least.")
};

static DYNAMICS: &[Key] = keys! { s: STEP > 0 };
const MOTION: &[Key] = &Motion::keys(
    [&s::FROM, &s::TO],
    &s::M_H,
    (
        &s::Q_IN,
        "Flow from the grab with which the contents rise in the run through the working range, the feeder at rest.",
    ),
);
const LIMITS: &[Key] = &Limit::keys::<3>(OUTLINE.limits);

/// Keys that say something of the flow alone, with the table of its solver.
const MOVING: [&str; 4] = ["m_h", "q_in", "y_f", "dynamics"];

/// Longest step of the solver over a cycle of the grab, and the shortest that may be given over that.
const LONGEST: f64 = 0.1;
const SHORTEST: f64 = 1e-2;

/// What the rates cost, in s.
const COST: [f64; 2] = [0.05e-6, 0.0];

/// Samples of the run that is checked, and cycles that are.
const SAMPLES: u32 = 100;
const CYCLES: u32 = 10;

/// The hopper of a crane as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct HopperScene {
    /// At the start of the working range.
    given: Given<f64>,
    /// Contents (kg) and flow from the grab (kg/s) at the start of its motion.
    start: [f64; 2],
    /// Longest step of the solver, in s.
    step: f64,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<HopperScene>::entry("hopper", KEYS);

/// Refuses what no hopper holds, a grab that takes longer to empty itself than its cycle, and what has no use.
fn suits(v: &Values, range: &Motion, moves: bool, found: &mut Vec<Diagnostic>) -> Option<()> {
    let most = v.of(&s::M_MAX)?;
    let ends = v.table("motion")?;
    let held = [
        (v, s::M_H.id, v.number(s::M_H.id).unwrap_or(0.0)),
        (ends, "from", range.from),
        (ends, "to", range.to),
    ];
    for (table, key, contents) in held {
        if !(0.0..=most).contains(&contents) {
            let what = format!("{key} = {}", s::M_H.written(contents));
            let help = format!("the hopper holds from 0 to m_max = {}", s::M_MAX.written(most));
            found.push(table.refuse(key, what, "no contents of this hopper", help));
        }
    }
    let [cycle, empties] = [v.of(&s::T_C)?, v.of(&s::T_D)?];
    if empties > cycle {
        let what = format!("the grab empties itself in t_d = {}", s::T_D.written(empties));
        let help = format!("a part of its cycle, which takes t_c = {}", s::T_C.written(cycle));
        found.push(v.refuse(s::T_D.id, what, "longer than a cycle", help));
    }
    if let (false, Some(key)) = (moves, MOVING.iter().find(|key| v.has(key))) {
        let what = format!("`{key}` of a hopper whose contents are set");
        found.push(v.refuse(key, what, "not used", "set fidelity = \"flow\", or remove it"));
    }
    let longest = LONGEST * cycle;
    found.extend(
        v.table("dynamics")
            .and_then(|table| short_step(table, &s::STEP, [SHORTEST * longest, longest])),
    );
    Some(())
}

impl Described for HopperScene {
    type Component = HopperCrane;
    const ID: &'static str = "hopper";
    const TABLE: &'static str = "hopper";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = listed!(s: Q_OUT, Q_S);
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "hopper_symbol",
        own: &[s::ALL],
        shared: &[gravity::ALL],
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(HopperScene, Motion)> {
        let before = found.len();
        let moves = v.text("fidelity") == Some("flow");
        let range = Motion::read(v.table("motion")?, found)?;
        suits(v, &range, moves, found)?;
        if found.len() > before {
            return None;
        }
        let n = |symbol: &Symbol, usual| v.number(symbol.id).unwrap_or(usual);
        let given = Given {
            contents: One(&s::M_H, range.from),
            into: One(&s::Q_IN, range.speed),
            hopper: HopperSize::read(v)?,
            grab: GrabCycle::read(v)?,
            feeder: HopperFeeder::read(v)?,
            gravity: One(&s::G, gravity),
            command: moves.then(|| FeederCommand { y_f: n(&s::Y_F, 1.0) }),
            passed: moves.then_some(PassedMass {
                m_in: 0.0,
                m_out: 0.0,
                m_s: 0.0,
            }),
            memory: BrimMemory { mode: 0.0 },
        };
        let step = v.of(&s::STEP).unwrap_or(LONGEST * given.grab.t_c);
        let start = [n(&s::M_H, 0.0), n(&s::Q_IN, 0.0)];
        Some((HopperScene { given, start, step }, range))
    }

    fn given(this: &Description<HopperScene>) -> Given<f64> {
        this.given.clone()
    }

    fn levels(&self) -> Vec<&'static str> {
        std::iter::once("static")
            .chain(self.given.command.map(|_| "flow"))
            .collect()
    }

    fn set_level(&mut self, level: &str) {
        if level == "static" {
            (self.given.command, self.given.passed) = (None, None);
        }
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        match level {
            "static" => vec![("hopper", &MOVING), ("dynamics", &[])],
            _ => Vec::new(),
        }
    }

    fn moving(this: &Description<HopperScene>) -> Option<Result<MovingComponent, Fault>> {
        this.given.command?;
        let [contents, into] = this.start;
        let mut begun = this.clone();
        begun.own.given.into.1 = into;
        Some(MovingComponent::new(begun.standing(), |model| {
            Ok(Box::new(SmoothPieces::new(model, &[contents], this.step)?))
        }))
    }

    fn step_by(&mut self, step: f64) {
        self.step = step;
    }

    fn solver(&self) -> Option<Solver> {
        (self.given.command).map(|_| Solver::explicit(&s::STEP, self.step, COST))
    }

    /// The mean flows against cycles of the grab one after the other, and where all that came has gone.
    fn identities(this: &Description<HopperScene>, model: &mut Standing) -> Vec<Check> {
        let (GrabCycle { m_g, t_c, t_d, .. }, q_f) = (this.given.grab, this.given.feeder.q_f);
        let row = sample(model, &[&s::Q_G, &s::D_M], std::iter::once(this.motion.from)).remove(0);
        let cycles = (0..CYCLES).fold(0.0, |sum, _| sum + row[1] - q_f * (t_c - t_d));
        let means = f64::from(CYCLES) * t_c * (row[0] - q_f);
        let passed = f64::from(CYCLES) * (m_g + q_f * t_c);
        let cycles = Check::at_most("hopper_cycles", &s::AGREEMENT, (cycles - means).abs() / passed, 1e-12);
        let mass = balance(this).map(|value| Check::at_most("hopper_mass", &s::AGREEMENT, value, 1e-12));
        std::iter::once(cycles).chain(mass).collect()
    }

    fn assumptions(this: &Description<HopperScene>) -> Vec<&'static str> {
        let level = this
            .given
            .command
            .map_or("hopper_level_static", |_| "hopper_level_flow");
        vec![level, "hopper_bulk"]
    }

    fn uncovered(_: &Description<HopperScene>) -> Vec<&'static str> {
        vec!["hopper_outflow", "strength", "load_cases"]
    }

    /// From the side: the hopper over its feeder, filled to a height by its degree of filling.
    fn drawing(this: &Description<HopperScene>, told: f64) -> Drawing {
        let hopper = &this.given.hopper;
        let size = (hopper.m_max / hopper.rho_b).power([1, 3]);
        let at = |x: f64, y: f64| Point::new(x, y) * size;
        let half = |y: f64| 0.12 + 0.48 * (2.0 * y).min(1.0);
        let mut draw = Draw::default();
        for side in [-1.0, 1.0] {
            draw.bar(&[0.0, 0.5, 1.1].map(|y| at(side * half(y), y)), false);
        }
        let height = |contents: f64| 1.1 * contents / hopper.m_max;
        for (contents, faint) in [(this.motion.from, true), (this.motion.to, true), (told, false)] {
            let y = height(contents);
            draw.bar(&[at(-half(y), y), at(half(y), y)], faint);
        }
        draw.label(at(0.0, 0.5 * height(told)), s::M_H.print);
        draw.arrow(at(0.0, 1.6), at(0.0, 1.25));
        draw.label(at(0.1, 1.5), s::Q_IN.print);
        draw.line(at(-0.9, -0.15), at(0.9, -0.15));
        draw.arrow(at(0.4, -0.08), at(0.8, -0.08));
        draw.label(at(0.6, -0.3), s::Q_F.print);
        draw.done(size)
    }
}

/// How far contents, feeder and spill differ from what was there and came, in the run of the scene, over all of that;
/// `None` of a hopper that stands still.
fn balance(this: &Description<HopperScene>) -> Option<f64> {
    let mut model = this.moving()?.ok()?;
    model.start().ok()?;
    let place = |model: &MovingComponent, symbol| model.variables().iter().position(|known| known.symbol == symbol);
    let masses = [&s::M_H, &s::M_OUT, &s::M_S, &s::M_IN].map(|symbol| place(&model, symbol));
    let end = model.stop_time();
    let (mut first, mut worst) = (None, 0.0_f64);
    for i in 0..=SAMPLES {
        let time = |i: u32| end * f64::from(i) / f64::from(SAMPLES);
        if i > 0 {
            model.advance(time(i - 1), time(i)).ok()?;
        }
        let mut now = [0.0; 4];
        for (mass, index) in now.iter_mut().zip(masses) {
            *mass = model.get(index?).ok()?;
        }
        let [held, out, spilled, into] = now;
        let first = *first.get_or_insert(held);
        worst = worst.max((held + out + spilled - first - into).abs() / (this.given.hopper.m_max + into));
    }
    Some(worst)
}
