//! Slewing by itself as scenes describe it and books tell it.

use crate::component::description::{Described, Description, Vocabulary};
use crate::component::draw::{Draw, distance, polar};
use crate::component::mechanism::{Entry, Solver};
use crate::component::moving::MovingComponent;
use crate::component::moving::sampled::with_samples;
use crate::component::moving::smooth::SmoothPieces;
use crate::component::outline::{Limit, Outline};
use crate::component::sheet::{Check, Drawing, Input};
use crate::component::stages::Stages;
use crate::component::standing::Standing;
use crate::component::telling::{fine, sample};
use crate::kernel::calc::Calc;
use crate::kernel::course::Course;
use crate::kernel::diagnostic::Diagnostic;
use crate::kernel::gravity;
use crate::kernel::group::One;
use crate::kernel::keys::keys;
use crate::kernel::schema::{Key, Values};
use crate::kernel::sign::Sign;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::parts::air::{self, AIR, AIR_OR_WIND, AROUND, SWINGING};
use crate::parts::control::continuous::{Regime, Regulating};
use crate::parts::control::{Latched, SpeedControl, taken};
use crate::parts::hanging::{self, HangingLoad};
use crate::parts::motion::Motion;
use crate::parts::plane::Point;
use crate::parts::slip;
use crate::parts::slope::{SLOPE, SlopingGround};
use crate::parts::turntable::{self as joint, SlewingJoint, WIND_ON_SLEWED};
use crate::parts::turntable_control::{self, AXIS, CONTROL};
use crate::parts::{shaping, side_wind, slope};
use crate::slewing::air_scene::{SlewedAir, refused};
use crate::slewing::bounds::{Slewed, weightless};
use crate::slewing::coupling::{DriveSide, SlipCoupling, SlipPast};
use crate::slewing::motion::{Past, SlewingDrive, Stops};
use crate::slewing::outline::OUTLINE;
use crate::slewing::stages::{Given, Open, SlewingCrane};
use crate::slewing::swinging::{RopeLength, Slackness};
use crate::slewing::symbols as s;
use crate::slewing::turning::Hung;

/// Keys of `[slewing]`: those of the joint, as every crane that slews has them, and what nothing else gives.
pub const KEYS: &[Key] = keys! { joint:
    J_SL >= 0 [optional], C_SL >= 0 [optional], M_F_SL >= 0 [optional], M_SL [over_time, optional], M_B_SL >= 0 [over_time, optional], PSI_SL [optional],
    OMEGA_SL [optional], PSI_MIN [optional], PSI_MAX [optional], CHI_R [optional];
    Key::choice(
        "fidelity",
        &["static", "rigid", "swing", "auto"],
        "How deep slewing by itself is modelled: \"static\" (angle and speed are inputs), \"rigid\" (it moves under a \
         moment), \"swing\" (its load swings on a rope besides), \"auto\" (as deep as the accuracy asks for).",
    ),
    Key::quantity(&s::L_R, Sign::Positive).optional(),
    Key::quantity(&s::PHI_R, Sign::Any).optional(),
    Key::quantity(&s::R, Sign::NotNegative).or_input().optional(),
    Key::weight(&s::Q).or_input().optional(),
    Key::quantity(&s::A_WS, Sign::NotNegative).optional(),
    Key::quantity(&s::R_WS, Sign::Any).optional(),
    SOLVED,
    Key::part("motion", MOTION, "Working range of slewing by itself."),
    SLOPE,
    AIR_OR_WIND,
    CONTROL,
    COUPLING,
    Key::part("limits", LIMITS, "What results may come to at most.")
};

const MOTION: &[Key] = &Motion::keys(
    [&s::FROM, &s::TO],
    &s::PSI_SL,
    (&s::OMEGA_SL, "Angular velocity of slewing."),
);

const LIMITS: &[Key] = &Limit::keys::<3>(OUTLINE.limits);

static COUPLED: &[Key] = keys! { s: J_D > 0, M_LIM > 0 };

/// The coupling between drive and brake and what slews.
const COUPLING: Key = Key::part(
    "coupling",
    COUPLED,
    "The coupling of the slewing drive, which slips; drive and brake act in front of it.",
);

static DYNAMICS: &[Key] = keys! { s: STEP > 0 };

/// How the motion is solved.
pub const SOLVED: Key = Key::part("dynamics", DYNAMICS, "How slewing by itself is solved.");

/// Quantities and tables that say something of a motion alone.
const MOVED: [&str; 6] = ["M_sl", "M_Bsl", "psi_sl", "omega_sl", "psi_min", "psi_max"];
const MOVING: [&str; 3] = ["dynamics", CONTROL.name, COUPLING.name];

/// What the rates cost, in s, without a load that swings and with it.
const COST: [[f64; 2]; 2] = [[0.1e-6, 0.0], [0.4e-6, 0.0]];

/// Slewing by itself as the scene describes it; SI.
#[derive(Clone, Debug)]
pub struct SlewingScene {
    /// At the start of the working range, at its speed.
    given: Given<f64>,
    /// Angle (rad) and angular velocity (rad/s) at the start of its motion.
    start: [f64; 2],
    /// Longest step of the solver, in s.
    step: f64,
}

/// As scenes describe it.
pub const ENTRY: Entry = Description::<SlewingScene>::entry("platform", KEYS);

/// Whether it moves, and whether its load swings; refuses what is missing for that, and what has no use then.
fn suits(v: &Values, found: &mut Vec<Diagnostic>) -> [bool; 2] {
    let level = v.text("fidelity");
    // What is left to the accuracy may come to all that the scene has keys for.
    let auto = level == Some("auto");
    let motion = || MOVED.iter().chain(&MOVING).find(|key| v.has(key));
    let swings = level == Some("swing") || auto && v.has(s::L_R.id);
    let moves = swings || level == Some("rigid") || auto && motion().is_some();
    for (symbol, example) in [(&s::R, "20 m"), (&s::Q, "100 kN")] {
        if !v.stands(symbol.id) {
            let id = symbol.id;
            let help = format!(
                "add {id} = \"{example}\", or {id} = {{ input = \"{example}\" }} for an input that starts there, or a \
                 [luffing] that gives it"
            );
            found.push(v.refuse(id, format!("`{id}` is missing in [slewing]"), "nothing gives it", help));
        }
    }
    found.extend(joint::without_inertia(v));
    if !v.has("motion") {
        let help = "add from, to, step and speed in [slewing.motion], or a [luffing]";
        found.push(v.refuse("motion", "`motion` is missing in [slewing]", "needed here", help));
    }
    if let (false, Some(key)) = (moves, motion()) {
        let what = format!("`{key}` of slewing that is set in its place");
        found.push(v.refuse(
            key,
            what,
            "not used",
            "set fidelity = \"rigid\" or \"swing\", or remove it",
        ));
    }
    if let (false, Some(key)) = (swings, SWINGING.iter().find(|key| v.has(key))) {
        let what = format!("`{key}` without a swinging load");
        let help = "remove it: the load keeps its place under the head; or set fidelity = \"swing\"";
        found.push(v.refuse(key, what, "not used", help));
    }
    if swings && !v.has(s::L_R.id) {
        let what = "a swinging load without a rope";
        let help = "add l_R = \"15 m\", the length of the rope from head to load";
        found.push(v.refuse(s::L_R.id, what, "l_R is missing in [slewing]", help));
    }
    found.extend(refused(v, [moves, swings]));
    [moves, swings]
}

/// The controller with its command, of an inertia (kg·m²), and the coupling, where there are any; mistakes go to `found`.
#[expect(clippy::type_complexity, reason = "both may be absent")]
fn driven(
    v: &Values,
    inertia: f64,
    found: &mut Vec<Diagnostic>,
) -> Option<(Option<(SpeedControl<f64>, One<f64>)>, Option<SlipCoupling<f64>>)> {
    let controlled = SpeedControl::read(&AXIS, v, v)
        .map_err(|refused| found.push(refused))
        .ok()?;
    let coupling = v.table(COUPLING.name).and_then(SlipCoupling::read);
    // Where the coupling slips, the controller has the drive alone.
    let least = coupling.map_or(inertia, |coupling| coupling.j_d);
    let unstable = controlled.as_ref().and_then(|(control, _)| control.unstable(v, least));
    found.extend(unstable);
    Some((controlled, coupling))
}

/// What a controller holds that has held an angular velocity (rad/s) so far: one that is sampled, or one that is continuous.
fn steady(control: Option<SpeedControl>, omega: f64) -> (Option<Latched>, (Option<Regulating>, Option<Regime>)) {
    let Some(control) = control else {
        return (None, (None, None));
    };
    if control.cycle().is_some() {
        return (Some(Latched::steady(&control, omega)), (None, None));
    }
    (None, Some(Regulating::steady(&control, omega)).unzip())
}

/// What the scene makes an input.
fn open(v: &Values) -> Open {
    let both = [&s::R, &s::Q].into_iter();
    Open(both.filter(|symbol| v.is_input(symbol.id)).collect())
}

/// With a coupling that slips where its drive asks for that, at the start of the working range.
fn settled(mut given: Given<f64>) -> Given<f64> {
    if let Some(coupling) = given.coupling
        && let Ok(&moment) = SlewingCrane::new(given.clone()).passing()
        && moment.abs() > coupling.m_lim
    {
        given.slipping = Some(SlipPast {
            slip: moment.signum(),
            way_d: 1.0,
        });
    }
    given
}

impl SlewingScene {
    /// What of the air a load that does not swing has no use for.
    fn still(&self) -> (&'static str, &'static [&'static str]) {
        (AIR.name, if self.given.area.is_some() { &AROUND } else { &[] })
    }
}

impl Described for SlewingScene {
    type Component = SlewingCrane;
    const ID: &'static str = "slewing";
    const TABLE: &'static str = "slewing";
    const OUTLINE: &'static Outline = &OUTLINE;
    const VOCABULARY: &'static Vocabulary = &Vocabulary {
        words: "slewing_symbol",
        own: &[s::ALL],
        shared: &[
            shaping::ALL,
            side_wind::ALL,
            slope::ALL,
            joint::ALL,
            turntable_control::ALL,
            hanging::ALL,
            air::ALL,
            gravity::ALL,
            slip::ALL,
        ],
    };

    const FOLLOWED: &'static [&'static Symbol] = listed!(s: M_SL, OMEGA_D, M_CD, W_SLIP);

    const TOGETHER: &'static [[&'static Symbol; 2]] = &[[&s::OMEGA_SL, &s::OMEGA_D]];

    fn read(v: &Values, gravity: f64, found: &mut Vec<Diagnostic>) -> Option<(SlewingScene, Motion)> {
        let before = found.len();
        let [moves, swings] = suits(v, found);
        let range = Motion::read(v.table("motion")?, found);
        let joint = SlewingJoint::read(v, found);
        let slope = v.part("slope", SlopingGround::read)?;
        let (range, joint) = range.zip(joint).filter(|_| found.len() == before)?;
        let n = |key: &str| v.number(key).unwrap_or(0.0);
        let carried = if swings { 0.0 } else { n(s::Q.id) * n(s::R.id) };
        if joint.turning.j_sl + carried <= 0.0 {
            found.push(weightless(v));
            return None;
        }
        let air = SlewedAir::read(v, swings.then_some([n(s::L_R.id), gravity]), found);
        let inertia = joint.turning.j_sl + carried / gravity * n(s::R.id);
        let (controlled, coupling) = driven(v, inertia, found)?;
        let (control, commanded) = controlled.unzip();
        let lasts = v
            .course(s::M_SL.id)
            .map_or((range.to - range.from) / range.speed.abs(), Course::end);
        let load = [n(s::R.id), n(s::Q.id) / gravity];
        joint.outlasts(v, v.greatest(s::M_SL.id).unwrap_or(0.0), load, lasts, gravity, found);
        let slewed = Slewed {
            table: v,
            joint: &joint,
            range: &range,
            gravity,
            swings,
            coupling,
            control,
        };
        if moves {
            slewed.check(found);
        }
        if found.len() > before {
            return None;
        }
        let (latched, (regulating, regime)) = steady(control, range.speed);
        let given = settled(Given {
            psi: One(&s::PSI_SL, range.from),
            omega: One(&s::OMEGA_SL, range.speed),
            hung: Hung {
                q: v.of(&s::Q)?,
                r: v.of(&s::R)?,
                g: gravity,
            },
            turning: joint.turning,
            slope,
            driven: moves.then(|| SlewingDrive {
                m_sl: n(s::M_SL.id),
                m_b_sl: n(s::M_B_SL.id),
            }),
            swung: swings.then(|| HangingLoad::resting(n(s::L_R.id), [&s::PHI_R, &s::CHI_R].map(|a| n(a.id))).into()),
            rope: RopeLength::read(v).filter(|_| swings),
            area: air.area,
            around: air.around,
            blowing: air.blowing,
            slackness: swings.then_some(Slackness { slack: 0.0 }),
            coupling,
            side: coupling.map(|_| DriveSide::along(range.speed)),
            slipping: coupling.map(|_| SlipPast { slip: 0.0, way_d: 1.0 }),
            control,
            commanded,
            latched,
            regulating,
            regime,
            past: Past { way: 1.0, blown: 0.0 },
            stops: Stops(joint.stops),
            open: open(v),
        });
        let step = v.of(&s::STEP).unwrap_or_else(|| slewed.longest());
        Some((
            SlewingScene {
                given,
                start: joint.start,
                step,
            },
            range,
        ))
    }

    fn given(this: &Description<SlewingScene>) -> Given<f64> {
        this.given.clone()
    }

    fn levels(&self) -> Vec<&'static str> {
        let moves = self.given.driven.map(|_| "rigid");
        let swings = self.given.swung.map(|_| "swing");
        std::iter::once("static").chain(moves).chain(swings).collect()
    }

    fn set_level(&mut self, level: &str) {
        if level != "swing" {
            (self.given.swung, self.given.rope, self.given.slackness) = (None, None, None);
            SlewedAir::without_load(&mut self.given);
        }
        if level == "static" {
            self.given.driven = None;
            (self.given.control, self.given.commanded, self.given.latched) = (None, None, None);
            (self.given.regulating, self.given.regime) = (None, None);
            (self.given.coupling, self.given.side, self.given.slipping) = (None, None, None);
        }
    }

    fn unused(&self, level: &str) -> Vec<(&'static str, &'static [&'static str])> {
        match level {
            "swing" => Vec::new(),
            "rigid" => vec![("slewing", &SWINGING), self.still()],
            _ => vec![
                ("dynamics", &[]),
                ("slewing", &SWINGING),
                ("slewing", &MOVED),
                self.still(),
                (CONTROL.name, &[]),
                (COUPLING.name, &[]),
            ],
        }
    }

    fn moving(this: &Description<SlewingScene>) -> Option<Result<MovingComponent, Fault>> {
        this.given.driven?;
        let mut resting = this.clone();
        resting.own.given.past.way = 0.0;
        if let Some(past) = &mut resting.own.given.slipping {
            *past = SlipPast { slip: 0.0, way_d: 0.0 };
        }
        if let Some(latched) = &mut resting.own.given.latched {
            latched.set = this.start[1];
        }
        if let Some((state, past)) = resting
            .own
            .given
            .regulating
            .as_mut()
            .zip(resting.own.given.regime.as_mut())
        {
            (state.set, past.target) = (this.start[1], this.start[1]);
        }
        Some(MovingComponent::new(resting.standing(), |model| {
            let own = SmoothPieces::new(model, &this.start, this.step)?;
            Ok(with_samples(own, model))
        }))
    }

    fn step_by(&mut self, step: f64) {
        self.step = step;
    }

    fn solver(&self) -> Option<Solver> {
        let cost = COST[usize::from(self.given.swung.is_some())];
        (self.given.driven).map(|_| Solver::explicit(&s::STEP, self.step, cost))
    }

    /// The slope's moment against the change of the weights' height.
    fn identities(this: &Description<SlewingScene>, model: &mut Standing) -> Vec<Check> {
        let Some(slope) = this.given.slope else {
            return Vec::new();
        };
        let Hung { q, r, .. } = this.given.hung;
        let whole = (slope.g_u * slope.r_u + q * r) * Calc::sin_cos(slope.gamma_s).0;
        let (near, height) = (1e-4, |psi: f64| -whole * Calc::sin_cos(psi).1);
        let mut worst = 0.0_f64;
        for (psi, row) in fine(&this.motion).zip(sample(model, &[&s::M_GAMMA], fine(&this.motion))) {
            let work = (height(psi - near) - height(psi + near)) / (2.0 * near);
            worst = worst.max((row[0] - work).abs());
        }
        let scale = whole.abs().max(f64::MIN_POSITIVE);
        vec![Check::at_most("slewing_slope", &s::AGREEMENT, worst / scale, 1e-8)]
    }

    fn assumptions(this: &Description<SlewingScene>) -> Vec<&'static str> {
        let mut list = match (this.given.driven, this.given.swung) {
            (None, _) => vec!["slewing_level_static", "slewing_load"],
            (_, None) => vec!["slewing_level_rigid", "slewing_load"],
            (_, Some(_)) => {
                let damped = this.given.around.map_or("slewing_undamped", |_| "air");
                vec!["slewing_level_swing", damped, "slewing_hook"]
            }
        };
        list.extend(this.given.area.map(|_| WIND_ON_SLEWED));
        list.extend(this.given.coupling.map(|_| "slewing_coupling"));
        list.extend(taken(this.given.control.iter()));
        list
    }

    fn uncovered(this: &Description<SlewingScene>) -> Vec<&'static str> {
        let sway = this.given.swung.is_none().then_some("sway");
        let wind = match (this.given.around, this.given.area) {
            (Some(_), Some(_)) => None,
            (Some(_), None) => Some("wind_on_structure"),
            (None, Some(_)) => Some("wind_on_load"),
            (None, None) => Some("wind"),
        };
        let rest = [
            "dynamic_coefficients",
            "motor_brake",
            "strength",
            "stability",
            "load_cases",
        ];
        wind.into_iter().chain(sway).chain(rest).collect()
    }

    /// A load that swings stands where its rope and the angles of it put it; a controller has held the speed of the working
    /// range so far.
    fn arrange(&self, inputs: &mut Vec<Input>) {
        let mut stands = |chapter, symbol, value| {
            inputs.push(Input {
                symbol,
                value,
                number: None,
                chapter,
                given: None,
                on: None,
                usual: true,
            });
        };
        if let Some(load) = &self.given.swung {
            load.map(&mut |symbol, value| stands("hook", symbol, value));
        }
        if let Some(side) = &self.given.side {
            side.map(&mut |symbol, value| stands("coupled", symbol, value));
        }
        if let Some(latched) = &self.given.latched {
            latched.map(&mut |symbol, value| stands("latched", symbol, value));
        }
        if let Some(state) = &self.given.regulating {
            state.map(&mut |symbol, value| stands("latched", symbol, value));
        }
    }

    fn hangs_on(this: &Description<SlewingScene>) -> Option<[f64; 2]> {
        let Hung { g, .. } = this.given.hung;
        this.given.rope.map(|rope| [rope.l_r, g])
    }

    fn hang(&mut self, length: f64) {
        self.given.rope = Some(RopeLength { l_r: length });
        self.given.swung = Some(HangingLoad::resting(length, [0.0, 0.0]).into());
    }

    /// From above: the ends of the working range (faint) and its middle, with the load's circle.
    fn drawing(this: &Description<SlewingScene>, told: f64) -> Drawing {
        let (reach, range) = (this.given.hung.r.max(1e-3), &this.motion);
        let head = |psi: f64| polar(reach, psi);
        let mut draw = Draw::default();
        let axis = Point::zeros();
        draw.path(fine(range).map(head));
        for (psi, faint) in [(range.from, true), (range.to, true), (told, false)] {
            draw.bar(&[axis, head(psi)], faint);
            draw.pin(head(psi), false, faint);
        }
        draw.angle(axis, 0.3 * reach, told, &s::PSI_SL);
        draw.distance(axis, head(told), 0.06 * reach, &s::R);
        draw.handle(head(told), &[(&s::R, distance(axis))]);
        draw.joint(axis, "O", true, false);
        draw.done(reach)
    }
}
