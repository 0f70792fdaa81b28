//! What a mechanism in motion is given besides what it is at rest: inputs, constants, states, and what happened before.

use crate::kernel::calc::Calc;
use crate::kernel::group::{Group, by_map, group, quantities};
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::unit::ONE;
use crate::kernel::variable::Quantity;
use crate::luffing::moving::brakes::Braking;
use crate::luffing::moving::crane::Commands;
use crate::luffing::moving::hydraulic::{self, Modes};
use crate::luffing::moving::symbols as s;
use crate::luffing::moving::weather::Weather;
use crate::parts::hoist::{Drum, HoistCommand};
use crate::parts::joint::{Bar, JointDrive};
use crate::parts::side_wind::SlewedArea;
use crate::parts::slope::SlopingGround;
use crate::parts::turntable::Turning;

/// Most continuous states of any level.
pub const MOST_STATES: usize = hydraulic::MOST;

quantities! {
    /// A luffing cylinder with its oil and valve, besides bore and rod.
    CylinderOil {
        l_min: L_MIN, l_max: L_MAX, v_0: V_0, v_1: V_1, q_n: Q_N, dp_n: DP_N, dp_l: DP_L, beta_e: BETA_E,
        p_r: P_R, k_r: K_R, k_l: K_L, omega_v: OMEGA_V, zeta_v: ZETA_V, tol: TOL
    }
}

/// What slews besides the bodies of the mechanism: inertia and friction, the structure as the wind meets it, and the slope with
/// the weight on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlewedParts<C = f64> {
    pub turning: Turning<C>,
    pub area: Option<SlewedArea<C>>,
    pub slope: Option<SlopingGround<C>>,
}

impl<C: Copy> SlewedParts<C> {
    /// The same over another scalar.
    pub fn map<D>(&self, f: &mut dyn FnMut(&'static Symbol, C) -> D) -> SlewedParts<D> {
        SlewedParts {
            turning: self.turning.map(f),
            area: self.area.map(|area| area.map(f)),
            slope: self.slope.map(|slope| slope.map(f)),
        }
    }
}

by_map!(SlewedParts: 9);

quantities! {
    /// What is constant in motion, besides the mechanism and its inertias.
    Constants { c_v: C_V, m_f: M_F, g: G, step: STEP }
}

/// Inputs, constant over a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs<P = f64> {
    /// Of luffing and of slewing.
    pub drives: [JointDrive<P>; 2],
    pub hoist: HoistCommand<P>,
    /// Command of the valve in [−1, 1], and pressure of the pump in Pa.
    pub valve: P,
    pub supply: P,
    /// Speed (m/s) and direction (rad) of the wind at the load.
    pub wind: [P; 2],
    /// Parts of the cylinder's lines that are torn open, in [0, 1].
    pub torn: [P; 2],
    /// Command of the brakes on the shaft of luffing's motor, in [0, 1].
    pub braking: P,
    /// At the mechanism's bodies, with the speed at which it is slewed.
    pub weather: Weather<P>,
    /// Torque of those of them that act, in N·m: no input, but what follows from that.
    pub shaft: P,
}

/// Their symbols.
pub const INPUTS: [&Symbol; 18] = *listed!(
    s: M_A, M_S, U_V, P_P, M_M_H, M_B_H, V_H, M_SL, M_B_SL, V_AIR, CHI_AIR, Y_B1, Y_B2, U_BR, P_WM, V_WM, SIGMA_M,
    N_SM
);

impl<P: Calc> Inputs<P> {
    /// Of a crane of J joints.
    #[must_use]
    pub fn of<const J: usize>(&self) -> Commands<J, P> {
        Commands {
            drives: std::array::from_fn(|i| self.drives[i]),
            hoist: self.hoist,
            shaft: self.shaft,
        }
    }

    /// The drive of luffing (0), of slewing (1), of the hoist (2).
    pub fn drive(&mut self, axis: usize) -> &mut JointDrive<P> {
        match axis {
            2 => &mut self.hoist.drive,
            _ => &mut self.drives[axis],
        }
    }

    fn numbers(&self) -> [P; INPUTS.len()] {
        let ([luffing, slewing], hoist) = (self.drives, self.hoist);
        let drum = hoist.drive;
        [
            luffing.moment,
            luffing.brake,
            self.valve,
            self.supply,
            drum.moment,
            drum.brake,
            hoist.speed,
            slewing.moment,
            slewing.brake,
            self.wind[0],
            self.wind[1],
            self.torn[0],
            self.torn[1],
            self.braking,
            self.weather.wind[0],
            self.weather.wind[1],
            self.weather.slope,
            self.weather.slewing,
        ]
    }

    fn from(
        [
            m_a,
            m_s,
            valve,
            supply,
            m_h,
            m_b_h,
            speed,
            m_sl,
            m_b_sl,
            v_air,
            chi_air,
            y_b1,
            y_b2,
            u_br,
            p_wm,
            v_wm,
            slope,
            slewing,
        ]: [P; INPUTS.len()],
    ) -> Inputs<P> {
        let drive = |moment, brake| JointDrive { moment, brake };
        Inputs {
            drives: [drive(m_a, m_s), drive(m_sl, m_b_sl)],
            hoist: HoistCommand {
                speed,
                drive: drive(m_h, m_b_h),
            },
            valve,
            supply,
            wind: [v_air, chi_air],
            torn: [y_b1, y_b2],
            braking: u_br,
            weather: Weather {
                wind: [p_wm, v_wm],
                slope,
                slewing,
            },
            shaft: P::constant(0.0),
        }
    }
}

impl Inputs {
    /// Nothing commanded.
    #[must_use]
    pub fn none() -> Inputs {
        Inputs::from([0.0; INPUTS.len()])
    }
}

/// The states but for angle and rate of the driven bar, of all levels: zero where a level does not have one.
#[derive(Clone, Copy, Debug)]
pub struct CraneStates<C>(pub [C; STATES.len()]);

/// Their symbols: of the oil, of slewing and the load in space, of the load in the plane, of the rope, of the drive's slack
/// rope.
pub const STATES: [&Symbol; 22] = *listed!(
    s: P_1, P_2, P_A, P_B, X_V, V_V, PSI_SL, OMEGA_SL, X_Q, Y_Q, Z_Q, V_QX, V_QY, V_QZ, PHI_R, OMEGA_R, L_R, S_Q, V_Q, V_R,
    DELTA_L, V_TL
);

/// Places of slewing's angle and rate, of the rope's length, of the load's distance, of the rate at which the rope is paid out,
/// and of slack and speed of the drive's rope.
pub const PSI_SL: usize = 6;
pub const OMEGA_SL: usize = 7;
pub const L_R: usize = 16;
pub const S_Q: usize = 17;
pub const V_R: usize = 19;
pub const DELTA_L: usize = 20;
pub const V_TL: usize = 21;

/// Which of them follow on angle and rate of the driven bar, in the order of the equations.
#[must_use]
pub fn order(fitted: &Fitted) -> &'static [usize] {
    match (fitted.oil, fitted.slewing.is_some()) {
        (false, false) if fitted.hauled => &[14, 15, 16, 17, 18, 19, DELTA_L, V_TL],
        (false, true) if fitted.hauled => &[6, 7, 8, 9, 10, 11, 12, 13, 16, 19, DELTA_L, V_TL],
        (false, false) => &[14, 15, 16, 17, 18, 19],
        (false, true) => &[6, 7, 8, 9, 10, 11, 12, 13, 16, 19],
        (true, false) => &[0, 1, 2, 3, 4, 5, 14, 15, 16, 17, 18, 19],
        (true, true) => &[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 16, 19],
    }
}

/// Where in the order of the equations the speeds of luffing, slewing and hoist are.
#[must_use]
pub fn rates(fitted: &Fitted) -> [Option<usize>; 3] {
    let states = order(fitted);
    let rate = |place: usize| states.iter().position(|state| *state == place).map(|found| found + 2);
    [Some(1), rate(OMEGA_SL), rate(V_R)]
}

static PAST: Symbol = Symbol::new("past", "", [&ONE, &ONE], "A number of what happened before.", "derived");

const PAST_NUMBERS: usize = 8;

/// Which way a bar moves, as a number; one that is loose always is.
fn way(bar: Bar) -> f64 {
    match bar {
        Bar::Held | Bar::Loose => 0.0,
        Bar::Forward => 1.0,
        Bar::Backward => -1.0,
    }
}

fn bar(way: f64) -> Bar {
    match way {
        0.0 => Bar::Held,
        way if way > 0.0 => Bar::Forward,
        _ => Bar::Backward,
    }
}

/// How ropes hang, as a number: one where that of the load is taut, two more where it stands on the ground, and four, eight or
/// twelve where that of the drive is slack, as its drum is held, pays out or reels in.
fn hanging(modes: &Modes) -> f64 {
    let drum = match modes.unwound {
        None => 0.0,
        Some(Bar::Held | Bar::Loose) => 1.0,
        Some(Bar::Forward) => 2.0,
        Some(Bar::Backward) => 3.0,
    };
    f64::from(modes.taut) + 2.0 * f64::from(modes.grounded) + 4.0 * drum
}

fn numbers(modes: &Modes) -> [f64; PAST_NUMBERS] {
    let [luffing, slewing] = modes.joints.map(way);
    let (drum, [called, acting]) = (modes.drum, modes.braking.numbers());
    [
        luffing,
        slewing,
        way(drum.way),
        drum.command,
        hanging(modes),
        modes.blown,
        called,
        acting,
    ]
}

fn modes([luffing, slewing, drum, command, hanging, blown, called, acting]: [f64; PAST_NUMBERS]) -> Modes {
    let way = bar(drum);
    let unwound = [None, Some(Bar::Held), Some(Bar::Forward), Some(Bar::Backward)];
    let load = hanging % 4.0;
    Modes {
        joints: [bar(luffing), bar(slewing)],
        drum: Drum { way, command },
        taut: load == 1.0 || load == 3.0,
        grounded: load >= 2.0,
        slack: None,
        unwound: unwound[(hanging / 4.0).clamp(0.0, 3.0) as usize],
        blown,
        braking: Braking::of([called, acting]),
    }
}

/// Where a rope that drives luffing is slack: the angle (rad) at which it is taut again.
#[derive(Clone, Copy, Debug)]
pub struct Slack(pub Option<f64>);

/// A group of as many numbers, each with its symbol.
macro_rules! numbered {
    ($name:ty, $over:ty, $symbols:expr, $numbers:expr, $from:expr) => {
        impl<C: Calc> Group<C> for $name {
            type Over<D: Calc> = $over;
            const SIZE: usize = $symbols.len();
            fn map<D: Calc>(&self, f: &mut dyn FnMut(Quantity, C) -> D) -> $over {
                let numbers = $numbers(self);
                $from(std::array::from_fn(|i| f(($symbols[i], None), numbers[i])))
            }
            fn take(&self, place: usize) -> C {
                $numbers(self)[place]
            }
            fn put(&mut self, place: usize, value: C) {
                let mut numbers = $numbers(self);
                numbers[place] = value;
                *self = $from(numbers);
            }
        }
    };
}
numbered!(Inputs<C>, Inputs<D>, INPUTS, Inputs::numbers, Inputs::from);
numbered!(
    CraneStates<C>,
    CraneStates<D>,
    STATES,
    |states: &CraneStates<C>| states.0,
    CraneStates
);
numbered!(
    Modes,
    Modes,
    [&PAST; PAST_NUMBERS],
    |past: &Modes| numbers(past).map(C::constant),
    |numbers: [_; PAST_NUMBERS]| modes(numbers.map(Calc::value))
);
numbered!(
    Slack,
    Slack,
    [&PAST; 2],
    |Slack(slack): &Slack| [f64::from(slack.is_some()), slack.unwrap_or(0.0)].map(C::constant),
    |[slack, angle]: [_; 2]| Slack((Calc::value(slack) != 0.0).then_some(Calc::value(angle)))
);

/// What belongs to a crane in motion and is no number of its equations: length of the load's rope at the start (m), end
/// stops of slewing (rad), whether oil moves it, whether brakes are on the shaft of its motor, whether the rope of its drive may
/// go slack, what of wind and slope it meets and whether it is slewed as given.
#[derive(Clone, Copy, Debug, Default)]
pub struct Fitted {
    pub rope: Option<f64>,
    pub slewing: Option<[f64; 2]>,
    pub oil: bool,
    pub braked: bool,
    pub hauled: bool,
    pub meets: Meets,
}
group!(Fitted);

/// What of wind and slope a mechanism meets in motion: pressure and speed of the wind on its bodies' areas, a slope; and whether
/// it is slewed at a given speed.
#[derive(Clone, Copy, Debug, Default)]
pub struct Meets {
    pub pressure: bool,
    pub speed: bool,
    pub slope: bool,
    pub slewing: bool,
}

impl Meets {
    pub const NOTHING: Meets = Meets {
        pressure: false,
        speed: false,
        slope: false,
        slewing: false,
    };

    /// Whether wind or slope does.
    pub fn any(self) -> bool {
        self.pressure || self.slope
    }
}
