//! The trolley of a container bridge as scenes describe it and books tell it.

use crate::bridge::bodies;
use crate::bridge::bodies::posture::{SlungLoad, SlungPosture};
use crate::bridge::bodies::small::small_sway;
use crate::bridge::brakes::TrolleyBrakes;
use crate::bridge::compared::{compared, four_bar, lengths, slung_starts, steps_apart};
use crate::bridge::given::{BridgeTrolley, DrivenWheels, PassedSheaves, SheaveCount, TrolleyCommand};
use crate::bridge::outline::{OUTLINE, SLINGS};
use crate::bridge::profiles::TravelProfile;
use crate::bridge::slung::{LoadSlings, Slung};
use crate::bridge::stages::{ContainerBridge, Given};
use crate::bridge::suspension::{FourRopes, RopesLength, Suspended};
use crate::bridge::swing::length;
use crate::bridge::symbols as s;
use crate::bridge::tow::TowRope;
use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::Draw;
use crate::component::mechanism::{Entry, Solver};
use crate::component::moving::MovingComponent;
use crate::component::moving::smooth::SmoothPieces;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Drawing, Input, Sheet};
use crate::component::standing::Standing;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{KIND, Key, Kind, Values};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::hanging;
use crate::parts::motion::{Motion, short_step};
use crate::parts::plane::Point;
use crate::sway::pendulum::{self, Feedback, SwayingLoad};
use crate::sway::scene::{arrange, unmoved};

/// Kinds of trolleys, as scenes name them.
pub const KINDS: [&str; 3] = ["rope", "semi_rope", "machinery"];

/// Keys of `[trolley]`.
pub const KEYS: &[Key] = keys! { s:
    G_T > 0 [or_mass], G_S > 0 [or_mass], Q >= 0 [or_mass], MU_T >= 0 [usually(0.008)], P_W >= 0 [usually(0.0)],
    A_W >= 0 [usually(0.0)], GAMMA_B [usually(0.0)], ETA_D > 0 [usually(1.0)], N_W > 0 [usually(4.0)], S_B > 0,
    A_T [over_time, optional], V_H [over_time, optional], X_T [optional], PHI_R [optional], ZETA_F >= 0 [optional];
    Key::new(
        KIND,
        Kind::Choice(&KINDS),
        "How the trolley travels and its load is hoisted: \"rope\" (both by ropes from the bridge), \"semi_rope\" (by driven \
         wheels, hoisted by ropes from the bridge), \"machinery\" (all drives on the trolley).",
    ),
    Key::choice(
        "fidelity",
        &["static", "swing"],
        "How deep the trolley is modelled: \"static\" (place and speed are inputs, the load hangs straight down), \"swing\" (it \
         follows its acceleration, and its load sways).",
    ),
    Key::part("tow", TOW, "The tow rope of a rope trolley."),
    Key::part("driven", DRIVEN, "The driven wheels of a trolley with a travel drive of its own."),
    Key::part("sheaves", OVER, "The sheaves that the hoisting ropes pass as the trolley travels."),
    Key::part("brakes", BRAKES, "The brakes of the trolley's travel; of driven wheels these are braked."),
    Key::table("ropes", ROPES, "The four ropes on which the spreader hangs."),
    Key::part("slings", HUNG, "Slings on which the load hangs below the spreader: two bodies that sway. Ropes' e_q and i_q are those of both as one."),
    Key::table("profile", PROFILE, "Speed, acceleration and way of the trolley."),
    Key::part("dynamics", DYNAMICS, "How the motion is solved."),
    Key::table("motion", MOTION, "Working range of the trolley's place."),
    Key::part("limits", LIMITS, "What results may come to at most, or at least.")
};

static TOW: &[Key] = keys! { s: T_0 > 0, Z_R > 0 [usually(2.0)], Q_R > 0, EA > 0, F_B > 0, X_1, X_2 };
static DRIVEN: &[Key] = keys! { s: N_DR > 0, MU_A > 0 [usually(0.14)] };
static OVER: &[Key] =
    keys! { s: ETA_R > 0 [usually(0.98)]; Key::new("count", Kind::Count([1, 12]), "How many a rope passes.") };
static ROPES: &[Key] = keys! { s: L_R > 0, A_O > 0, A_U > 0, B_O > 0, B_U > 0, E_Q >= 0, I_Q > 0, I_Z > 0, D_Q [usually(0.0)], E_X [usually(0.0)] };
static HUNG: &[Key] = keys! { s: L_S > 0, E_S >= 0 [usually(0.0)], E_1 >= 0 [usually(0.0)], I_1 > 0 };
static BRAKES: &[Key] = keys! { s: F_BR > 0 };
static PROFILE: &[Key] = keys! { s: V_C > 0, A_C > 0, S_C > 0, T_E >= 0 [usually(0.0)] };
static DYNAMICS: &[Key] = keys! { s: STEP > 0 };
const MOTION: &[Key] = &Motion::keys(
    [&s::FROM, &s::TO],
    &s::X_T,
    (
        &s::V_T,
        "Speed of the trolley to the sea side, with which it passes through the working range.",
    ),
);
const LIMITS: &[Key] = &Limit::keys::<11>(OUTLINE.limits);

/// Keys that say something of the motion alone.
const MOVING: [&str; 4] = ["x_t", "phi_R", "zeta_f", "dynamics"];

/// Longest step of the solver over the period of the sway, of two bodies the shorter one, and the shortest that may be given over that.
const LONGEST: f64 = 0.01;
const SHORTEST: f64 = 1e-2;

/// What the rates cost, in s.
const COST: [f64; 2] = [0.15e-6, 0.0];
const SLUNG_COST: [f64; 2] = [0.5e-6, 0.0];

/// The trolley of a container bridge as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct BridgeScene {
    /// At the start of the working range.
    given: Given<f64>,
    /// All states at the start of its motion, at rest: place (m) first, length of the ropes (m) last.
    start: Vec<f64>,
    /// Longest step of the solver, in s.
    step: f64,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<BridgeScene>::entry("trolley", KEYS);

/// Refuses what the kind of trolley has no use for or lacks, more driven wheels than wheels, a tow rope that ends before the
/// working range does, and what has no use where nothing moves.
fn suits(v: &Values, range: &Motion, moves: bool, found: &mut Vec<Diagnostic>) {
    let kind = v.text(KIND).unwrap_or_default();
    let needs = [
        ("tow", kind == "rope"),
        ("driven", kind != "rope"),
        ("sheaves", kind != "machinery"),
    ];
    for (table, needed) in needs {
        match (needed, v.has(table)) {
            (true, false) => {
                let what = format!("[trolley.{table}] is missing of kind = \"{kind}\"");
                found.push(v.refuse(KIND, what, format!("needs {table}"), "add it, or choose another kind"));
            }
            (false, true) => {
                let what = format!("[trolley.{table}] of kind = \"{kind}\"");
                found.push(v.refuse(table, what, "not used", "remove it, or choose another kind"));
            }
            _ => {}
        }
    }
    if !moves {
        let told = [&s::A_T, &s::V_H].map(|symbol| symbol.id).into_iter();
        let own = MOVING.into_iter().chain(told.filter(|key| v.course(key).is_some()));
        unmoved(v, own, "place", found);
    }
    let wheels = v.of(&s::N_W).unwrap_or_default();
    let own = v.table("driven").into_iter().map(|table| (table, &s::N_DR));
    for (table, symbol) in own
        .chain(v.table("tow").map(|table| (table, &s::Z_R)))
        .chain([(v, &s::N_W)])
    {
        let count = table.of(symbol).unwrap_or_default();
        if let Some(refused) = table.broken(symbol) {
            found.push(refused);
        } else if symbol == &s::N_DR && count > wheels {
            let what = format!("{count} driven wheels of {wheels}");
            let help = "drive at most as many as n_w, or give more wheels";
            found.push(table.refuse(symbol.id, what, "more than there are", help));
        }
    }
    for (symbol, beyond) in [(&s::X_1, range.to), (&s::X_2, range.from)] {
        let Some((table, at)) = v.table("tow").and_then(|tow| Some((tow, tow.of(symbol)?))) else {
            continue;
        };
        if (at - beyond) * if symbol == &s::X_1 { 1.0 } else { -1.0 } <= 0.0 {
            let what = format!("{} = {}", symbol.id, symbol.written(at));
            let help = format!(
                "the trolley goes to {}: put the sheave beyond that",
                s::X_T.written(beyond)
            );
            found.push(table.refuse(symbol.id, what, "within the working range", help));
        }
    }
}

impl Described for BridgeScene {
    type Component = ContainerBridge;
    const ID: &'static str = "bridge";
    const TABLE: &'static str = "trolley";
    const OUTLINE: &'static Outline = &OUTLINE;
    const FOLLOWED: &'static [&'static Symbol] = listed!(s: X_L, S_R, N_S, S_S1, S_S2, F_DR, P_DR);
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "bridge_symbol",
        own: &[s::ALL, bodies::symbols::ALL, pendulum::ALL],
        shared: &[hanging::ALL, gravity::ALL],
    };

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(BridgeScene, Motion)> {
        let before = found.len();
        let moves = v.text("fidelity") == Some("swing");
        let range = Motion::read(v.table("motion")?, found)?;
        suits(v, &range, moves, found);
        let [four, profile] = ["ropes", "profile"].map(|name| v.table(name));
        let (four, n) = (four?, |symbol: &Symbol| v.number(symbol.id).unwrap_or(0.0));
        let (ropes, reeved) = (FourRopes::read(four)?, RopesLength::read(four)?);
        let hanging = Suspended::new(&ropes, &One(&s::G, gravity), &reeved.l);
        let hanging = hanging.map_err(|fault| {
            let help = "give longer ropes, or joints of trolley and spreader that are less apart";
            found.push(four.refuse(s::L_R.id, fault.message, "too short", help));
        });
        let hanging = hanging.ok()?;
        // What stands is chosen by the greatest that the motion is told.
        let most = |symbol: &Symbol| v.greatest(symbol.id).unwrap_or(0.0);
        let command = TrolleyCommand {
            a: most(&s::A_T),
            v_h: most(&s::V_H),
            q: n(&s::Q),
        };
        let unit = BridgeTrolley::read(v)?;
        let slings = v.part("slings", LoadSlings::read)?;
        // Those that hang straight down at the start of a motion, and the shorter period of what sways.
        let moved = slings.filter(|_| moves).map(|slings| {
            let start = SlungLoad {
                phi: n(&s::PHI_R),
                psi: 0.0,
                w_phi: 0.0,
                w_psi: 0.0,
                l: reeved.l,
            };
            if let Err(fault) = SlungPosture::new(&start, &slings, &ropes, &hanging) {
                let help = "begin with less sway, or give ropes that are less apart on the trolley";
                found.push(v.refuse(s::PHI_R.id, fault.message, "too far", help));
            }
            let slung = Slung::new(&slings, &unit, &command, &ropes, &One(&s::G, gravity), &hanging);
            let slung = slung.map_err(|fault| {
                let help = "give the weight of what hangs on the slings";
                found.push(v.refuse(s::Q.id, fault.message, "no second body", help));
            });
            (start, slung.map_or(hanging.period, |slung| slung.period[1]))
        });
        let longest = LONGEST * moved.map_or(hanging.period, |(_, period)| hanging.period.min(period));
        let dynamics = v.table("dynamics");
        found.extend(dynamics.and_then(|table| short_step(table, &s::STEP, [SHORTEST * longest, longest])));
        if found.len() > before {
            return None;
        }
        let phi = n(&s::PHI_R);
        let given = Given {
            place: One(&s::X_T, range.from),
            speed: One(&s::V_T, range.speed),
            command,
            unit,
            gravity: One(&s::G, gravity),
            over: v.part("sheaves", PassedSheaves::read)?,
            driven: v.part("driven", DrivenWheels::read)?,
            tow: v.part("tow", TowRope::read)?,
            brakes: v.part("brakes", TrolleyBrakes::read)?,
            ropes,
            reeved: (!moves).then_some(reeved),
            slings,
            profile: TravelProfile::read(profile?)?,
            feedback: moves.then_some(Feedback { zeta: n(&s::ZETA_F) }),
            swaying: (moves && slings.is_none()).then_some(SwayingLoad {
                phi,
                omega: 0.0,
                l: reeved.l,
            }),
            hung: moved.map(|(start, _)| start),
            count: SheaveCount(v.table("sheaves").and_then(|table| table.count("count")).unwrap_or(0) as u8),
        };
        let place = v.number(s::X_T.id).unwrap_or(range.from);
        let start = match moved {
            Some(_) => vec![place, 0.0, phi, 0.0, 0.0, 0.0, reeved.l],
            None => vec![place, 0.0, phi, 0.0, reeved.l],
        };
        let step = dynamics.and_then(|table| table.of(&s::STEP)).unwrap_or(longest);
        Some((BridgeScene { given, start, step }, range))
    }

    fn given(this: &Description<BridgeScene>) -> Given<f64> {
        this.given.clone()
    }

    fn levels(&self) -> Vec<&'static str> {
        std::iter::once("static")
            .chain(self.moves().then_some("swing"))
            .collect()
    }

    fn set_level(&mut self, level: &str) {
        if level == "static" {
            let length = length(&self.given.reeved, &self.given.swaying, &self.given.hung);
            (self.given.swaying, self.given.hung) = (None, None);
            self.given.feedback = None;
            self.given.reeved = Some(RopesLength { l: length });
        }
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        match level {
            "static" => vec![("trolley", &MOVING), ("dynamics", &[])],
            _ => Vec::new(),
        }
    }

    fn moving(this: &Description<BridgeScene>) -> Option<Result<MovingComponent, Fault>> {
        this.moves().then_some(())?;
        Some(MovingComponent::new(this.standing(), |model| {
            Ok(Box::new(SmoothPieces::new(model, &this.start, this.step)?))
        }))
    }

    fn step_by(&mut self, step: f64) {
        self.step = step;
    }

    fn solver(&self) -> Option<Solver> {
        let cost = self.given.hung.map_or(COST, |_| SLUNG_COST);
        self.moves().then(|| Solver::explicit(&s::STEP, self.step, cost))
    }

    /// The frequency against that of the four-bar, what starts leave against their steps one by one, and both frequencies of a load
    /// on slings against the motion about rest.
    fn identities(this: &Description<BridgeScene>, _: &mut Standing) -> Vec<Check> {
        let four_bar =
            four_bar(&this.given).map(|value| Check::at_most("bridge_frequency", &s::AGREEMENT, value, 1e-9));
        let steps = steps_apart(&this.given).map(|value| Check::at_most("bridge_steps", &s::AGREEMENT, value, 1e-9));
        let Given {
            slings,
            unit,
            ropes,
            command,
            reeved,
            swaying,
            hung,
            gravity,
            ..
        } = &this.given;
        let length = length(reeved, swaying, hung);
        let bodies = slings.and_then(|slings| small_sway(&slings, unit, ropes, command.q, length, gravity));
        let bodies = bodies.map(|value| Check::at_most("bridge_bodies", &s::AGREEMENT, value, 1e-9));
        four_bar.into_iter().chain(steps).chain(bodies).collect()
    }

    fn assumptions(this: &Description<BridgeScene>) -> Vec<&'static str> {
        let level = match (this.moves(), this.given.hung) {
            (false, _) => "bridge_level_static",
            (true, None) => "bridge_level_swing",
            (true, Some(_)) => "bridge_level_slung",
        };
        let rope = this.given.tow.map(|_| "bridge_tow");
        let bodies = this.given.slings.map_or("bridge_rigid", |_| "bridge_slung");
        let all = [
            Some(level),
            rope,
            Some("bridge_ropes"),
            Some("bridge_small"),
            Some(bodies),
        ];
        all.into_iter().flatten().collect()
    }

    fn uncovered(this: &Description<BridgeScene>) -> Vec<&'static str> {
        let body = this.given.slings.map_or(Some("bridge_one_body"), |_| None);
        let all = [Some("bridge_rest"), body, Some("strength"), Some("load_cases")];
        all.into_iter().flatten().collect()
    }

    /// The sway at the start, and that there is no feedback, stand where the scene does not give them.
    fn arrange(&self, inputs: &mut Vec<Input>) {
        let mut start = Vec::new();
        let mut stands = |symbol, value| start.push((symbol, value));
        if let Some(load) = self.given.swaying {
            load.map(&mut stands);
        }
        if let Some(load) = self.given.hung {
            load.map(&mut stands);
        }
        if let Some(feedback) = self.given.feedback {
            arrange(inputs, &start, &feedback);
        }
    }

    /// On one rope as long as the simple pendulum, where that is the ropes' own length.
    fn hangs_on(this: &Description<BridgeScene>) -> Option<[f64; 2]> {
        let FourRopes { a_o, a_u, b_o, b_u, .. } = this.given.ropes;
        let load = this.given.swaying.filter(|_| a_o == a_u && b_o == b_u)?;
        Some([load.l, *this.given.gravity])
    }

    fn hang(&mut self, length: f64) {
        if let Some(own) = self.start.last_mut() {
            *own = length;
        }
        if let Some(load) = &mut self.given.swaying {
            load.l = length;
        }
    }

    /// From the side, the sea on the left: rails, beam, trolley with its load on the ropes.
    fn drawing(this: &Description<BridgeScene>, told: f64) -> Drawing {
        let Given {
            ropes,
            unit,
            tow,
            slings,
            ..
        } = &this.given;
        let hanging = this.height();
        let at = |x: f64, y: f64| Point::new(-x, y);
        let ends = tow.map_or([this.motion.to, this.motion.from], |tow| [tow.x_1, tow.x_2]);
        let size = hanging.max(unit.s_b);
        let mut draw = Draw::default();
        draw.line(at(ends[0].max(0.0), 0.0), at(ends[1].min(-unit.s_b), 0.0));
        for (x, rail) in [(0.0, &s::R_1), (-unit.s_b, &s::R_2)] {
            draw.line(at(x, 0.0), at(x, -1.3 * hanging));
            draw.pin(at(x, -1.3 * hanging), true, false);
            draw.label(at(x - 0.04 * size, -1.2 * hanging), rail.print);
        }
        if tow.is_some() {
            draw.bar(&[at(ends[0], 0.03 * size), at(ends[1], 0.03 * size)], false);
            ends.iter().for_each(|x| draw.pin(at(*x, 0.03 * size), true, false));
            draw.label(at(told.midpoint(ends[0]), 0.07 * size), s::T_1.print);
            draw.label(at(told.midpoint(ends[1]), 0.07 * size), s::T_2.print);
        }
        for (x, faint) in [(this.motion.from, true), (this.motion.to, true), (told, false)] {
            let corner = |half: f64, y: f64| at(x + half, y);
            let (a, b, low) = (ropes.a_o, ropes.a_u, -hanging);
            draw.body(
                &[
                    corner(-a, 0.0),
                    corner(a, 0.0),
                    corner(a, 0.05 * size),
                    corner(-a, 0.05 * size),
                ],
                faint,
            );
            for side in [-1.0, 1.0] {
                draw.bar(&[corner(side * a, 0.0), corner(side * b, low)], faint);
            }
            let least = 0.05 * size;
            let deep = low - slings.map_or(2.0 * ropes.e_q.max(least), |slings| slings.e_s.max(least));
            draw.body(
                &[corner(-b, low), corner(b, low), corner(b, deep), corner(-b, deep)],
                faint,
            );
            if let Some(slings) = slings {
                let joint = low - slings.e_s;
                draw.bar(&[corner(0.0, joint), corner(0.0, joint - slings.l_s)], faint);
            }
        }
        match slings {
            Some(slings) => draw.load(at(told, -hanging - slings.e_s - slings.l_s), &s::Q),
            None => draw.load(at(told, -hanging - ropes.e_q), &s::W),
        }
        draw.distance(
            at(told + ropes.a_o, 0.0),
            at(told + ropes.a_o, -hanging),
            0.05 * size,
            &s::H_R,
        );
        draw.arrow(at(told, 0.14 * size), at(told + 0.12 * size, 0.14 * size));
        draw.label(at(told + 0.06 * size, 0.18 * size), s::V_T.print);
        draw.done(size)
    }

    /// Starts in closed form and in runs, and what they leave on other lengths of the ropes.
    fn more(this: &Description<BridgeScene>, _: &mut Standing, sheet: &mut Sheet) {
        let place = sheet
            .constants
            .iter()
            .position(|section| section.id == "bridge_profiles");
        let after = place.map_or(sheet.constants.len(), |place| place + 1);
        let mut fed = this.clone();
        fed.own.rest();
        let mut plain = fed.clone();
        plain.own.given.feedback = this.given.feedback.map(|_| Feedback { zeta: 0.0 });
        if let Some(section) = place.and_then(|place| sheet.constants.get_mut(place)) {
            section.table = compared([&plain, &fed], &this.given);
        }
        if let Some(section) = sheet.constants.iter_mut().find(|section| section.id == SLINGS) {
            section.table = slung_starts(&plain, &this.given);
        }
        let own = lengths(&this.given);
        sheet.constants.splice(after..after, own);
    }
}

impl BridgeScene {
    /// Whether trolley and load move by themselves.
    fn moves(&self) -> bool {
        self.given.feedback.is_some()
    }

    /// At rest at the start.
    fn rest(&mut self) {
        self.start[2] = 0.0;
        self.given.command.v_h = 0.0;
    }

    /// Height of the trolley's rope joints above the spreader's, in m.
    fn height(&self) -> f64 {
        let Given {
            ropes,
            gravity,
            reeved,
            swaying,
            hung,
            ..
        } = &self.given;
        let found = Suspended::new(ropes, gravity, &length(reeved, swaying, hung));
        found.map_or(0.0, |hanging| hanging.height)
    }
}
