//! The mechanism in motion: the equations at one instant, from the functions that the running model solves, and
//! runs of that model through manoeuvres.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::resume_unwind;
use std::thread::ScopedJoinHandle;

use crate::balance::symbols as b;
use crate::component::running::{Running, State};
use crate::component::sheet::{self, Check, Curve, Envelope, InMotion, Manoeuvre, Section, Stand, Summary, Warning};
use crate::kernel::calc::Calc;
use crate::kernel::record::record;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::{Fault, Role};
use crate::luffing::double_link::hydraulic::FIXED;
use crate::luffing::double_link::moving::level::{Powers, Present};
use crate::luffing::double_link::moving::model::LuffingMotion;
use crate::luffing::double_link::moving::scene::Moving;
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::outline::OUTLINE;
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::sheet::manoeuvres::{Pilot, Planned, at_rest, designed, drawn, planned, rules};
use crate::luffing::double_link::symbols as s;
use crate::parts::hydraulics::oil::VACUUM;
use crate::parts::hydraulics::symbols as h;
use crate::parts::joint::Bar;

/// Points of a drawn curve, besides its extremes.
const CURVE: usize = 300;

/// Samples of a run, at least and at most.
const SAMPLES: [f64; 2] = [2000.0, 20_000.0];

/// How often a sample is halved where oil moves too fast for it, and what may be left over, as a part of the energy
/// that was turned over before and in it.
const HALVINGS: u32 = 6;
const LEFT: f64 = 1e-6;

/// Right-hand sides that a run may cost: for each of its samples, and for each of the longest steps of its solver. A
/// load that a hoist draws to the head turns about it ever faster.
const RATES: [f64; 2] = [200.0, 20.0];

/// How many samples there are for each look at the energy of motion, which is but a size.
const KINETIC: u32 = 16;

/// Events that are listed.
const EVENTS: usize = 20;

/// What the formulas of a section give; those of the assembled model stand among them.
const SECTIONS: [(&str, &[&Symbol]); 9] = [
    (
        "motion_counterweight",
        &[&m::MASS_5, &b::C_5X, &b::C_5Y, &m::DX_5, &m::DY_5, &m::DDX_5, &m::DDY_5],
    ),
    (
        "motion_bodies",
        listed! { m:
            MASS_Q, J_2Q, MASS_1, DX_1, DY_1, DDX_1, DDY_1, DI_1, I_R1, DI_R1, MASS_2, DX_2, DY_2, DDX_2, DDY_2, DI_2,
            I_R2, DI_R2, MASS_3, DX_3, DY_3, DDX_3, DDY_3, DI_3, I_R3, DI_R3, I_R5, DI_R5, I_R, DI_R, M_W, DDA_X, DDA_Y
        },
    ),
    ("motion_slewing", listed! { m: X_S1, X_S2, X_S3, X_S5, I_SL, DI_SL }),
    (
        "motion_oil",
        &[
            &h::A_A,
            &h::A_B,
            &s::V_D,
            &h::Y_V,
            &h::Q_1,
            &h::Q_2,
            &h::Q_LA,
            &h::Q_LB,
            &h::Q_R1,
            &h::Q_R2,
            &h::Q_LEAK,
        ],
    ),
    (
        "motion_pressures",
        &[&h::V_A, &h::V_B, &m::D_P_1, &m::D_P_2, &m::D_P_A, &m::D_P_B, &m::D_V_V],
    ),
    (
        "motion_pendulum",
        listed! { m:
            D_PHI, D_N, Q_A, DD_PHI, M_11, M_12, M_21, M_22, TAU_1, TAU_2
        },
    ),
    (
        "motion_load",
        listed! { m:
            S_Q, N_X, N_Y, N_Z, H_1R, H_2R, V_E, W_X, W_Y, W_Z, R_QX, U_X, U_Y, B_X, B_Y, B_Z
        },
    ),
    (
        "motion_equations",
        listed! { m:
            MASS_H, V_Q, DELTA_R, F_C, M_R, M_R_SL, M_NET, M_NET_SL, ALPHA_0, ALPHA_0SL, A_N, KAPPA_R, A_R, D_OMEGA_1, D_OMEGA_3, D_OMEGA_SL,
            D_OMEGA_R, D_V_QX, D_V_QY, D_V_QZ, D_V_Q, S_R, D_V_R
        },
    ),
    (
        "motion_forces",
        &[
            &m::F_AX,
            &m::F_AY,
            &m::M_RC,
            &m::M_RV,
            &m::M_RS,
            &s::M_D,
            &m::F_5X,
            &m::F_5Y,
            &m::M_I5,
            &m::N_5X,
            &m::N_5Y,
            &b::N_1,
            &m::E_1X,
            &m::E_1Y,
            &b::F_KX,
            &b::F_KY,
            &b::F_MX,
            &b::F_MY,
            &m::F_1X,
            &m::F_1Y,
            &m::F_2X,
            &m::F_2Y,
            &m::F_3X,
            &m::F_3Y,
            &m::J_XY1,
            &m::J_XY2,
            &m::J_XY3,
            &m::M_I1,
            &m::M_I3,
            &m::M_IB,
            &m::M_IC,
            &s::F_BX,
            &s::F_BY,
            &s::F_CX,
            &s::F_CY,
            &m::M_T,
            &s::F_D,
            &s::F_O1X,
            &s::F_O1Y,
            &s::F_O3X,
            &s::F_O3Y,
            &s::N_3,
        ],
    ),
];

/// What is found while the model is assembled, before it moves.
const ASSEMBLED: [&Symbol; 5] = [&m::MASS_Q, &m::J_2Q, &m::MASS_H, &h::A_A, &h::A_B];

/// Events that are warned of.
const WARNED: [&str; 6] = [
    "luffing_low",
    "luffing_high",
    "slewing_low",
    "slewing_high",
    "rope_slack",
    "run_ends",
];

/// What a run says beside its chapter.
pub(super) struct Found {
    pub requirements: Vec<Check>,
    pub unjudged: Vec<&'static Symbol>,
    pub identities: Vec<Check>,
    pub warnings: Vec<Warning>,
}

/// The chapter of a scene whose mechanism moves, with what is judged in it and warned of, beside the least and greatest
/// forces at rest; `None` where the model cannot start.
pub(super) fn motion(luffing: &Luffing, moving: &Moving, still: &[[Summary; 2]]) -> Option<(InMotion, Found)> {
    let (rest, plans) = (at_rest(moving), planned(luffing, moving));
    let mut model = LuffingMotion::starting(luffing, &rest, plans.first()?.start).ok()?;
    let [coordinate, rate] = [0, 1].map(|index| model.variables()[index].symbol);
    let instant = match (moving.oil, moving.rope) {
        (Some(_), _) => ("greatest_pressure", &m::P_A),
        (None, Some(_)) => ("greatest_rope_force", &m::S_R),
        (None, None) => ("greatest_speed", rate),
    };
    let designed = designed(OUTLINE.forces, &model);
    let run = |plan| ran(luffing, moving, &rest, plan, instant.1, &designed);
    let ran = std::thread::scope(|scope| {
        let threads: Vec<_> = plans.iter().map(|plan| scope.spawn(|| run(plan))).collect();
        let ended = threads.into_iter().map(ScopedJoinHandle::join);
        ended
            .map(|ran| ran.unwrap_or_else(|panic| resume_unwind(panic)))
            .collect::<Option<Vec<_>>>()
    });
    let (manoeuvres, runs): (Vec<_>, Vec<_>) = ran?.into_iter().unzip();
    let (of, shown) = runs
        .iter()
        .enumerate()
        .max_by(|(_, a), (_, b)| a.most.total_cmp(&b.most))?;
    model.set_state(&shown.state);
    // A taut rope is straight: at the end of a step it is off by rounding.
    let mut states = vec![0.0; model.states()];
    model.get_states(&mut states);
    model.set_states(&states).ok()?;
    model.update().ok()?;
    let envelope = |&(symbol, index): &(&'static Symbol, usize)| {
        let at_rest = still.iter().find(|ends| ends[0].symbol == symbol).copied();
        Envelope {
            symbol,
            still: match luffing.q.filter(|_| symbol == &m::S_R) {
                Some(weight) => Some([Summary::new(symbol, weight); 2]),
                None => at_rest,
            },
            moving: runs.iter().map(|run| run.stands(index)).collect(),
        }
    };
    let motion = InMotion {
        time: &m::T,
        coordinate,
        instant: (instant.0, manoeuvres[of].id, shown.instant),
        of: None,
        state: state(&mut model),
        sections: sections(&model),
        ramp: (&m::T_S, moving.ramp),
        rules: rules(moving),
        envelope: designed.iter().map(envelope).collect(),
        manoeuvres,
    };
    let found = Found::new(luffing, moving, &motion.manoeuvres, &runs);
    Some((motion, found))
}

/// One of them, with what is told of it; `lead` says which instant is shown.
fn ran(
    luffing: &Luffing,
    moving: &Moving,
    rest: &Moving,
    plan: &Planned,
    lead: &Symbol,
    designed: &[(&'static Symbol, usize)],
) -> Option<(Manoeuvre, Run)> {
    let mut model = LuffingMotion::starting(luffing, rest, plan.start).ok()?;
    let mut pilot = Pilot::new(plan, luffing, moving, &model)?;
    let drawn = drawn(plan, &model);
    let lead = model.variables().iter().position(|variable| variable.symbol == lead)?;
    let seen = [0, lead].into_iter().chain(drawn.iter().map(|(_, index)| *index));
    let seen = seen.chain(designed.iter().map(|(_, index)| *index)).collect();
    let run = Run::new(luffing, rest, &mut model, (lead, &seen), &mut pilot)?;
    let symbol = |index: usize| model.variables()[index].symbol;
    let manoeuvre = Manoeuvre {
        id: plan.id,
        start: plan.start,
        commands: pilot
            .told
            .into_iter()
            .map(|(index, table)| (symbol(index), table))
            .collect(),
        run: [run.duration(), run.sample],
        curves: drawn
            .iter()
            .filter_map(|&(id, index)| run.curve(id, symbol(index), index))
            .collect(),
        events: run.listed(),
        more_events: run.events.len().saturating_sub(EVENTS),
        energy: run.energy.list(moving),
    };
    Some((manoeuvre, run))
}

/// States and commands as they are now, without those of the position alone.
fn state(model: &mut LuffingMotion) -> Vec<(&'static Symbol, f64)> {
    let indices = |role: Role| {
        let all = model.variables().iter().enumerate();
        let of = all.filter(move |(_, variable)| variable.role == role);
        of.map(|(index, variable)| (index, variable.symbol)).collect::<Vec<_>>()
    };
    let listed: Vec<_> = indices(Role::State).into_iter().chain(indices(Role::Input)).collect();
    listed
        .into_iter()
        .filter_map(|(index, symbol)| Some((symbol, model.get(index).ok()?)))
        .filter(|(symbol, _)| {
            !s::ALL.contains(symbol) || [&s::THETA_1, &s::OMEGA_1, &s::THETA_3, &s::OMEGA_3].contains(symbol)
        })
        .collect()
}

/// The equations at the model's instant. Each section is recorded from the start and shows its own steps.
fn sections(model: &LuffingMotion) -> Vec<Section> {
    let section = |(id, symbols): (&'static str, &[&Symbol])| {
        let (mut trace, assembled) = record(|| model.recorded());
        let mut seen: Vec<&Symbol> = Vec::new();
        let mut index = 0;
        trace.steps.retain(|step| {
            let early = index < assembled;
            index += 1;
            let wanted = symbols.contains(&step.symbol) && (!early || ASSEMBLED.contains(&step.symbol));
            let first = wanted && !seen.contains(&step.symbol);
            if first {
                seen.push(step.symbol);
            }
            first
        });
        Section {
            id,
            trace,
            ..Section::default()
        }
    };
    SECTIONS
        .into_iter()
        .map(section)
        .filter(|section| !section.trace.steps.is_empty())
        .collect()
}

/// What changes at an event.
#[derive(Clone, PartialEq)]
struct Watch {
    /// Luffing, slewing and the hoist's drum; `None` where there is none of them, or none that sticks.
    joints: [Option<Bar>; 3],
    /// At the lower and the upper stop, and beyond it after the next sample if it went on like this.
    stops: [[bool; 2]; 3],
    ahead: [[bool; 2]; 3],
    taut: bool,
    relief: [bool; 2],
}

impl Watch {
    /// With the time between two samples, in s.
    fn new(luffing: &Luffing, moving: &Moving, present: &Present, sample: f64) -> Watch {
        let y = present.states();
        let opening = moving.oil.map_or(f64::INFINITY, |oil| oil.p_r);
        let at = |x: f64, [low, high]: [f64; 2]| [x <= low, x >= high];
        let ends = [luffing.motion.from, luffing.motion.to];
        let turns = moving
            .slewing
            .map_or([f64::NEG_INFINITY, f64::INFINITY], |turn| turn.joint.stops);
        let mut watch = Watch {
            joints: [None, None, moving.has_motor().then(|| present.drum().way)],
            stops: [at(y[0], ends), [false; 2], [false; 2]],
            ahead: [at(y[0] + y[1] * sample, ends), [false; 2], [false; 2]],
            taut: true,
            relief: [false; 2],
        };
        match present {
            Present::Free(state) => {
                watch.joints[0] = Some(state.joints[0]);
                watch.taut = state.taut;
            }
            Present::Slewing(state) => {
                [watch.joints[0], watch.joints[1]] = state.joints.map(Some);
                watch.taut = state.taut;
                watch.stops[1] = at(y[2], turns);
                watch.ahead[1] = at(y[2] + y[3] * sample, turns);
            }
            Present::Fixed(_) => watch.relief = [y[2] > opening, y[3] > opening],
            Present::Hanging(now) => {
                watch.relief = [y[2] > opening, y[3] > opening];
                watch.taut = now.modes.taut;
                if moving.slewing.is_some() {
                    watch.joints[1] = Some(now.modes.slewing);
                    watch.stops[1] = at(y[FIXED], turns);
                    watch.ahead[1] = at(y[FIXED] + y[FIXED + 1] * sample, turns);
                }
            }
        }
        watch
    }

    /// What has happened since.
    fn since(&self, before: &Watch) -> Vec<&'static str> {
        let mut found = Vec::new();
        let names = [
            ["luffing_starts", "luffing_rests", "luffing_low", "luffing_high"],
            ["slewing_starts", "slewing_rests", "slewing_low", "slewing_high"],
            // A drum has no stops.
            ["hoist_starts", "hoist_rests", "", ""],
        ];
        for (i, [starts, rests, low, high]) in names.into_iter().enumerate() {
            // What turns round on the way to a stop has met it.
            let turned = matches!(
                (before.joints[i], self.joints[i]),
                (Some(Bar::Forward), Some(Bar::Backward)) | (Some(Bar::Backward), Some(Bar::Forward))
            );
            let met = [0, 1].map(|end| {
                let there = self.stops[i][end] || turned && before.ahead[i][end];
                there && !before.stops[i][end]
            });
            let stopped = match met {
                [true, _] => Some(low),
                [_, true] => Some(high),
                _ => None,
            };
            match (before.joints[i], self.joints[i]) {
                (Some(Bar::Held), Some(Bar::Forward | Bar::Backward)) => found.push(starts),
                (Some(Bar::Forward | Bar::Backward), Some(Bar::Held)) => found.push(stopped.unwrap_or(rests)),
                (None, None) => found.extend(stopped),
                _ if turned => found.extend(stopped),
                _ => {}
            }
        }
        let switches = [
            (before.taut, self.taut, "rope_taut", "rope_slack"),
            (before.relief[0], self.relief[0], "relief_1_opens", "relief_1_closes"),
            (before.relief[1], self.relief[1], "relief_2_opens", "relief_2_closes"),
        ];
        for (before, now, on, off) in switches {
            if before != now {
                found.push(if now { on } else { off });
            }
        }
        found
    }
}

/// Where energy came from and went, in J.
#[derive(Default)]
struct Energy {
    start: f64,
    end: f64,
    work: Powers,
    blows: f64,
    rest: f64,
    /// How much of the rest rounding may be: all of it where nothing moves.
    rounding: f64,
    /// Of the bodies' motion, at most: a load that swings by itself turns over nothing else.
    kinetic: f64,
}

impl Energy {
    /// A step of the run to a next energy (J), with what blows have taken.
    fn add(&mut self, step: &Powers, after: f64) {
        self.rest += net(step) - (after - self.end);
        self.rounding += rounding(self.end, after);
        self.end = after;
        self.work = sum(&[(&self.work, 1.0), (step, 1.0)]);
    }

    fn list(&self, moving: &Moving) -> sheet::Energy {
        let (oil, work) = (moving.oil.is_some(), &self.work);
        let (slews, hangs) = (moving.slewing.is_some(), moving.rope.is_some());
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
            ]),
            stored: there(&[
                (true, &m::DELTA_E, self.end - self.start - self.blows),
                (oil, &m::E_OIL, work.compression),
            ]),
            taken: there(&[
                (true, &m::W_R, work.friction),
                (oil, &m::W_T, work.throttles),
                (!oil || slews || hangs, &m::W_BLOW, self.blows),
                (true, &m::W_E, self.rest),
            ]),
        }
    }
}

/// What is left of the powers for the bodies.
fn net(p: &Powers) -> f64 {
    p.drive + p.slewing + p.hoist + p.pump - p.friction - p.throttles - p.compression
}

/// What rounding may leave between two energies.
fn rounding(before: f64, after: f64) -> f64 {
    f64::EPSILON * (before.abs() + after.abs())
}

/// What was given and taken.
fn turnover(work: &Powers) -> f64 {
    let given = work.pump.abs() + work.slewing.abs() + work.hoist.abs();
    given + work.throttles + work.friction + work.compression.abs()
}

/// Powers, each times a number.
fn sum(parts: &[(&Powers, f64)]) -> Powers {
    let of = |power: fn(&Powers) -> f64| parts.iter().map(|(powers, factor)| power(powers) * factor).sum();
    Powers {
        drive: of(|p| p.drive),
        slewing: of(|p| p.slewing),
        hoist: of(|p| p.hoist),
        pump: of(|p| p.pump),
        friction: of(|p| p.friction),
        throttles: of(|p| p.throttles),
        compression: of(|p| p.compression),
    }
}

/// What a run may cost: halvings from now on, without which what is left over goes to the energy's rest, which is
/// checked; and right-hand sides since the model is there, without which the run ends.
struct Budget {
    halvings: u32,
    rates: f64,
}

/// Moves the model on and returns the works on the way, with powers and energy (J) at its end.
fn advance(
    model: &mut LuffingMotion,
    [from, to]: [f64; 2],
    before: &(Powers, f64),
    turned_over: f64,
    halvings: u32,
    budget: &mut Budget,
) -> Option<(Powers, (Powers, f64))> {
    if f64::from(model.count().rates) > budget.rates {
        return None;
    }
    let (start, time) = (model.state(), to - from);
    let middle = f64::midpoint(from, to);
    if halvings == 0 {
        model.advance(from, to).ok()?;
        let after = model.powers().ok()?;
        return Some((sum(&[(&before.0, 0.5 * time), (&after.0, 0.5 * time)]), after));
    }
    model.advance(from, middle).ok()?;
    let half = model.powers().ok()?;
    model.advance(middle, to).ok()?;
    let after = model.powers().ok()?;
    let weights = [(&before.0, time / 6.0), (&half.0, time / 1.5), (&after.0, time / 6.0)];
    let (work, gain) = (sum(&weights), after.1 - before.1);
    let left = (net(&work) - gain).abs();
    let found = left <= LEFT * (turned_over + turnover(&work)) + rounding(before.1, after.1);
    if found || budget.halvings == 0 {
        return Some((work, after));
    }
    budget.halvings -= 1;
    model.set_state(&start);
    let (first, half) = advance(model, [from, middle], before, turned_over, halvings - 1, budget)?;
    let (second, after) = advance(model, [middle, to], &half, turned_over, halvings - 1, budget)?;
    Some((sum(&[(&first, 1.0), (&second, 1.0)]), after))
}

/// The same, where blows make the powers jump within the step, or a rope that gives way (`lively`) makes them swing: their
/// works are looked at more closely, and the model moves as it does without that.
fn stepped(
    model: &mut LuffingMotion,
    times: [f64; 2],
    before: &(Powers, f64),
    turned_over: f64,
    halvings: u32,
    (budget, lively): (&mut Budget, bool),
) -> Option<(Powers, (Powers, f64))> {
    let (start, blown) = (model.state(), model.present().blown());
    let (work, after) = advance(model, times, before, turned_over, halvings, budget)?;
    if halvings > 0 || model.present().blown() == blown && !lively {
        return Some((work, after));
    }
    let end = model.state();
    model.set_state(&start);
    let (work, _) = advance(model, times, before, turned_over, HALVINGS, budget)?;
    model.set_state(&end);
    Some((work, after))
}

/// A run of the model, sampled.
struct Run {
    sample: f64,
    /// Of each variable that is looked at, by its index.
    series: BTreeMap<usize, Vec<f64>>,
    events: Vec<(f64, &'static str)>,
    energy: Energy,
    /// When what leads is greatest while luffing moves, how great (zero where it never moves), and the model then.
    instant: f64,
    most: f64,
    state: State,
    /// Each with its time, in s.
    greatest_pressure: [f64; 2],
    least_pressure: [f64; 2],
    greatest_swing: [f64; 2],
    /// Of the moment on the driving link by the moving bodies' equilibrium from that of drive, friction and stop, at most,
    /// and the greatest of those moments (N·m).
    apart: [f64; 2],
}

impl Run {
    /// Looks at variables by their indices, one of which leads.
    fn new(
        luffing: &Luffing,
        moving: &Moving,
        model: &mut LuffingMotion,
        (lead, seen): (usize, &BTreeSet<usize>),
        pilot: &mut Pilot<'_>,
    ) -> Option<Run> {
        let (duration, step) = (pilot.duration(), moving.constants.step);
        let wanted = (duration / step).ceil();
        // Whole parts, or multiples, of the solver's longest step.
        let sample = match wanted {
            few if few < SAMPLES[0] => step / (SAMPLES[0] / wanted).ceil(),
            many => step * (many / SAMPLES[1]).ceil(),
        };
        let samples = (duration / sample).ceil() as u32;
        let look = |model: &mut LuffingMotion| {
            let values = seen.iter().map(|&index| Ok((index, model.get(index)?)));
            values.collect::<Result<BTreeMap<usize, f64>, Fault>>().ok()
        };
        // With nothing told the crane was about to sag: braked it is at rest, and what holds it can be told.
        for _ in 0..2 {
            pilot.tell(model, [0.0, sample]).ok()?;
            model.update().ok()?;
        }
        let (first, mut powers) = (look(model)?, model.powers().ok()?);
        let lively = moving.rope.is_some_and(|rope| rope.give.is_some());
        let mut budget = Budget {
            halvings: samples,
            rates: RATES[0] * f64::from(samples) + RATES[1] * wanted,
        };
        let mut run = Run {
            sample,
            series: first.iter().map(|(&index, &value)| (index, vec![value])).collect(),
            events: Vec::new(),
            energy: Energy {
                start: powers.1,
                end: powers.1,
                ..Energy::default()
            },
            instant: 0.0,
            most: 0.0,
            state: model.state(),
            greatest_pressure: [pressure(model.present()), 0.0],
            least_pressure: [model.present().least_pressure(), 0.0],
            greatest_swing: [swing(moving, model.present()), 0.0],
            apart: [0.0; 2],
        };
        let mut watch = Watch::new(luffing, moving, model.present(), sample);
        // The crane was at rest before.
        let rest = Watch {
            joints: watch.joints.map(|joint| joint.map(|_| Bar::Held)),
            ..watch.clone()
        };
        run.events.extend(watch.since(&rest).into_iter().map(|id| (0.0, id)));
        for i in 0..samples {
            let (from, to) = (f64::from(i) * sample, f64::from(i + 1) * sample);
            if i > 0 {
                // Nothing is told that the model refuses: what it refuses next ends the run.
                let _ = pilot.tell(model, [from, to]);
                powers = model.powers().ok()?;
            }
            let turned_over = turnover(&run.energy.work);
            let step = stepped(model, [from, to], &powers, turned_over, HALVINGS, (&mut budget, lively));
            let Some(((work, now), values)) = step.zip(look(model)) else {
                run.events.push((from, "run_ends"));
                break;
            };
            let next = Watch::new(luffing, moving, model.present(), sample);
            let events = next.since(&watch);
            run.energy.add(&work, now.1);
            run.energy.blows = model.present().blown();
            if i % KINETIC == 0 {
                run.energy.kinetic = run.energy.kinetic.max(model.kinetic().ok()?);
                if let Some(apart) = model.apart() {
                    run.apart = [0, 1].map(|k| run.apart[k].max(apart[k]));
                }
            }
            run.events.extend(events.into_iter().map(|id| (to, id)));
            (watch, powers) = (next, now);
            // Where luffing is held it has no equation, and at a stop it tells little.
            let moves = watch.joints[0] != Some(Bar::Held) && !(moving.oil.is_some() && watch.stops[0] != [false; 2]);
            if moves && values[&lead].abs() > run.most {
                (run.most, run.instant, run.state) = (values[&lead].abs(), to, model.state());
            }
            run.keep(moving, model.present(), values, to);
        }
        Some(run)
    }

    /// What is looked at, at a time (s).
    fn keep(&mut self, moving: &Moving, present: &Present, values: BTreeMap<usize, f64>, time: f64) {
        greater(&mut self.greatest_pressure, pressure(present), time);
        greater(&mut self.greatest_swing, swing(moving, present), time);
        let least = present.least_pressure();
        if least < self.least_pressure[0] {
            self.least_pressure = [least, time];
        }
        for (index, value) in values {
            self.series.entry(index).or_default().push(value);
        }
    }

    fn duration(&self) -> f64 {
        self.sample * (self.series[&0].len() - 1) as f64
    }

    /// Places of the least and of the greatest value.
    fn ends(series: &[f64]) -> [usize; 2] {
        [-1.0, 1.0].map(|sign: f64| {
            let places = 0..series.len();
            let best = places.reduce(|a, b| if sign * series[b] > sign * series[a] { b } else { a });
            best.expect("a run has its start")
        })
    }

    /// Least and greatest value of a variable, each with its time and where the driven bar is then.
    fn stands(&self, index: usize) -> [Stand; 2] {
        let series = &self.series[&index];
        Run::ends(series).map(|i| Stand {
            value: series[i],
            time: i as f64 * self.sample,
            at: self.series[&0][i],
        })
    }

    /// Of a variable over time, where it does not stay as it was.
    fn curve(&self, id: &'static str, y: &'static Symbol, index: usize) -> Option<Curve> {
        let series = &self.series[&index];
        if series.iter().all(|value| *value == series[0]) {
            return None;
        }
        let ([least, most], last) = (Run::ends(series), series.len() - 1);
        let stride = (last / CURVE).max(1);
        let shown = (0..=last).filter(|&i| i % stride == 0 || [last, least, most].contains(&i));
        Some(Curve {
            id,
            x: &m::T,
            y,
            pieces: vec![shown.map(|i| [i as f64 * self.sample, series[i]]).collect()],
            numbers: Vec::new(),
        })
    }

    /// The first events, and the last one, which may be the end of the run.
    fn listed(&self) -> Vec<(f64, &'static str)> {
        let mut listed = self.events.clone();
        if listed.len() > EVENTS {
            listed.drain(EVENTS - 1..listed.len() - 1);
        }
        listed
    }

    /// What happened that must not be overlooked: when first, and how often.
    fn warnings(&self, manoeuvre: &'static str) -> Vec<Warning> {
        let warning = |id, summary, count| Warning {
            id,
            manoeuvre: Some(manoeuvre),
            summary,
            count,
        };
        let happened = WARNED.into_iter().filter_map(|id| {
            let mut times = self.events.iter().filter(|(_, event)| *event == id);
            let (at, _) = times.next()?;
            Some(warning(id, Summary::new(&m::T, *at), 1 + times.count()))
        });
        let cavitates = self.least_pressure[0] < VACUUM;
        let oil = cavitates.then(|| warning("cavitation", timed(&m::P_MIN, self.least_pressure), 1));
        happened.chain(oil).collect()
    }

    /// How far apart two ways to one moment are, and how much energy is left over, relative.
    fn apart(&self) -> [f64; 2] {
        let [apart, greatest] = self.apart;
        let Powers {
            drive,
            slewing,
            hoist,
            pump,
            friction,
            throttles,
            ..
        } = self.energy.work;
        let amounts = [
            drive,
            slewing,
            hoist,
            pump,
            friction,
            throttles,
            self.energy.end - self.energy.start,
            self.energy.kinetic,
        ];
        let scale = amounts.into_iter().map(f64::abs).fold(f64::MIN_POSITIVE, f64::max);
        let rest = (self.energy.rest.abs() - self.energy.rounding).max(0.0);
        [if greatest > 0.0 { apart / greatest } else { 0.0 }, rest / scale]
    }
}

fn timed(symbol: &'static Symbol, [value, at]: [f64; 2]) -> Summary {
    Summary {
        at: Some((&m::T, at)),
        ..Summary::new(symbol, value)
    }
}

impl Found {
    /// Of all runs, each of a manoeuvre.
    fn new(luffing: &Luffing, moving: &Moving, manoeuvres: &[Manoeuvre], runs: &[Run]) -> Found {
        let most = |of: fn(&Run) -> [f64; 2]| {
            runs.iter()
                .map(of)
                .fold([0.0; 2], |a, b| if b[0] > a[0] { b } else { a })
        };
        let swing = moving.rope.map(|_| timed(&m::PHI_MAX, most(|run| run.greatest_swing)));
        let allowed = luffing.limit(&m::PHI_MAX);
        let pressure = timed(&m::P_MAX, most(|run| run.greatest_pressure));
        let asked = [
            swing.zip(allowed).map(|(swing, most)| ("motion_swing", swing, most)),
            moving.oil.map(|oil| ("motion_pressure", pressure, oil.p_r)),
        ];
        let checked = asked.iter().flatten();
        let named = runs.iter().zip(manoeuvres);
        let apart = |i: usize| runs.iter().map(|run| run.apart()[i]).fold(0.0, f64::max);
        let agree = |id, i, limit| Check::at_most(id, &s::AGREEMENT, apart(i), limit);
        Found {
            requirements: checked
                .map(|(id, found, limit)| Check::of(id, found, *limit, true))
                .collect(),
            unjudged: swing
                .filter(|_| allowed.is_none())
                .map(|swing| swing.symbol)
                .into_iter()
                .collect(),
            identities: vec![agree("motion_forces", 0, 1e-9), agree("motion_energy", 1, 1e-3)],
            warnings: named.flat_map(|(run, manoeuvre)| run.warnings(manoeuvre.id)).collect(),
        }
    }
}

/// Keeps what is greater, with its time (s).
fn greater(kept: &mut [f64; 2], value: f64, time: f64) {
    if value > kept[0] {
        *kept = [value, time];
    }
}

/// Greatest pressure of the oil, in Pa; zero without oil.
fn pressure(present: &Present) -> f64 {
    let y = present.states();
    let pressures = match present {
        Present::Fixed(_) | Present::Hanging(_) => &y[2..FIXED - 2],
        Present::Free(_) | Present::Slewing(_) => &[],
    };
    pressures.iter().copied().fold(0.0, f64::max)
}

/// Angle of the rope from the vertical, in rad; zero without a rope.
fn swing(moving: &Moving, present: &Present) -> f64 {
    if moving.rope.is_none() {
        return 0.0;
    }
    let y = present.states();
    // The crane's own states but for its first two.
    let own = match present {
        Present::Fixed(_) | Present::Hanging(_) => &y[FIXED..],
        Present::Free(_) | Present::Slewing(_) => &y[2..],
    };
    match moving.slewing {
        None => own[0].abs(),
        Some(_) => f64::direction(-own[3], (own[2] * own[2] + own[4] * own[4]).sqrt()),
    }
}
