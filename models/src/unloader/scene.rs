//! A grab unloader as scenes describe it and books tell it.

use std::f64::consts::TAU;

use crate::component::description::{Described, Description, Vocabulary, possible};
use crate::component::draw::Draw;
use crate::component::mechanism::{Entry, Solver};
use crate::component::moving::MovingComponent;
use crate::component::moving::smooth::SmoothPieces;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Drawing, Input, Sheet};
use crate::component::stages::Stages;
use crate::component::standing::Standing;
use crate::component::telling::{fine, numbered, sample};
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Kind, Values};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::hanging;
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::sway::pendulum::{self, Feedback, SwayingLoad};
use crate::sway::scene::arrange;
use crate::unloader::cycle::GrabPhase;
use crate::unloader::motors::DynamicFactor;
use crate::unloader::outline::OUTLINE;
use crate::unloader::paths::{LONGEST, MOVING, moves, ways};
use crate::unloader::planetary::PlanetarySet;
use crate::unloader::reeving::{Reeving, SCHEMES, Scheme};
use crate::unloader::ropes::{RopeDrum, SlackRope};
use crate::unloader::stages::{Given, GrabUnloader};
use crate::unloader::sway::{GrabPlace, GrabWay};
use crate::unloader::symbols as s;
use crate::unloader::tables::{DRUMS, apart_of, each, modes};
use crate::unloader::trolley::{AuxiliaryRope, AuxiliaryTrolley, GrabCommand, GrabTrolley};

/// Fewest phases of a cycle: a grab closes, rises and travels, empties itself, comes back; and the most.
const PHASES: [usize; 2] = [4, 32];

/// Numbered results that the book shows of all phases, of all drums, and of their differentials.
const PHASE_COLUMNS: &[&Symbol] = listed!(s: W_P, T_1P, T_2P, S_HP, S_CP, NU_P, P_HP, P_CP, P_TP, T_HP, T_CP, T_TP);
const DRUM_COLUMNS: &[&Symbol] = listed!(s: V_R, N_D, S_R, F_I, M_D, P_D);
const SET_COLUMNS: &[&Symbol] = listed!(s: N_S, N_R, N_D, T_S, T_R, P_S, P_R, P_D, N_DS, N_DR);

/// Keys of `[grab_unloader]`.
pub const KEYS: &[Key] = keys! { s:
    G_G > 0 [or_mass], Q_N > 0 [or_mass], G_T > 0 [or_mass], V_H [over_time, usually(0.0)], V_C [usually(0.0)], K_Q >= 0 [usually(1.0)],
    LAMBDA_C >= 0 [usually(0.5)], MU_T >= 0 [usually(0.008)], P_W >= 0 [usually(0.0)], A_W >= 0 [usually(0.0)],
    ETA_R > 0 [usually(0.98)], ETA_D > 0 [usually(1.0)], PHI_2_MIN > 0 [usually(1.1)], BETA_2 >= 0 [usually(0.34)],
    T_0 > 0 [optional], G_A > 0 [or_mass, optional], F_BA > 0 [optional], Z_A > 0 [optional], K > 0 [optional], K_B > 0 [optional], A_T [over_time, optional],
    X_T [optional], PHI_R [optional], ZETA_F >= 0 [optional];
    Key::new(
        "scheme",
        Kind::Choice(&SCHEMES),
        "How the ropes are led: \"planetary\" (the grab's ropes pull the trolley, each drum by a differential), \"simple\" (the \
         drums go with the trolley), \"auxiliary_trolley\" (one at half the speed keeps the length of the ropes), \
         \"middle_drum\" (the trolley's drum does).",
    ),
    Key::choice(
        "fidelity",
        &["static", "swing"],
        "How deep the unloader is modelled: \"static\" (the speed of the trolley is an input, the grab hangs straight down), \
         \"swing\" (the trolley follows its acceleration, and its grab sways).",
    ),
    Key::part("way", WAY, "The way of the trolley from ship to hopper, on which the grab sways."),
    Key::part("dynamics", DYNAMICS, "How the motion is solved."),
    Key::new("sheaves", Kind::Count([1, 12]), "Sheaves that a rope of the grab passes as the trolley travels."),
    Key::new("drums", Kind::Tables(DRUM, DRUMS), "The drums; planetary: hoisting sea side, hoisting land side, closing sea side, closing land side; else hoisting, closing, trolley."),
    Key::new("phases", Kind::Tables(PHASE, PHASES[1]), "The phases of a cycle, one after the other."),
    Key::table("motion", MOTION, "Working range of the trolley's speed."),
    Key::part("limits", LIMITS, "What results may come to at most, or at least.")
};

static WAY: &[Key] = keys! { s: L_R > 0, V_M > 0, A_M > 0, S_M > 0 };
static DYNAMICS: &[Key] = keys! { s: STEP > 0 };
static DRUM: &[Key] = keys! { s: D_D > 0, Z_R > 0 [usually(1.0)], F_B > 0 };
static PHASE: &[Key] = keys! { s:
    T_P > 0, V_HP [usually(0.0)], V_CP [usually(0.0)], V_TP [usually(0.0)], A_TP [usually(0.0)], K_QP >= 0, LAMBDA_P >= 0 [usually(0.5)]
};
const MOTION: &[Key] = &Motion::keys(
    [&s::FROM, &s::TO],
    &s::V_T,
    (
        &s::A_T,
        "Acceleration of the trolley to the sea side, with which it passes through the working range.",
    ),
);
const LIMITS: &[Key] = &Limit::keys::<6>(OUTLINE.limits);

/// What the rates cost, in s.
const COST: [f64; 2] = [0.15e-6, 0.0];

/// Ropes that are longer than thought, over those.
const LONGER: f64 = 1.1;

/// A grab unloader as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct UnloaderScene {
    /// At the start of the working range.
    given: Given<f64>,
    /// Speed (m/s) and place (m) of the trolley, sway (rad), its rate (rad/s) and length of the ropes (m) at the start of its motion.
    start: [f64; 5],
    /// Acceleration that the trolley is told at the start of its motion, in m/s².
    told: f64,
    /// Longest step of the solver, in s.
    step: f64,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<UnloaderScene>::entry("grab_unloader", KEYS);

/// Quantities of some schemes: whether this one needs them, and whether it has a use for them.
fn needs(scheme: Scheme) -> [(&'static Symbol, [bool; 2]); 6] {
    let (planetary, auxiliary) = (scheme == Scheme::Planetary, scheme == Scheme::AuxiliaryTrolley);
    [
        (&s::K, [planetary; 2]),
        (&s::K_B, [planetary; 2]),
        (&s::T_0, [!planetary; 2]),
        (&s::G_A, [auxiliary; 2]),
        (&s::F_BA, [false, auxiliary]),
        (&s::Z_A, [false, auxiliary]),
    ]
}

/// Refuses what the scheme has no use for or lacks, drums and ropes that are none, a cycle that is none, and a grab that opens
/// over the way.
fn suits(v: &Values, scheme: Scheme, found: &mut Vec<Diagnostic>) {
    let name = v.text("scheme").unwrap_or_default();
    // What could not be read is not missing.
    let read = found.is_empty();
    for (symbol, [needed, used]) in needs(scheme) {
        let id = symbol.id;
        match (needed, used, v.has(id)) {
            (true, _, false) if read => {
                let what = format!("`{id}` is missing of scheme = \"{name}\"");
                found.push(v.refuse(
                    "scheme",
                    what,
                    format!("needs {id}"),
                    format!("add {id}: {}", symbol.text),
                ));
            }
            (_, false, true) => {
                let what = format!("`{id}` of scheme = \"{name}\"");
                found.push(v.refuse(id, what, "not used", "remove it, or choose another scheme"));
            }
            _ => {}
        }
    }
    let drums = v.tables("drums");
    if drums.len() != scheme.drums() {
        let what = format!("{} drums of scheme = \"{name}\"", drums.len());
        let label = format!("not {}", scheme.drums());
        let help = match scheme {
            Scheme::Planetary => {
                "give four: hoisting sea side, hoisting land side, closing sea side, closing land side"
            }
            _ => "give three: hoisting, closing, trolley",
        };
        found.push(v.refuse("drums", what, label, help));
    }
    found.extend(drums.iter().filter_map(|drum| drum.broken(&s::Z_R)));
    found.extend(v.broken(&s::Z_A));
    if v.has(s::Z_A.id) && !v.has(s::F_BA.id) {
        let help = "add F_ba, the least breaking force of one, or remove it";
        found.push(v.refuse(s::Z_A.id, "`z_a` without `F_ba`", "of ropes that are not judged", help));
    }
    let phases = v.tables("phases");
    if phases.len() < PHASES[0] {
        let what = format!("a cycle of {} phases", phases.len());
        let label = format!("fewer than {}", PHASES[0]);
        let help = "give at least closing, the way there, emptying, the way back";
        found.push(v.refuse("phases", what, label, help));
    }
    for phase in phases {
        let read = GrabPhase::read(phase);
        if let Some(it) = read.filter(|it| it.v_c < 0.0 && it.k_q > 0.0 && it.v_t != 0.0) {
            let what = format!(
                "the grab opens with v_cp = {} and contents of {} while the trolley travels with v_tp = {}",
                s::V_CP.written(it.v_c),
                s::K_QP.written(it.k_q),
                s::V_TP.written(it.v_t)
            );
            let help = "open it where the trolley stands (v_tp = \"0 m/s\"), or without contents (k_qp = \"0 %\")";
            found.push(phase.refuse(s::V_CP.id, what, "it loses its contents on the way", help));
        }
    }
}

impl Described for UnloaderScene {
    type Component = GrabUnloader;
    const ID: &'static str = "unloader";
    const TABLE: &'static str = "grab_unloader";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = listed!(s: X_L, Y_Q, A_L);
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "unloader_symbol",
        own: &[s::ALL, pendulum::ALL],
        shared: &[hanging::ALL, gravity::ALL],
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(UnloaderScene, Motion)> {
        let before = found.len();
        let range = Motion::read(v.table("motion")?, found)?;
        let name = v.text("scheme")?;
        let scheme = Scheme::ALL[SCHEMES.iter().position(|known| *known == name)?];
        suits(v, scheme, found);
        moves(v, gravity, found);
        if found.len() > before {
            return None;
        }
        // What stands is chosen by the greatest that the motion is told.
        let mut command = GrabCommand::read(v)?;
        command.v_h = v.greatest(s::V_H.id).unwrap_or(0.0);
        let n = |symbol: &Symbol| v.number(symbol.id).unwrap_or(0.0);
        let way = v
            .table("way")
            .and_then(|table| GrabWay::read(table).zip(table.of(&s::L_R)));
        let length = way.map_or(0.0, |(_, length)| length);
        let start = [0.0, n(&s::X_T), n(&s::PHI_R), 0.0, length];
        let longest = LONGEST * TAU * (length / gravity).sqrt();
        let given = Given {
            travel: One(&s::V_T, range.from),
            rate: One(&s::A_T, range.speed),
            command,
            unit: GrabTrolley::read(v)?,
            gravity: One(&s::G, gravity),
            slack: SlackRope::read(v),
            aux: AuxiliaryTrolley::read(v),
            own_rope: v.number(s::F_BA.id).map(|f_b| AuxiliaryRope {
                f_b,
                z: v.number(s::Z_A.id).unwrap_or(1.0),
            }),
            set: PlanetarySet::read(v),
            drums: v.tables("drums").iter().map(RopeDrum::read).collect::<Option<_>>()?,
            dynamic: DynamicFactor::read(v)?,
            phases: v.tables("phases").iter().map(GrabPhase::read).collect::<Option<_>>()?,
            way: way.map(|(way, _)| way),
            feedback: way.map(|_| Feedback { zeta: n(&s::ZETA_F) }),
            place: way.map(|_| GrabPlace { x: start[1] }),
            swaying: way.map(|_| SwayingLoad {
                phi: start[2],
                omega: 0.0,
                l: length,
            }),
            reeving: Reeving {
                scheme,
                sheaves: v.count("sheaves")? as u8,
            },
        };
        let own = v.table("dynamics").and_then(|table| table.of(&s::STEP));
        let step = own.unwrap_or(longest);
        Some((
            UnloaderScene {
                given,
                start,
                told: n(&s::A_T),
                step,
            },
            range,
        ))
    }

    fn given(this: &Description<UnloaderScene>) -> Given<f64> {
        this.given.clone()
    }

    fn check(this: &mut Description<UnloaderScene>, v: &Values, found: &mut Vec<Diagnostic>) {
        let mut known = GrabUnloader::new::<f64>(this.given.clone());
        let worked = known.worked().cloned().unwrap_or_default();
        for ((number, phase), table) in (1..).zip(&worked).zip(v.tables("phases")) {
            if let Some(what) = phase.slack(number) {
                let help = "accelerate less, give less resistance, or a heavier grab";
                found.push(table.refuse(s::A_TP.id, what, "slack rope", help));
            }
        }
        if found.is_empty() {
            possible(this, v, found);
        }
    }

    fn levels(&self) -> Vec<&'static str> {
        let swings = self.given.swaying.map(|_| "swing");
        std::iter::once("static").chain(swings).collect()
    }

    fn set_level(&mut self, level: &str) {
        if level == "static" {
            let Given {
                way,
                feedback,
                place,
                swaying,
                ..
            } = &mut self.given;
            (*way, *feedback, *place, *swaying) = (None, None, None, None);
        }
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        match level {
            "static" => vec![("grab_unloader", &MOVING), ("dynamics", &[])],
            _ => Vec::new(),
        }
    }

    fn moving(this: &Description<UnloaderScene>) -> Option<Result<MovingComponent, Fault>> {
        this.given.swaying?;
        Some(MovingComponent::new(this.standing(), |model| {
            let rate = model.rate();
            model.part_mut().put(rate, this.told);
            Ok(Box::new(SmoothPieces::new(model, &this.start, this.step)?))
        }))
    }

    fn step_by(&mut self, step: f64) {
        self.step = step;
    }

    fn solver(&self) -> Option<Solver> {
        (self.given.swaying).map(|_| Solver::explicit(&s::STEP, self.step, COST))
    }

    /// What the motion starts from stands where the scene does not give it.
    fn arrange(&self, inputs: &mut Vec<Input>) {
        if let Some((load, feedback)) = self.given.swaying.zip(self.given.feedback) {
            let mut start = Vec::new();
            load.map(&mut |symbol, value| start.push((symbol, value)));
            arrange(inputs, &start, &feedback);
        }
    }

    fn hangs_on(this: &Description<UnloaderScene>) -> Option<[f64; 2]> {
        this.given.swaying.map(|load| [load.l, *this.given.gravity])
    }

    fn hang(&mut self, length: f64) {
        self.start[4] = length;
        if let Some(load) = &mut self.given.swaying {
            load.l = length;
        }
    }

    /// The drums' powers against those of weight and travel; torques and speeds of the differentials; Willis.
    fn identities(this: &Description<UnloaderScene>, model: &mut Standing) -> Vec<Check> {
        let (command, scheme) = (this.given.command, this.given.reeving.scheme);
        let [mut power, mut torque, mut willis] = [0.0_f64; 3];
        for at in fine(&this.motion).collect::<Vec<_>>() {
            let known = sample(model, listed!(s: W, F_R), std::iter::once(at)).remove(0);
            let auxiliary = match scheme {
                Scheme::AuxiliaryTrolley => sample(model, &[&s::F_RA], std::iter::once(at))[0][0] * at / 2.0,
                _ => 0.0,
            };
            let lifts = known[0] * (command.v_h + command.lambda * command.v_c);
            let drums = numbered(model, &s::P_D, at);
            let size = drums.iter().map(|power| power.abs()).fold(known[0] * 1e-3, f64::max);
            let apart = drums.iter().sum::<f64>() - lifts - known[1] * at - auxiliary;
            power = power.max(apart.abs() / size);
            let Some(set) = &this.given.set else { continue };
            let [n, m, n_s, n_r, t_s, t_r] = listed!(s: N_D, M_D, N_S, N_R, T_S, T_R)
                .iter()
                .map(|symbol| numbered(model, symbol, at))
                .collect::<Vec<_>>()
                .try_into()
                .unwrap_or_default();
            for i in 0..n.len() {
                let terms = [n_s[i] * t_s[i], n_r[i] * t_r[i], -n[i] * m[i]];
                let turns = [n_s[i], set.k * n_r[i], -(1.0 + set.k) * n[i]];
                torque = torque.max(apart_of(&terms));
                willis = willis.max(apart_of(&turns));
            }
        }
        let mut checks = vec![Check::at_most("unloader_power", &s::AGREEMENT, power, 1e-12)];
        if this.given.set.is_some() {
            checks.push(Check::at_most("unloader_torque", &s::AGREEMENT, torque, 1e-12));
            checks.push(Check::at_most("unloader_willis", &s::AGREEMENT, willis, 1e-12));
        }
        checks
    }

    fn assumptions(this: &Description<UnloaderScene>) -> Vec<&'static str> {
        let scheme = match this.given.reeving.scheme {
            Scheme::Planetary => "unloader_planetary",
            Scheme::Simple => "unloader_simple",
            Scheme::AuxiliaryTrolley => "unloader_auxiliary_trolley",
            Scheme::MiddleDrum => "unloader_middle_drum",
        };
        let level = match this.given.swaying {
            Some(_) => "unloader_level_swing",
            None => "unloader_level_static",
        };
        vec![level, scheme, "unloader_ropes", "unloader_brake"]
    }

    fn uncovered(this: &Description<UnloaderScene>) -> Vec<&'static str> {
        let sway = this.given.swaying.is_none().then_some("unloader_sway");
        let all = sway.into_iter().chain(["unloader_grab", "strength", "load_cases"]);
        all.collect()
    }

    /// From the side: bridge, trolley with its ropes to both sides, grab.
    fn drawing(this: &Description<UnloaderScene>, _: f64) -> Drawing {
        let at = |x: f64, y: f64| Point::new(x, y);
        let mut draw = Draw::default();
        draw.line(at(-2.0, 0.0), at(2.0, 0.0));
        for (x, tension) in [(-1.0, &s::T_1), (1.0, &s::T_2)] {
            draw.bar(&[at(0.3 * x, 0.12), at(2.0 * x, 0.12)], false);
            draw.pin(at(2.0 * x, 0.12), true, false);
            draw.label(at(1.2 * x, 0.27), tension.print);
        }
        let trolley = |x: f64, half: f64| {
            [
                at(x - half, 0.05),
                at(x + half, 0.05),
                at(x + half, 0.2),
                at(x - half, 0.2),
            ]
        };
        draw.body(&trolley(0.0, 0.3), false);
        draw.label(at(0.0, 0.35), s::G_T.print);
        for x in [-0.12, 0.12] {
            draw.bar(&[at(x, 0.05), at(x, -0.9)], false);
        }
        draw.body(
            &[at(-0.12, -0.9), at(0.12, -0.9), at(0.3, -1.25), at(-0.3, -1.25)],
            false,
        );
        draw.load(at(0.0, -1.25), &s::W);
        draw.arrow(at(-0.5, -0.75), at(-0.5, -0.35));
        draw.label(at(-0.7, -0.55), s::V_H.print);
        draw.arrow(at(-0.4, 0.55), at(-0.9, 0.55));
        draw.label(at(-0.65, 0.7), s::V_T.print);
        if this.given.aux.is_some() {
            draw.body(&trolley(1.6, 0.15), true);
            draw.label(at(1.6, 0.35), s::G_A.print);
        }
        draw.done(1.0)
    }

    /// Speeds of the drums, tensions, pulls and powers by phase; the differentials by drum.
    fn more(this: &Description<UnloaderScene>, model: &mut Standing, sheet: &mut Sheet) {
        sheet.constants.insert(0, modes(&this.given));
        if let Some(feedback) = this.given.feedback {
            let mut plain = [this.clone(), this.clone()];
            plain[1].own.hang(LONGER * this.start[4]);
            let fed = plain.clone();
            for told in &mut plain {
                told.own.given.feedback = Some(Feedback { zeta: 0.0 });
            }
            let found = ways([&plain, &fed], &this.given, feedback.zeta > 0.0);
            sheet.constants.extend(found.into_iter().flatten());
        }
        for section in sheet
            .constants
            .iter_mut()
            .filter(|section| section.id == "unloader_phases")
        {
            section.table = Some(each(model, PHASE_COLUMNS, this.motion.from));
        }
        for position in &mut sheet.positions {
            let at = position.value;
            for section in &mut position.sections {
                section.table = match section.id {
                    "unloader_drums" => Some(each(model, DRUM_COLUMNS, at)),
                    "unloader_planetary" => Some(each(model, SET_COLUMNS, at)),
                    _ => None,
                };
            }
        }
    }
}
