//! The mechanism in motion as a running model: commands and parameters in,
//! states and results out. What follows from angle and angular velocity alone
//! comes from the algebraic model of the same scene.

use std::collections::{BTreeMap, BTreeSet};

use num_dual::Dual64;

use crate::component::dependencies::{dependencies, recorded};
use crate::component::running::{Running, State, Tangent};
use crate::component::standing::Standing;
use crate::kernel::calc::{Calc, Over};
use crate::kernel::number::short;
use crate::kernel::record::{self, Rec};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::unit;
use crate::kernel::variable::{Fault, Name, Quantity, Role, TIME, Terminal, Variable};
use crate::luffing::double_link::crane::REELED_IN;
use crate::luffing::double_link::dynamics::{Bodies, Body, Coordinate, Dynamics, Pendulum, Turntable};
use crate::luffing::double_link::forces_in_motion::{ForcesInMotion, RESULTS};
use crate::luffing::double_link::geometry::Geometry;
use crate::luffing::double_link::held::in_line;
use crate::luffing::double_link::hydraulic::{self, Crane, Hydraulic};
use crate::luffing::double_link::motion::{self, MovingLinkage};
use crate::luffing::double_link::moving::given::{Constants, Given, Inputs};
use crate::luffing::double_link::moving::hoisting::{HoistKind, HoistMotor, HoistRamp, LoadRope, RopeGive};
use crate::luffing::double_link::moving::level::{
    Level, MOST_INDICATORS, MOST_STATES, MotionResult, OIL_INDICATORS, Powers, Present,
};
use crate::luffing::double_link::moving::scene::Moving;
use crate::luffing::double_link::moving::symbols as m;
use crate::luffing::double_link::parameters::{Driven, Weights};
use crate::luffing::double_link::scene::Luffing;
use crate::luffing::double_link::slewing::{self, Slewing};
use crate::luffing::double_link::stages::{DoubleLink, parameters};
use crate::luffing::double_link::symbols as s;
use crate::parts::hoist::{Elastic, Hoist, Winch, WinchDrive};
use crate::parts::hydraulics::cylinder::Cylinder;
use crate::parts::hydraulics::oil::warning;
use crate::parts::hydraulics::symbols as h;
use crate::parts::hydraulics::valve::Valve;
use crate::parts::joint::{Bar, Friction, Joint};
use crate::parts::motion::Motion as Range;
use crate::parts::plane::Point;
use crate::parts::solver::{Count, Halt, MOST_IMPLICIT, MOST_STEPS};

/// Least pressure of the chambers at the start, in Pa.
const LEAST_PRESSURE: f64 = 20e5;

/// Natural frequency, in rad/s, of the mechanism alone against an end stop of the hydraulic level;
/// the stop is damped critically.
const STOP: f64 = 100.0;

/// What forces and moments of this model take into account.
const MOVING: &str = "In motion: with the inertia of all bodies, and the rope as it hangs.";
const GIVEN: &str = "In motion: what motor and brake, or the cylinder, give it.";
const AT_REST: &str = "As at rest: without inertia, the load hanging straight down.";

/// In the place of a parameter that is zero where it is asked what depends on what.
const TRACE: f64 = 1e-6;

/// A scene's mechanism in motion.
#[derive(Clone)]
pub struct LuffingMotion {
    algebraic: Standing,
    driven: Driven,
    range: Range,
    rope: Option<LoadRope>,
    /// Where the crane slews.
    slewing_stops: Option<[f64; 2]>,
    variables: Vec<Variable>,
    slots: Vec<Slot>,
    /// Numbers of continuous states and of event indicators.
    states: usize,
    indicators: usize,
    /// Follows from the parameters; `None` after one has changed.
    level: Option<Level>,
    now: Now,
    /// Of the present states and inputs; found when first asked for.
    forces: Option<ForcesInMotion<f64>>,
    /// Work of the solver so far; no part of the state.
    count: Count,
}

/// All that changes while it runs, besides the algebraic model.
#[derive(Clone, Copy, Debug)]
struct Now {
    /// In s.
    time: f64,
    present: Present,
    given: Given,
}

/// All that changes while it runs.
struct Saved {
    now: Now,
    algebraic: State,
}

/// Results with their derivatives in one direction of states, inputs and parameters.
struct Direction {
    algebraic: Tangent,
    level: Result<Level<Dual64>, Fault>,
    given: Given<Dual64>,
    y: [Dual64; MOST_STATES],
    /// Made when first asked for.
    rates: Option<[Dual64; MOST_STATES]>,
    forces: Option<ForcesInMotion<Dual64>>,
}

#[derive(Clone, Copy, Debug)]
enum Slot {
    State(usize),
    Rate(usize),
    Indicator(usize),
    /// Of what is [given](Given).
    Given,
    Reaction(MotionResult),
    /// One of the [results](forces_in_motion::RESULTS).
    Force(usize),
    Cavitates,
    /// Index of a variable of the algebraic model.
    Algebraic(usize),
}

impl LuffingMotion {
    /// # Errors
    /// The cylinder cannot hold the crane at the start. A scene that was read has a mechanism.
    pub fn new(luffing: &Luffing, moving: &Moving) -> Result<LuffingMotion, Fault> {
        LuffingMotion::starting(luffing, moving, luffing.motion.from)
    }

    /// At rest at an angle of the driven bar, in rad.
    ///
    /// # Errors
    /// As [`new`](LuffingMotion::new).
    pub(crate) fn starting(luffing: &Luffing, moving: &Moving, theta: f64) -> Result<LuffingMotion, Fault> {
        let algebraic = luffing.standing();
        let Moving {
            rope,
            oil,
            inputs,
            constants,
            slewing,
            ramp: _,
        } = *moving;
        let mut start = motion::MotionState::resting(theta, rope.map_or(0.0, |rope| rope.length));
        start.y[2] = rope.map_or(0.0, |rope| rope.swing);
        let present = match slewing {
            None => Present::Free(start),
            Some(turn) => {
                let mut start = slewing::SlewingState::resting(start.y[0], start.y[4]);
                start.put_load([rope.map_or(0.0, |rope| rope.swing), turn.side]);
                start.y[2..4].copy_from_slice(&turn.joint.start);
                Present::Slewing(start)
            }
        };
        let kind = rope.map_or(HoistKind::AtOnce, |rope| rope.hoist);
        let speed = match kind {
            HoistKind::AtOnce => inputs.hoist.speed,
            HoistKind::Ramp(_) | HoistKind::Motor(_) => 0.0,
        };
        let mut model = LuffingMotion {
            driven: luffing.parameters.driven,
            range: luffing.motion,
            rope,
            slewing_stops: slewing.map(|turn| turn.joint.stops),
            variables: Vec::new(),
            slots: Vec::new(),
            states: 0,
            indicators: 0,
            count: Count::default(),
            level: None,
            forces: None,
            now: Now {
                time: 0.0,
                present,
                given: Given {
                    inputs,
                    constants,
                    hoist: kind,
                    give: rope.and_then(|rope| rope.give),
                    turning: slewing.map(|turn| turn.joint.turning),
                    oil,
                },
            },
            algebraic,
        };
        if oil.is_some() {
            model.now.present = model.held_by_oil(&model.now.present, theta)?;
        }
        if let Some(give) = model.now.given.give {
            let stretch = model.weight() / give.c_r;
            model.now.present.stretch(stretch, slewing.is_some());
        }
        if rope.is_some() {
            model.wind(speed);
        }
        for (variable, slot) in model.list() {
            model.states += usize::from(variable.role == Role::State);
            model.indicators += usize::from(variable.role == Role::Indicator);
            model.variables.push(variable);
            model.slots.push(slot);
        }
        model.update()?;
        Ok(model)
    }

    /// A cylinder's start: the valve closed, the oil carrying the crane, which else stands and hangs as without oil.
    fn held_by_oil(&self, crane: &Present, theta: f64) -> Result<Present, Fault> {
        let present = match self.assemble()? {
            Level::Fixed(system) => {
                (system.resting(theta, LEAST_PRESSURE)).map(|y| Present::Fixed(hydraulic::PresentCrane::new(y)))
            }
            Level::Hanging(system) => system.resting(theta, LEAST_PRESSURE).map(|mut y| {
                match crane {
                    Present::Slewing(state) => hydraulic::put(&mut y, &state.y),
                    Present::Free(state) => hydraulic::put(&mut y, &state.y),
                    Present::Fixed(_) | Present::Hanging(_) => {}
                }
                Present::Hanging(hydraulic::PresentCrane::new(y))
            }),
            Level::Free(_) | Level::Slewing(_) => None,
        };
        present.ok_or_else(|| {
            Fault::outside("the cylinder has no lever arm at the start of the working range: it cannot hold the crane")
        })
    }

    /// Variables of a scene: the coordinate first, then other states, inputs, constants and results of
    /// motion, then those of the algebraic model, then rates and event indicators.
    fn list(&self) -> Vec<(Variable, Slot)> {
        let mut list = Vec::new();
        let of = |symbol: &'static Symbol, role| Variable::new((symbol, None), role);
        let boom = self.driven == Driven::Boom;
        let coordinate = if boom {
            [&s::THETA_1, &s::OMEGA_1]
        } else {
            [&s::THETA_3, &s::OMEGA_3]
        };
        let states = self.of_level(
            coordinate,
            [&m::PSI_SL, &m::OMEGA_SL],
            [&m::X_Q, &m::Y_Q, &m::Z_Q, &m::V_QX, &m::V_QY, &m::V_QZ],
            [&m::PHI_R, &m::OMEGA_R],
            [&m::L_R, &m::S_Q, &m::V_Q, &m::V_R],
            [&m::P_1, &m::P_2, &m::P_A, &m::P_B, &m::X_V, &m::V_V],
        );
        for (i, symbol) in states.into_iter().enumerate() {
            list.push((of(symbol, Role::State), Slot::State(i)));
        }
        list.extend(self.commands());
        let (given, mut constant) = (self.now.given, |symbol, _| {
            list.push((of(symbol, Role::Parameter), Slot::Given));
        });
        given.constants.map(&mut constant);
        given.hoist.map(&mut constant);
        given.give.map(|give| give.map(&mut constant));
        given.turning.map(|turning| turning.map(&mut constant));
        given.oil.map(|oil| oil.map(&mut constant));
        list.extend(self.reactions());
        for (index, variable) in self.algebraic.variables().iter().enumerate() {
            if coordinate.contains(&variable.symbol) {
                continue;
            }
            let in_motion = RESULTS.iter().position(|symbol| *symbol == variable.symbol);
            let (mut variable, mut slot) = (*variable, Slot::Algebraic(index));
            let is_result = matches!(variable.role, Role::Output | Role::Calculated);
            if let Some(force) = in_motion {
                let remark = if variable.symbol == &s::M_D { GIVEN } else { MOVING };
                (variable.remark, slot) = (Some(remark), Slot::Force(force));
            } else if is_result && variable.symbol.unit.dimension.kg != 0 {
                variable.remark = Some(AT_REST);
            }
            list.push((variable, slot));
        }
        let rates = self.of_level(
            if boom {
                [&m::D_THETA_1, &m::D_OMEGA_1]
            } else {
                [&m::D_THETA_3, &m::D_OMEGA_3]
            },
            [&m::D_PSI_SL, &m::D_OMEGA_SL],
            [&m::D_X_Q, &m::D_Y_Q, &m::D_Z_Q, &m::D_V_QX, &m::D_V_QY, &m::D_V_QZ],
            [&m::D_PHI_R, &m::D_OMEGA_R],
            [&m::D_L_R, &m::D_S_Q, &m::D_V_Q, &m::D_V_R],
            [&m::D_P_1, &m::D_P_2, &m::D_P_A, &m::D_P_B, &m::D_X_V, &m::D_V_V],
        );
        for (i, symbol) in rates.into_iter().enumerate() {
            list.push((of(symbol, Role::Rate), Slot::Rate(i)));
        }
        for (i, symbol) in self.watched().into_iter().enumerate() {
            list.push((of(symbol, Role::Indicator), Slot::Indicator(i)));
        }
        list
    }

    /// Inputs of drives, brakes and hoist.
    fn commands(&self) -> Vec<(Variable, Slot)> {
        let mut inputs = if self.now.given.oil.is_some() {
            listed!(m: U_V, P_P).to_vec()
        } else {
            listed!(m: M_A, M_S).to_vec()
        };
        if self.has_motor() {
            inputs.extend(listed!(m: M_M_H, M_B_H));
        } else if self.rope.is_some() {
            inputs.push(&m::V_H);
        }
        if self.slewing_stops.is_some() {
            inputs.extend(listed!(m: M_SL, M_B_SL));
        }
        let variable = |symbol: &'static Symbol| Variable {
            at_events: symbol == &m::V_H,
            ..Variable::new((symbol, None), Role::Input)
        };
        inputs
            .into_iter()
            .map(|symbol| (variable(symbol), Slot::Given))
            .collect()
    }

    /// Results that only motion has.
    fn reactions(&self) -> Vec<(Variable, Slot)> {
        let of = |symbol: &'static Symbol, reaction| {
            let variable = Variable::new((symbol, None), Role::Output);
            (variable, Slot::Reaction(reaction))
        };
        let hydraulic = self.now.given.oil.is_some();
        let (reeled, slews) = (self.rope.is_some(), self.slewing_stops.is_some());
        let mut list = Vec::new();
        if hydraulic {
            list.push(of(&m::F_C, MotionResult::Cylinder));
        }
        list.push(of(&m::M_R, MotionResult::Friction));
        if reeled {
            list.push(of(&m::S_R, MotionResult::Rope));
        }
        if let HoistKind::Motor(_) = self.now.given.hoist {
            list.push(of(&m::M_R_H, MotionResult::Drum));
        }
        let force = |symbol: &'static Symbol| {
            let index = RESULTS.iter().position(|known| *known == symbol);
            let slot = Slot::Force(index.expect("one of the forces"));
            (Variable::new((symbol, None), Role::Output), slot)
        };
        let on_head: &[&Symbol] = if reeled { listed!(m: F_AX, F_AY) } else { &[] };
        list.extend(
            on_head
                .iter()
                .chain(listed!(m: M_RC, M_RV, M_RS))
                .map(|symbol| force(symbol)),
        );
        if !hydraulic || reeled || slews {
            list.push(of(&m::W_BLOW, MotionResult::Blows));
        }
        if slews {
            list.push(of(&m::M_R_SL, MotionResult::SlewingFriction));
            if reeled {
                list.push(of(&m::PHI_R, MotionResult::Swing));
                list.push(of(&m::CHI_R, MotionResult::Side));
                list.push(of(&m::S_Q, MotionResult::Distance));
            }
        }
        if hydraulic {
            list.push((Variable::new((&h::CAVITATES, None), Role::Output), Slot::Cavitates));
        }
        list
    }

    /// Event indicators.
    fn watched(&self) -> Vec<&'static Symbol> {
        let mut watched: Vec<&'static Symbol> = if self.now.given.oil.is_some() {
            vec![
                &m::Z_SPOOL,
                &m::Z_RELIEF_1,
                &m::Z_RELIEF_2,
                &m::Z_LOW,
                &m::Z_HIGH,
                &h::Z_VACUUM,
            ]
        } else {
            vec![&m::Z_REST, &m::Z_LOOSE, &m::Z_LOW, &m::Z_HIGH]
        };
        if self.slewing_stops.is_some() {
            watched.extend([&m::Z_SL_REST, &m::Z_SL_LOOSE, &m::Z_SL_LOW, &m::Z_SL_HIGH]);
        }
        if self.rope.is_some() {
            watched.push(&m::Z_ROPE);
        }
        match self.now.given.hoist {
            HoistKind::AtOnce => {}
            HoistKind::Ramp(_) => watched.push(&m::Z_HOIST),
            HoistKind::Motor(_) => watched.extend([&m::Z_DRUM_REST, &m::Z_DRUM_LOOSE]),
        }
        watched
    }

    /// What stands for each state of this level, out of those of all levels.
    fn of_level(
        &self,
        coordinate: [&'static Symbol; 2],
        slewing: [&'static Symbol; 2],
        load: [&'static Symbol; 6],
        swing: [&'static Symbol; 2],
        reel: [&'static Symbol; 4],
        oil: [&'static Symbol; 6],
    ) -> Vec<&'static Symbol> {
        let mut symbols = coordinate.to_vec();
        if self.now.given.oil.is_some() {
            symbols.extend(oil);
        }
        let (slews, reeled) = (self.slewing_stops.is_some(), self.rope.is_some());
        if slews {
            symbols.extend(slewing);
        }
        match (slews, reeled) {
            (true, true) => {
                symbols.extend(load);
                symbols.push(reel[0]);
            }
            (false, true) => {
                symbols.extend(swing);
                symbols.extend(&reel[..3]);
            }
            (_, false) => {}
        }
        if !self.follows_at_once() {
            symbols.push(reel[3]);
        }
        symbols
    }

    /// The hoist runs at a rate of paying out (m/s), and so does the load.
    fn wind(&mut self, rate: f64) {
        let slews = self.slewing_stops.is_some();
        self.now.present.wind(rate, slews);
        if self.now.given.give.is_some() {
            self.now.present.follow(slews);
        }
    }

    /// Of the load, in N.
    fn weight(&self) -> f64 {
        let load = self.algebraic.of::<DoubleLink>().given().load;
        load.map_or(0.0, |load| load.1)
    }

    fn has_motor(&self) -> bool {
        matches!(self.now.given.hoist, HoistKind::Motor(_))
    }

    /// Whether the hoist comes up to its command with an acceleration.
    fn is_ramp(&self) -> bool {
        matches!(self.now.given.hoist, HoistKind::Ramp(_))
    }

    /// Whether the rope is paid out as commanded, at any instant.
    fn follows_at_once(&self) -> bool {
        matches!(self.now.given.hoist, HoistKind::AtOnce)
    }

    /// The equations of motion with the present parameters and inputs.
    fn level(&mut self) -> Result<&Level, Fault> {
        if self.level.is_none() {
            self.level = Some(self.assemble()?);
        }
        Ok(self.level.as_ref().expect("assembled above"))
    }

    fn assemble(&self) -> Result<Level, Fault> {
        self.assemble_over(&mut |_, value| value)
    }

    /// The equations of motion over any scalar: `of` gives each input and parameter in it.
    fn assemble_over<P: Coordinate<P>>(&self, of: &mut dyn FnMut(&'static Symbol, f64) -> P) -> Result<Level<P>, Fault>
    where
        Dual64: Over<P>,
    {
        let Given {
            inputs,
            constants,
            hoist,
            give,
            turning,
            oil,
        } = self.now.given.map(of);
        let parameters = parameters(self.algebraic.of::<DoubleLink>().given());
        let load = (of(&s::Q, self.weight()) / constants.g).def(&m::MASS_Q);
        let mut hoist = Hoist {
            winch: winch(&hoist),
            rope: give.map(|RopeGive { c_r, d_r }| Elastic {
                stiffness: c_r,
                damping: d_r,
            }),
        };
        if load.value() == 0.0 {
            // With nothing on it a rope is not stretched: the limit of ever lighter loads.
            hoist.rope = None;
        }
        let over = parameters.map(of);
        let geometry = Geometry::new(&over).map_err(|misfit| {
            let words = parameters.describe(misfit);
            Fault::outside(format!("{}; {}", words.what, words.help))
        })?;
        let weights = over.weights.expect("checked when the scene was read");
        let bodies = self.bodies_over(&geometry, &weights, &constants, (load, hoist));
        let mut dynamics = Dynamics::new(&geometry, bodies)
            .with_balance(&over, &self.range)
            .map_err(|fault| Fault::outside(fault.to_string()))?;
        let joint = |viscous, coulomb, stops| Joint {
            friction: Friction { viscous, coulomb },
            stops,
        };
        let luffing = joint(constants.c_v, constants.m_f, self.stops());
        let slewing = (turning.zip(self.slewing_stops)).map(|(t, stops)| joint(t.c_sl, t.m_f_sl, stops));
        if let Some(turning) = turning {
            dynamics = dynamics.with_slewing(Turntable {
                axis: -geometry.lengths.x_8,
                inertia: turning.j_sl,
            });
        }
        if let Some(anchors) = &over.anchors {
            dynamics = dynamics.with_drive(anchors, oil.is_some());
        }
        let Some(oil) = oil else {
            return Ok(match crane(dynamics, luffing, slewing) {
                Crane::Plane(motion) => Level::Free(motion),
                Crane::Slewing(slewing) => Level::Slewing(slewing),
            });
        };
        let bore = over.cylinder.expect("checked when the scene was read");
        let cylinder = Cylinder {
            areas: Cylinder::areas(bore.d_c, bore.d_r),
            lengths: [oil.l_min, oil.l_max],
            dead_volume: oil.v_0,
            port_volume: oil.v_1,
            line: Valve::rated(oil.q_n, oil.dp_l),
            leakage: oil.k_l,
            bulk_modulus: oil.beta_e,
            relief: [oil.p_r, oil.k_r],
            valve: Valve {
                conductance: Valve::rated(oil.q_n, oil.dp_n),
                overlap: P::constant(0.0),
                frequency: oil.omega_v,
                damping: oil.zeta_v,
            },
        };
        let start = P::reduced(&dynamics, P::constant(self.range.from));
        let inertia = start.map_or(P::constant(0.0), |r| r.inertia);
        let stop = P::known(&m::OMEGA_S, STOP);
        let (stiffness, damping) = (inertia * stop.square(), inertia * P::constant(2.0) * stop);
        let buffer = [stiffness.def(&m::K_S), damping.def(&m::D_S)];
        let crane = crane(dynamics, luffing, slewing);
        if self.rope.is_some() || self.slewing_stops.is_some() {
            Ok(Level::Hanging(hydraulic(crane, cylinder, buffer, &inputs)))
        } else {
            Ok(Level::Fixed(hydraulic(crane, cylinder, buffer, &inputs)))
        }
    }

    fn bodies_over<P: Coordinate<P>>(
        &self,
        geometry: &Geometry<P>,
        weights: &Weights<P>,
        constants: &Constants<P>,
        (load, hoist): (P, Hoist<P>),
    ) -> Bodies<P> {
        // Boom and rocker lie along their bars, the jib along the line from its tail to its head.
        let bar = Point::new(P::constant(1.0), P::constant(0.0));
        let head = Point::new(geometry.kappa.x, -geometry.kappa.y) * geometry.lengths.x_2;
        let axis = head - bar * geometry.lengths.x_2;
        let body = |weight: P, inertia: P, distance: P, angle: P, along: Point<P>| {
            let (sin, cos) = angle.sin_cos();
            let centre = Point::new(distance * cos, distance * sin);
            Body::slender(weight / constants.g, inertia, centre, along)
        };
        let jib = body(weights.g_2, constants.j_2, weights.s_2, weights.chi_2, axis);
        let pendulum = self.rope.map(|rope| Pendulum {
            mass: load,
            length: P::known(&m::L_R, rope.length),
            hoist,
        });
        Bodies {
            boom: body(weights.g_1, constants.j_1, weights.s_1, weights.chi_1, bar),
            jib: if pendulum.is_some() {
                jib
            } else {
                let loaded = jib.with_mass(load, head);
                Body {
                    inertia: loaded.inertia.def(&m::J_2Q),
                    ..loaded
                }
            },
            rocker: body(weights.g_3, constants.j_3, weights.s_3, weights.chi_3, bar),
            pendulum,
            gravity: constants.g,
        }
    }

    fn stops(&self) -> [f64; 2] {
        [self.range.from, self.range.to]
    }

    /// Brings the algebraic model to the present angle and angular velocity.
    fn follow(&mut self) -> Result<(), Fault> {
        self.forces = None;
        let y = self.now.present.states();
        self.algebraic.set(0, y[0])?;
        self.algebraic.set(1, y[1])
    }

    /// A parameter has changed.
    fn changed(&mut self) {
        self.level = None;
        self.now.present.interrupt();
    }

    /// Inputs of the hydraulic level have changed.
    fn commanded(&mut self) {
        self.now.present.interrupt();
        if let Some(level) = &mut self.level {
            level.set_inputs(&self.now.given.inputs);
        }
    }

    fn refusal(&self, halt: Halt, size: f64) -> Fault {
        let (symbol, at) = (self.variables[0].symbol, self.now.present.states()[0]);
        let angle = format!("{} = {}", symbol.id, symbol.written(at));
        let (size, step) = (short(size), short(self.now.given.constants.step));
        let most = if self.now.given.oil.is_some() {
            MOST_IMPLICIT
        } else {
            MOST_STEPS
        };
        Fault::outside(match halt {
            Halt::Outside => format!(
                "the motion from {angle} ends within {size} s where the linkage does not close, nothing is left of \
                 the rope, or beyond all reasonable numbers: keep the working range away from dead points, reel in \
                 less, or command less"
            ),
            Halt::TooFast => format!(
                "inner steps of {step} s are too long for the motion from {angle}, which changes by more than itself \
                 within one: set step below {} s, or make the rope longer or the friction less",
                short(self.now.given.constants.step / 2.0)
            ),
            Halt::TooSmall | Halt::TooMany => format!(
                "the step of {size} s from {angle} needs more than the {most} inner steps that are allowed, \
                 at step = {step} s: take smaller communication steps, a longer step or a coarser tolerance"
            ),
        })
    }

    /// Refuses a step in which all of the rope is reeled in: its end would be sought in ever smaller inner steps.
    fn enough_rope(&self, size: f64) -> Result<(), Fault> {
        let (hoist, states) = (self.paying_out(size), self.now.present.states());
        let length = self.variables[..self.states]
            .iter()
            .zip(states)
            .find(|(v, _)| v.symbol.id == m::L_R.id);
        match length {
            Some((variable, length)) if length + hoist <= REELED_IN => Err(Fault::outside(format!(
                "at {} = {} nothing is left of the rope of {} = {} within {} s: reel in less",
                m::V_H.id,
                m::V_H.written(self.now.given.inputs.hoist.speed),
                m::L_R.id,
                variable.symbol.written(length),
                short(size)
            ))),
            _ => Ok(()),
        }
    }

    /// How much rope the hoist pays out within a time (s), in m.
    fn paying_out(&self, size: f64) -> f64 {
        let command = self.now.given.inputs.hoist.speed;
        let a_h = match self.now.given.hoist {
            HoistKind::AtOnce => return command * size,
            HoistKind::Ramp(HoistRamp { a_h }) => a_h,
            // Its load decides.
            HoistKind::Motor(_) => return 0.0,
        };
        let rate = self.now.present.paid_out(self.slewing_stops.is_some());
        let change = command - rate;
        let time = size.min(change.abs() / a_h);
        rate * time + change.signum() * 0.5 * a_h * time * time + command * (size - time)
    }

    fn forces(&mut self) -> Result<&ForcesInMotion<f64>, Fault> {
        if self.forces.is_none() {
            let (present, inputs, y) = (self.now.present, self.now.given.inputs, self.now.present.states());
            self.forces = self.level()?.forces(&present, &inputs, &y);
        }
        self.forces.as_ref().ok_or_else(|| self.open())
    }

    fn all_rates(&mut self, rates: &mut [f64; MOST_STATES]) -> Result<(), Fault> {
        let (present, inputs, y) = (self.now.present, self.now.given.inputs, self.now.present.states());
        let found = self.level()?.rates(&present, &inputs, &y, rates);
        found.ok_or_else(|| self.open())
    }

    fn open(&self) -> Fault {
        let (symbol, at) = (self.variables[0].symbol, self.now.present.states()[0]);
        Fault::outside(format!(
            "the linkage does not close at {} = {}",
            symbol.id,
            symbol.written(at)
        ))
    }

    fn in_line(&self) -> Fault {
        in_line(self.variables[0].symbol, self.now.present.states()[0])
    }

    /// The states over any scalar.
    fn states_over<P: Calc>(&self, of: &mut impl FnMut(&'static Symbol, f64) -> P) -> [P; MOST_STATES] {
        let states = self.now.present.states();
        // A hoist that follows its command at once runs as commanded.
        let winding = self.now.present.winding(self.slewing_stops.is_some());
        let commanded = (self.rope.is_some() && self.follows_at_once()).then_some(winding);
        std::array::from_fn(|i| match self.variables.get(i).filter(|_| i < self.states) {
            Some(variable) => of(variable.symbol, states[i]),
            None if Some(i) == commanded => of(&m::V_H, states[i]),
            None => P::constant(states[i]),
        })
    }

    /// Powers as it is now, and the energy (J) of all bodies with what blows have taken so far.
    ///
    /// # Errors
    /// The linkage does not close.
    pub(crate) fn powers(&mut self) -> Result<(Powers, f64), Fault> {
        let (present, inputs) = (self.now.present, self.now.given.inputs);
        let found = self.level()?.powers(&present, &inputs);
        let (powers, energy) = found.ok_or_else(|| self.open())?;
        Ok((powers, energy + present.blown()))
    }

    /// Energy of the bodies' motion as it is now, in J.
    ///
    /// # Errors
    /// The linkage does not close.
    pub(crate) fn kinetic(&mut self) -> Result<f64, Fault> {
        let (present, inputs) = (self.now.present, self.now.given.inputs);
        let level = self.level()?;
        let energies = [present, level.still(&present)].map(|present| Some(level.powers(&present, &inputs)?.1));
        match energies {
            [Some(moving), Some(still)] => Ok(moving - still),
            _ => Err(self.open()),
        }
    }

    /// How far the moment on the driven bar by equilibrium of the moving bodies is from that of drive, friction and end
    /// stop, and the greatest of what they are made of, in N·m; `None` where there are no finite forces.
    pub(crate) fn apart(&mut self) -> Option<[f64; 2]> {
        self.forces().ok()?.apart()
    }

    pub(crate) fn present(&self) -> &Present {
        &self.now.present
    }

    /// Runs the equations of motion as they are now under the recorder. Returns how many steps were recorded while
    /// they were assembled.
    pub(crate) fn recorded(&self) -> usize {
        let level = self.assemble_over(&mut Rec::given);
        let (inputs, y) = (
            self.now.given.inputs.map(&mut Rec::given),
            self.states_over(&mut Rec::given),
        );
        let assembled = record::steps();
        if let Ok(level) = level {
            let (present, mut rates) = (&self.now.present, y);
            let _ = level.rates(present, &inputs, &y, &mut rates);
            if self.rope.is_some() {
                let _ = level.reaction(present, &inputs, &y, MotionResult::Rope);
            }
            let _ = level.forces(present, &inputs, &y);
        }
        assembled
    }

    /// What each variable depends on: results of the position on angle and angular velocity in the place
    /// of the time; rates, event indicators and reactions on whatever has a derivative in any of many
    /// lively states, in every one of the level's ways of moving.
    #[must_use]
    pub fn dependencies(&self) -> Vec<BTreeSet<Name>> {
        let name = |variable: &Variable| -> Name { (variable.symbol.id, variable.number) };
        let algebraic = dependencies(&self.algebraic, recorded::<DoubleLink>);
        let pressures = || {
            [&m::P_1, &m::P_2, &m::P_A, &m::P_B]
                .map(|symbol| (symbol.id, None))
                .into()
        };
        let of = |slot: &Slot| match *slot {
            Slot::State(i) => BTreeSet::from([name(&self.variables[i])]),
            Slot::Algebraic(inner) => {
                let found = algebraic[inner].iter().copied();
                found.filter(|name| *name != (TIME.id, None)).collect()
            }
            // Any of them may be the least.
            Slot::Cavitates => pressures(),
            Slot::Indicator(i) if i + 1 == OIL_INDICATORS && self.now.given.oil.is_some() => pressures(),
            // Decided at events.
            Slot::Rate(i) if self.variables[i].symbol == &m::V_R && self.is_ramp() => {
                BTreeSet::from([(m::V_H.id, None)])
            }
            _ => BTreeSet::new(),
        };
        let mut found: Vec<BTreeSet<Name>> = self.slots.iter().map(of).collect();
        let mut lively = self.clone();
        for index in 0..lively.slots.len() {
            // What is zero now may hide what else acts: an arm that weighs nothing, a gap that lets nothing pass.
            if lively.check(index, TRACE).is_ok() && lively.get(index) == Ok(0.0) {
                let _ = lively.set(index, TRACE);
            }
        }
        let moves = |slot: &Slot| {
            matches!(
                slot,
                Slot::Rate(_) | Slot::Indicator(_) | Slot::Reaction(_) | Slot::Force(_)
            )
        };
        let moving: Vec<usize> = (0..self.slots.len()).filter(|i| moves(&self.slots[*i])).collect();
        let given = |v: &&Variable| matches!(v.role, Role::Input | Role::Parameter | Role::Tunable | Role::State);
        let givens: Vec<Name> = self.variables.iter().filter(given).map(name).collect();
        let opening = self.now.given.oil.map_or(0.0, |oil| oil.p_r);
        let slews = self.slewing_stops.is_some();
        for present in self.now.present.lively(self.stops(), opening, slews) {
            lively.now.present = present;
            if !lively.follows_more(&moving, &givens, &found) {
                continue;
            }
            for known in &givens {
                let mut tangent = lively.tangent(&|(symbol, number)| f64::from((symbol.id, number) == *known));
                for &index in &moving {
                    if lively.derivative(&mut tangent, index) != Ok(0.0) {
                        found[index].insert(*known);
                    }
                }
            }
        }
        found
    }

    /// Whether one of these results changes where all changes at once that it is not known to follow from.
    fn follows_more(&self, results: &[usize], givens: &[Name], found: &[BTreeSet<Name>]) -> bool {
        let mut alike: BTreeMap<&BTreeSet<Name>, Vec<usize>> = BTreeMap::new();
        for &index in results {
            alike.entry(&found[index]).or_default().push(index);
        }
        alike.into_iter().any(|(known, results)| {
            // No two of them by the same amount, so that nothing cancels.
            let open = givens.iter().zip(1_u32..).filter(|(name, _)| !known.contains(name));
            let seeds: BTreeMap<Name, f64> = open.map(|(name, i)| (*name, f64::from(i).sqrt())).collect();
            let seed = |(symbol, number): Quantity| seeds.get(&(symbol.id, number)).copied().unwrap_or(0.0);
            let mut tangent = self.tangent(&seed);
            let mut results = results.into_iter();
            results.any(|index| self.derivative(&mut tangent, index) != Ok(0.0))
        })
    }

    /// Whether it may be set from outside: what else stands among the [given](Given) numbers acts on nothing.
    fn is_given(&self, symbol: &Symbol) -> bool {
        let mut all = self.variables.iter().zip(&self.slots);
        all.any(|(variable, slot)| matches!(slot, Slot::Given) && variable.symbol == symbol)
    }

    fn slot(&self, index: usize) -> Result<Slot, Fault> {
        let found = self.slots.get(index).copied();
        found.ok_or_else(|| Fault::no_variable(index, self.slots.len()))
    }
}

impl Running for LuffingMotion {
    fn variables(&self) -> &[Variable] {
        &self.variables
    }

    fn terminals(&self) -> Vec<Terminal> {
        self.algebraic.terminals()
    }

    fn positions(&self) -> Vec<f64> {
        self.algebraic.positions()
    }

    fn stop_time(&self) -> f64 {
        self.algebraic.stop_time()
    }

    fn step_size(&self) -> f64 {
        // A thousandth of what a communication step may take: an importer sees that it goes on.
        self.algebraic
            .step_size()
            .min(1e-3 * f64::from(MOST_STEPS) * self.now.given.constants.step)
    }

    fn place(&mut self, theta: f64) -> Result<(), Fault> {
        self.set(0, theta)?;
        self.set(1, self.range.speed)?;
        match &mut self.now.present {
            Present::Free(state) => state.joints[0] = Bar::Forward,
            Present::Slewing(state) => state.joints[0] = Bar::Forward,
            Present::Fixed(_) | Present::Hanging(_) => {}
        }
        Ok(())
    }

    fn get(&mut self, index: usize) -> Result<f64, Fault> {
        match self.slot(index)? {
            Slot::State(i) => Ok(self.now.present.states()[i]),
            Slot::Rate(i) => {
                let mut rates = [0.0; MOST_STATES];
                self.all_rates(&mut rates)?;
                Ok(rates[i])
            }
            Slot::Indicator(i) => {
                let mut indicators = [0.0; MOST_INDICATORS];
                self.event_indicators(&mut indicators)?;
                Ok(indicators[i])
            }
            Slot::Given => {
                let (wanted, mut found) = (self.variables[index].symbol, f64::NAN);
                self.now.given.map(&mut |symbol, value| {
                    if symbol == wanted {
                        found = value;
                    }
                });
                Ok(found)
            }
            Slot::Reaction(reaction) => {
                let (present, inputs, y) = (self.now.present, self.now.given.inputs, self.now.present.states());
                let found = self.level()?.reaction(&present, &inputs, &y, reaction);
                found.ok_or_else(|| self.open())
            }
            Slot::Force(i) => self.forces()?.results()[i].ok_or_else(|| self.in_line()),
            Slot::Cavitates => {
                let mut rates = [0.0; MOST_STATES];
                self.all_rates(&mut rates)?;
                let oil = self.now.present.oil();
                Ok(f64::from(
                    oil.is_some_and(|oil| oil.cavitates(|| [2, 3, 4, 5].map(|i| rates[i]))),
                ))
            }
            Slot::Algebraic(inner) => self.algebraic.get(inner),
        }
    }

    fn check(&self, index: usize, value: f64) -> Result<(), Fault> {
        let (slot, variable) = (self.slot(index)?, &self.variables[index]);
        match slot {
            Slot::Algebraic(inner) => self.algebraic.check(inner, value),
            Slot::Rate(_) | Slot::Indicator(_) | Slot::Reaction(_) | Slot::Force(_) | Slot::Cavitates => {
                Err(Fault::new(format!("{variable} is a result and cannot be set")))
            }
            _ => variable.check(value),
        }
    }

    fn set(&mut self, index: usize, value: f64) -> Result<(), Fault> {
        self.check(index, value)?;
        self.forces = None;
        let slot = self.slots[index];
        match slot {
            Slot::State(i) => {
                let mut y = self.now.present.states();
                y[i] = value;
                // A taut rope is as long as the load is far.
                let length = self.variables[i].symbol == &m::L_R;
                let empty = self.weight() == 0.0;
                let kept = (self.now.given.give.is_none() || empty) && self.now.present.is_taut();
                if length && self.slewing_stops.is_none() && kept {
                    y[i + 1] = value;
                }
                self.now.present.set_states(&y[..self.states]);
                // Which way a bar goes is decided again: it did not turn round, it was set.
                match (&mut self.now.present, i) {
                    (Present::Free(state), 1) => state.joints[0] = Bar::Held,
                    (Present::Slewing(state), 1 | 3) => state.joints[i / 2] = Bar::Held,
                    (Present::Hanging(present), _) if self.variables[i].symbol == &m::OMEGA_SL => {
                        present.modes.slewing = Bar::Held;
                    }
                    _ => {}
                }
                if self.variables[i].symbol == &m::V_R && self.has_motor() {
                    self.now.present.free_drum();
                }
                self.follow()?;
            }
            // An importer that repeats itself does not interrupt the solver.
            Slot::Given if self.get(index) != Ok(value) => {
                let Variable { symbol, role, .. } = self.variables[index];
                self.now.given = (self.now.given).map(&mut |known, old| if known == symbol { value } else { old });
                match role {
                    Role::Input => self.commanded(),
                    _ => self.changed(),
                }
            }
            Slot::Algebraic(inner) if self.algebraic.get(inner) != Ok(value) => {
                self.algebraic.set(inner, value)?;
                self.changed();
            }
            _ => {}
        }
        Ok(())
    }

    fn set_time(&mut self, time: f64) {
        self.now.time = time;
    }

    fn advance(&mut self, from: f64, to: f64) -> Result<(), Fault> {
        let (before, inputs, step) = (self.now.present, self.now.given.inputs, self.now.given.constants.step);
        let relative = self.now.given.oil.map_or(0.0, |oil| oil.tol);
        self.enough_rope(to - from)?;
        let mut present = before;
        let solved = self.level()?.advance(&mut present, &inputs, to - from, step, relative);
        let work = solved.map_err(|halt| self.refusal(halt, to - from))?;
        self.count = self.count.and(work);
        self.now.present = present;
        let reached = self.follow().and_then(|()| self.algebraic.update());
        match reached {
            Ok(()) => self.now.time = to,
            Err(_) => {
                self.now.present = before;
                self.follow()?;
            }
        }
        reached
    }

    fn start(&mut self) -> Result<(), Fault> {
        if self.rope.is_some() && self.follows_at_once() {
            // What is commanded at the start was so before.
            self.wind(self.now.given.inputs.hoist.speed);
        }
        self.update()
    }

    fn update(&mut self) -> Result<(), Fault> {
        self.event()?;
        self.algebraic.update()
    }

    fn event(&mut self) -> Result<bool, Fault> {
        let (before, inputs) = (self.now.present, self.now.given.inputs);
        let mut present = before;
        let decided = self.level()?.event(&mut present, &inputs);
        decided.map_err(|_| self.open())?;
        self.now.present = present;
        self.follow()?;
        Ok(present.states() != before.states())
    }

    fn warning(&self) -> Option<&'static str> {
        warning(self.now.present.least_pressure())
    }

    fn states(&self) -> usize {
        self.states
    }

    fn count(&self) -> Count {
        self.count
    }

    fn get_states(&self, states: &mut [f64]) {
        states.copy_from_slice(&self.now.present.states()[..self.states]);
    }

    fn set_states(&mut self, states: &[f64]) -> Result<(), Fault> {
        for (variable, value) in self.variables.iter().zip(states) {
            if !value.is_finite() {
                return Err(Fault::outside(format!("{variable} = {} is not finite", short(*value))));
            }
        }
        self.now.present.set_states(states);
        self.follow()
    }

    fn nominals(&self, nominals: &mut [f64]) {
        for (nominal, variable) in nominals.iter_mut().zip(&self.variables) {
            *nominal = match variable.symbol {
                symbol if symbol.unit.dimension == unit::PA.dimension => 1e5,
                symbol if symbol == &m::V_V => 1e2,
                _ => 1.0,
            };
        }
    }

    fn rates(&mut self, rates: &mut [f64]) -> Result<(), Fault> {
        let mut all = [0.0; MOST_STATES];
        self.all_rates(&mut all)?;
        rates.copy_from_slice(&all[..self.states]);
        Ok(())
    }

    fn indicators(&self) -> usize {
        self.indicators
    }

    fn event_indicators(&mut self, indicators: &mut [f64]) -> Result<(), Fault> {
        let (present, inputs, y) = (self.now.present, self.now.given.inputs, self.now.present.states());
        let mut all = [0.0; MOST_INDICATORS];
        let found = self.level()?.indicators(&present, &inputs, &y, &mut all);
        found.ok_or_else(|| self.open())?;
        indicators.copy_from_slice(&all[..indicators.len()]);
        Ok(())
    }

    fn inertia(&mut self) -> Result<f64, Fault> {
        let theta = self.now.present.states()[0];
        let dynamics = self.level()?.dynamics();
        let inertia = dynamics.inertia(theta);
        inertia.ok_or_else(|| self.open())
    }

    fn state(&self) -> State {
        State::new(Saved {
            now: self.now,
            algebraic: self.algebraic.state(),
        })
    }

    fn state_into(&self, state: &mut State) {
        let saved: &mut Saved = state.own_mut();
        saved.now = self.now;
        self.algebraic.state_into(&mut saved.algebraic);
    }

    fn set_state(&mut self, state: &State) {
        let Saved { now, algebraic } = state.own();
        self.now = *now;
        self.algebraic.set_state(algebraic);
        (self.level, self.forces) = (None, None);
    }

    fn numbers(&self, state: &State) -> Vec<f64> {
        let Saved { now, algebraic } = state.own();
        let mut numbers = vec![now.time];
        now.present.numbers(&mut numbers);
        now.given.map(&mut |symbol, value| {
            if self.is_given(symbol) {
                numbers.push(value);
            }
        });
        numbers.extend(self.algebraic.numbers(algebraic));
        numbers
    }

    fn state_of(&self, numbers: &[f64]) -> Result<State, Fault> {
        let wrong = || Fault::new("a saved state does not belong to this model");
        let (&time, rest) = numbers.split_first().ok_or_else(wrong)?;
        let (present, rest) = self.now.present.of(rest).ok_or_else(wrong)?;
        let (mut complete, mut values) = (time.is_finite(), rest.iter());
        let given = self.now.given.map(&mut |symbol, old| {
            if !self.is_given(symbol) {
                return old;
            }
            let value = values.next().copied().unwrap_or(f64::NAN);
            complete &= value.is_finite();
            value
        });
        if !complete {
            return Err(wrong());
        }
        let algebraic = self.algebraic.state_of(values.as_slice())?;
        let now = Now { time, present, given };
        Ok(State::new(Saved { now, algebraic }))
    }

    fn tangent(&self, seed: &dyn Fn(Quantity) -> f64) -> Tangent {
        let algebraic = self.algebraic.tangent(seed);
        let mut of = |symbol: &'static Symbol, value| Dual64::new(value, seed((symbol, None)));
        Tangent::new(Direction {
            algebraic,
            level: self.assemble_over(&mut of),
            given: self.now.given.map(&mut of),
            y: self.states_over(&mut of),
            rates: None,
            forces: None,
        })
    }

    fn tangent_into(&self, seed: &dyn Fn(Quantity) -> f64, tangent: &mut Tangent) {
        let direction: &mut Direction = tangent.own_mut();
        self.algebraic.tangent_into(seed, &mut direction.algebraic);
        let mut of = |symbol: &'static Symbol, value| Dual64::new(value, seed((symbol, None)));
        direction.level = self.assemble_over(&mut of);
        direction.given = self.now.given.map(&mut of);
        direction.y = self.states_over(&mut of);
        direction.rates = None;
        direction.forces = None;
    }

    fn derivative(&self, tangent: &mut Tangent, index: usize) -> Result<f64, Fault> {
        let variable = &self.variables[index];
        let direction: &mut Direction = tangent.own_mut();
        let (inputs, y) = (direction.given.inputs, direction.y);
        let present = &self.now.present;
        let level = direction.level.as_ref().map_err(Clone::clone);
        let slot = self.slot(index)?;
        if !matches!(slot, Slot::State(_)) {
            self.algebraic.smooth(&direction.algebraic)?;
        }
        let found = match slot {
            Slot::Algebraic(inner) => return self.algebraic.derivative(&mut direction.algebraic, inner),
            Slot::State(i) => Some(y[i]),
            Slot::Rate(i) => {
                if direction.rates.is_none() {
                    let mut rates = y;
                    direction.rates = level?.rates(present, &inputs, &y, &mut rates).map(|()| rates);
                }
                direction.rates.map(|rates| rates[i])
            }
            Slot::Indicator(i) => {
                let mut all = [Dual64::from_re(0.0); MOST_INDICATORS];
                level?.indicators(present, &inputs, &y, &mut all).map(|()| all[i])
            }
            Slot::Reaction(reaction) => level?.reaction(present, &inputs, &y, reaction),
            Slot::Force(i) => {
                if direction.forces.is_none() {
                    direction.forces = level?.forces(present, &inputs, &y);
                }
                match &direction.forces {
                    Some(forces) => Some(forces.results()[i].ok_or_else(|| self.in_line())?),
                    None => None,
                }
            }
            Slot::Cavitates => Some(Dual64::from_re(0.0)),
            _ => {
                return Err(Fault::new(format!("{variable} is no result: it has no derivative")));
            }
        };
        Ok(found.ok_or_else(|| self.open())?.eps)
    }

    fn duplicate(&self) -> Box<dyn Running> {
        Box::new(self.clone())
    }
}

/// A hoist as the rope at the head feels it.
fn winch<P: Calc>(kind: &HoistKind<P>) -> Winch<P> {
    match *kind {
        HoistKind::AtOnce => Winch::AtOnce,
        HoistKind::Ramp(HoistRamp { a_h }) => Winch::Ramp(a_h),
        HoistKind::Motor(HoistMotor { j_h, r_h, m_h, m_f_h }) => {
            let ratio = m_h / r_h;
            Winch::Motor(WinchDrive {
                mass: (j_h * ratio.square()).def(&m::MASS_H),
                ratio,
                coulomb: m_f_h,
            })
        }
    }
}

/// A crane with its joints of luffing and, where it slews, slewing. A call, as its many numbers would be moved one
/// by one.
#[inline(never)]
fn crane<P: Copy>(dynamics: Dynamics<P>, luffing: Joint<P>, slewing: Option<Joint<P>>) -> Crane<P> {
    match slewing {
        None => Crane::Plane(MovingLinkage {
            dynamics,
            joints: [luffing],
        }),
        Some(slewing) => Crane::Slewing(Slewing {
            dynamics,
            joints: [luffing, slewing],
        }),
    }
}

/// The same with its cylinder under inputs.
#[inline(never)]
fn hydraulic<const N: usize, P: Copy>(
    crane: Crane<P>,
    cylinder: Cylinder<P>,
    buffer: [P; 2],
    inputs: &Inputs<P>,
) -> Hydraulic<N, P> {
    Hydraulic {
        crane,
        cylinder,
        buffer,
        command: inputs.valve,
        supply: inputs.supply,
        hoist: inputs.hoist,
        slewing: inputs.drives[1],
    }
}
