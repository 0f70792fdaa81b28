//! What the book tells of the groups in motion: one movement of the running model through its working range, and the
//! equations of one group at one instant of it.

use crate::component::moved::Moved;
use crate::component::moving::MovingComponent;
use crate::component::running::{Running, State};
use crate::component::series::{self, Series};
use crate::component::sheet::{Curve, Energy, Envelope, InMotion, Manoeuvre, Section, Stand, Summary, Warning};
use crate::kernel::calc::Calc;
use crate::kernel::group::Group;
use crate::kernel::record::{Rec, record};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::{Fault, Role};
use crate::parts::hydraulics::oil::VACUUM;
use crate::parts::hydraulics::symbols as h;
use crate::parts::hydraulics::throttle::LAMINAR;
use crate::steering::frame::Ends;
use crate::steering::hydraulic::{CREEP, STATES};
use crate::steering::load::Drag;
use crate::steering::moving::motion::{self, GroupState};
use crate::steering::moving::sampled::{control, in_motion};
use crate::steering::moving::scene::MovingGroups;
use crate::steering::moving::symbols as m;
use crate::steering::scene::Steering;
use crate::steering::stages::SteeredGroups;
use crate::steering::symbols as s;

/// How long the groups are watched after the command has come to rest, in s.
const SETTLING: f64 = 2.0;

/// Samples of the movement, at most, unless one cycle of the PLC each is fewer.
const SAMPLES: f64 = 2000.0;

/// The name of the movement.
const STEER: &str = "steer";

/// A valve's command is restless where it turns round by more than this part of full opening, at more than this part of
/// the samples of the PLC.
const FELT: f64 = 0.01;
const RESTLESS: f64 = 0.5;

/// What is drawn over time, a line for each group: ids of captions.
const DRAWN: [(&str, &Symbol); 6] = [
    ("motion_group_angles", &s::THETA),
    ("motion_group_errors", &m::E),
    ("motion_group_commands", &m::U_V),
    ("motion_group_bores", &m::P_A),
    ("motion_group_annuli", &m::P_B),
    ("motion_group_forces", &m::F_C),
];

/// Least and greatest of all groups.
const DESIGNED: [&Symbol; 7] = [&m::E, &m::U_V, &m::P_A, &m::P_B, &m::F_C, &m::M_R, &m::Q_P];

/// What the formulas of a section give.
const SECTIONS: [(&str, &[&Symbol]); 6] = [
    ("motion_plc", listed! { m: THETA_E, E_E, I_N, U_F, U_N }),
    (
        "motion_oil",
        listed! { h: A_A, A_B, Y_V, Q_1, Q_2, Q_0, Q_LA, Q_LB, Q_R1, Q_R2, Q_LEAK },
    ),
    ("cylinder", listed! { s: CT_X, CT_Y, R, OD, V_C }),
    (
        "motion_pressures",
        &[&h::V_A, &h::V_B, &m::D_P_1, &m::D_P_2, &m::D_P_A, &m::D_P_B, &m::D_V_V],
    ),
    ("motion_resistance", listed! { s: T_R, T_RX, M_F, T_G, T_GX }),
    ("motion_group", listed! { m: F_C, M_R, D_OMEGA_G }),
];

/// What is looked at: where each of some symbols stands among the variables, one for each group.
type Places = Vec<(&'static Symbol, Vec<usize>)>;

fn places(model: &MovingComponent, symbols: &[&'static Symbol]) -> Places {
    let of = |symbol: &&'static Symbol| {
        let known = |role: Role| matches!(role, Role::Output | Role::State | Role::Indicator);
        let all = model.variables().iter().enumerate();
        let found = all.filter(|(_, variable)| variable.symbol == *symbol && known(variable.role));
        (*symbol, found.map(|(index, _)| index).collect())
    };
    symbols.iter().map(of).collect()
}

/// The movement as it ran.
struct Movement {
    series: Series,
    /// The greatest pressure in a chamber (Pa), when (s), in which group, and the model then.
    greatest: (f64, f64, usize),
    state: State,
    /// The least pressure of all oil (Pa), and when (s).
    least: [f64; 2],
}

impl Movement {
    /// From rest at the start of the working range to its end, and on until all has settled.
    fn new(
        this: &Steering,
        model: &mut MovingComponent,
        cycle: f64,
        seen: impl Iterator<Item = usize>,
    ) -> Result<Movement, Fault> {
        let range = &this.motion;
        let whole = range.stop_time() + SETTLING;
        let sample = cycle * (whole / (cycle * SAMPLES)).ceil();
        let ends = places(model, &[&m::Z_MIN, &m::Z_MAX]);
        let between = |model: &mut MovingComponent, number: usize| {
            let clear = |(_, groups): &(_, Vec<usize>)| Ok(model.get(groups[number])? >= 0.0);
            ends.iter().map(clear).collect::<Result<Vec<bool>, Fault>>()
        };
        let chambers = places(model, &[&m::P_A, &m::P_B]);
        let ports = places(model, &[&m::P_1, &m::P_2]);
        let mut series = Series::new(sample, seen);
        series.look(model)?;
        let mut found = Movement {
            series,
            greatest: (f64::NEG_INFINITY, 0.0, 0),
            state: model.state(),
            least: [f64::INFINITY, 0.0],
        };
        for i in 0..(whole / sample).ceil() as u32 {
            let [from, to] = [i, i + 1].map(|number| f64::from(number) * sample);
            let way = (range.to - range.from).signum() * range.speed;
            let part = range.part(range.from + way * from).min(1.0);
            model.set(0, range.at(part))?;
            model.advance(from, to)?;
            found.series.look(model)?;
            for (_, groups) in &chambers {
                for (number, &index) in groups.iter().enumerate() {
                    let pressure = model.get(index)?;
                    if pressure > found.greatest.0 && between(model, number)?.iter().all(|clear| *clear) {
                        (found.greatest, found.state) = ((pressure, to, number), model.state());
                    }
                }
            }
            for &index in chambers.iter().chain(&ports).flat_map(|(_, groups)| groups) {
                let pressure = model.get(index)?;
                if pressure < found.least[0] {
                    found.least = [pressure, to];
                }
            }
        }
        Ok(found)
    }

    /// The command that turns round most often, where that is at most of the samples of the PLC.
    fn restless(&self, cycle: f64, groups: &[usize]) -> Option<Warning> {
        let turns = groups.iter().map(|&index| self.series.turns(index, FELT));
        let (count, [change, at]) = turns.reduce(|a, b| if b.0 > a.0 { b } else { a })?;
        let part = count as f64 * cycle / self.series.duration();
        (self.series.sample == cycle && part > RESTLESS).then(|| Warning {
            id: "restless",
            manoeuvre: Some(STEER),
            summary: Summary {
                at: Some((&m::TAU, at)),
                ..Summary::new(&m::DU_V, change)
            },
            count,
        })
    }

    /// Of all groups.
    fn curve(&self, id: &'static str, y: &'static Symbol, groups: &[usize]) -> Option<Curve> {
        let all = (1..).zip(groups);
        let drawn = all.filter_map(|(number, &index)| Some((number, self.series.piece(index, groups.len())?)));
        let (numbers, pieces): (Vec<usize>, Vec<_>) = drawn.unzip();
        (!pieces.is_empty()).then_some(Curve {
            id,
            x: &m::TAU,
            y,
            pieces,
            numbers,
        })
    }

    fn envelope(&self, symbol: &'static Symbol, groups: &[usize]) -> Option<Envelope> {
        let all: Vec<[Stand; 2]> = groups.iter().map(|&index| self.series.stands(index)).collect();
        let end = |i: usize, sign: f64| {
            let ends = all.iter().map(|ends| ends[i]);
            ends.reduce(|a, b| if sign * b.value > sign * a.value { b } else { a })
        };
        Some(Envelope {
            symbol,
            still: None,
            moving: vec![[end(0, -1.0)?, end(1, 1.0)?]],
        })
    }
}

/// Runs the equations of one group as they are now, between its end stops, and those of a sample of the PLC for an angle
/// wanted (rad), under the recorder. Returns what they begin from besides what is given.
fn recorded(model: &MovingComponent, i: usize, wanted: f64) -> Option<Vec<(&'static Symbol, f64)>> {
    let given = model.standing().of::<SteeredGroups>().given();
    let (mount, plain, step) = (&given.mounts[i], given.moving?, given.accuracy?.step);
    let steps = control(&plain, step).steps(given.moved[i].theta);
    let mut begun = Vec::new();
    let mut begin = |symbol, value| {
        begun.push((symbol, value));
        Rec::given(symbol, value)
    };
    let state: GroupState<Rec> = given.moved[i].map(&mut begin);
    let held = given.held[i].map(&mut begin);
    let [wanted, steps] = [(&m::THETA_W, wanted), (&m::N_E, steps)].map(|(symbol, value)| begin(symbol, value));
    let mut known = |symbol, value| Rec::given(symbol, value);
    let moving = plain.map(&mut known);
    let (mounting, piston) = (given.cylinder?.map(&mut known), given.piston?.map(&mut known));
    let drag = given.tyre.zip(given.loads.get(i)).map(|(tyre, load)| {
        let bearing = given.bearing.map(|bearing| bearing.map(&mut known));
        Drag::new(&tyre.map(&mut known), &bearing, &load.map(&mut known))
    });
    let (speed, drags) = (known(&s::V_T, *given.v_t), drag.map(|drag| vec![drag]));
    // It is between them.
    let ends = Ends([f64::NEG_INFINITY, f64::INFINITY].map(Rec::constant));
    let mut group = Vec::new();
    let linkage = mounting.linkage(mount.mirrored);
    motion::working(
        &moving,
        &[linkage],
        &[ends],
        &mounting,
        &piston,
        drags.as_ref(),
        &speed,
        &[held],
        &mut group,
    );
    // Without loads nothing resists.
    if drags.is_none() {
        group[0].resistance = begin(&s::T_G, 0.0);
    }
    let y: [Rec; STATES] = std::array::from_fn(|k| Group::take(&state, k));
    group[0].equations(&y);
    let plc = control(&moving, known(&s::RESOLUTION, step));
    plc.asked(held.integral, wanted, [y[0], steps], mount.mirrored);
    Some(begun)
}

/// The chapter, with what is warned of; `None` where the movement is refused.
pub fn motion(this: &Steering, moving: &MovingGroups<f64>) -> Option<Moved> {
    let mut model = in_motion(this)?.ok()?;
    let (drawn, designed) = (
        places(&model, &DRAWN.map(|(_, symbol)| symbol)),
        places(&model, &DESIGNED),
    );
    let seen = drawn
        .iter()
        .chain(&designed)
        .flat_map(|(_, groups)| groups.iter().copied());
    let coordinate = model.variables()[0].symbol;
    let found = Movement::new(this, &mut model, moving.t_c, seen).ok()?;
    let (_, instant, group) = found.greatest;
    model.set_state(&found.state);
    let wanted = model.get(places(&model, &[&m::THETA_W])[0].1[group]).ok()?;
    let (trace, told) = record(|| recorded(&model, group, wanted));
    let section = |(id, symbols): (&'static str, &[&Symbol])| {
        let mut trace = trace.clone();
        trace.steps.retain(|step| symbols.contains(&step.symbol));
        Section {
            id,
            trace,
            ..Section::default()
        }
    };
    let sections = SECTIONS.into_iter().map(section);
    let curve =
        |(id, (symbol, groups)): (&'static str, &(&'static Symbol, Vec<usize>))| found.curve(id, symbol, groups);
    let ids = DRAWN.iter().map(|(id, _)| *id);
    let [least, at] = found.least;
    let commands = drawn.iter().find(|(symbol, _)| *symbol == &m::U_V);
    let restless = commands.and_then(|(_, groups)| found.restless(moving.t_c, groups));
    let cavitates = (least < VACUUM).then(|| Warning {
        id: "cavitation",
        manoeuvre: Some(STEER),
        summary: Summary {
            at: Some((&m::TAU, at)),
            ..Summary::new(&m::P_MIN, least)
        },
        count: 1,
    });
    let chapter = InMotion {
        time: &m::TAU,
        coordinate,
        instant: ("greatest_group_pressure", STEER, instant),
        of: Some(group + 1),
        state: told?,
        constants: vec![(&h::DP_LAM, LAMINAR), (&m::OMEGA_C, CREEP)],
        sections: sections.filter(|section| !section.trace.steps.is_empty()).collect(),
        ramp: None,
        rules: vec!["command"],
        envelope: designed
            .iter()
            .filter_map(|(symbol, groups)| found.envelope(symbol, groups))
            .collect(),
        integrals: Vec::new(),
        manoeuvres: vec![Manoeuvre {
            id: STEER,
            start: this.motion.from,
            commands: Vec::new(),
            run: [found.series.duration(), found.series.sample],
            curves: ids.zip(&drawn).filter_map(curve).collect(),
            seen: found.series.frames(&model, &series::seen(&model)),
            events: Vec::new(),
            stop: Vec::new(),
            more_events: 0,
            energy: Energy::default(),
        }],
    };
    Some(Moved {
        chapter,
        requirements: Vec::new(),
        unjudged: Vec::new(),
        identities: Vec::new(),
        warnings: cavitates.into_iter().chain(restless).collect(),
    })
}
