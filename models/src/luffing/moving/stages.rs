//! The crane in motion as stages: its equations under present inputs, and what follows from its states.

use num_dual::Dual64;

use crate::component::scalar::{EachScalar, Scalar};
use crate::component::stages::{Found, Rows, absent, results};
use crate::kernel::calc::Calc;
use crate::kernel::group::One;
use crate::kernel::record::Rec;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::Fault;
use crate::luffing::moving::dynamics::Coordinate;
use crate::luffing::moving::given::{
    CraneStates, CylinderOil, Fitted, Inputs, MOST_STATES, PSI_SL, Slack, SlewedParts, order,
};
use crate::luffing::moving::hydraulic::{Hydraulic, MOST, Modes, part};
use crate::luffing::moving::leaning::Outer;
use crate::luffing::moving::level::{CraneAt, Level, MOST_INDICATORS, MotionResult, first};
use crate::luffing::moving::space;
use crate::luffing::moving::symbols as s;
use crate::parts::air::AirAround;
use crate::parts::ground::GroundBelow;
use crate::parts::hydraulics::cylinder::{Flows, PART_MARGINS};
use crate::parts::hydraulics::parts::OilParts;
use crate::parts::hydraulics::symbols as h;
use crate::parts::plane::Point;

/// The equations over a scalar.
pub struct Equations<P: Calc> {
    rates: fn(&Level<P>, &CraneAt<P>) -> Option<[P; MOST_STATES]>,
    indicators: fn(&Level<P>, &CraneAt<P>) -> Option<[P; MOST_INDICATORS]>,
    reaction: fn(&Level<P>, &CraneAt<P>, MotionResult) -> Option<P>,
}

impl<P: Coordinate<P>> Equations<P> {
    fn new() -> Equations<P> {
        Equations {
            rates: Level::rates,
            indicators: Level::indicators,
            reaction: Level::reaction,
        }
    }
}

/// Each scalar has derivatives by the driven angle in its own way.
struct InMotion;

impl EachScalar for InMotion {
    type For<C: Calc> = Equations<C>;
    fn plain() -> Equations<f64> {
        Equations::new()
    }
    fn dual() -> Equations<Dual64> {
        Equations::new()
    }
    fn recorded() -> Equations<Rec> {
        Equations::new()
    }
}

/// The same under inputs; none where they are no part of it.
pub fn told<C: Scalar>(built: &[Level<C>], inputs: &Inputs<C>, room: &mut Vec<Level<C>>) {
    room.clear();
    room.extend(built[0].told(inputs));
}

/// The level under present inputs.
pub fn present<'a, C>(built: &'a [Level<C>], told: &'a [Level<C>]) -> &'a Level<C> {
    told.first().unwrap_or(&built[0])
}

/// A crane as it is that a rope luffs.
pub fn hanging<C: Calc>(at: &CraneAt<C>, slack: &Slack) -> CraneAt<C> {
    let past = Modes {
        slack: slack.0,
        ..at.past
    };
    CraneAt { past, ..*at }
}

#[cold]
pub fn open<C: Calc>(theta: &One<C>) -> Fault {
    let (symbol, at) = (theta.0, theta.1.value());
    Fault::outside(format!(
        "the linkage does not close at {} = {}",
        symbol.id,
        symbol.written(at)
    ))
}

/// A row for each symbol of a list.
macro_rules! rows {
    ($name:ident, $symbols:ident) => {
        impl<C: Calc> Rows<C> for $name<C> {
            const ROWS: &'static [&'static Symbol] = &$symbols;
            fn row(&self, row: u8, _: u16) -> Found<C> {
                Ok(self.0[usize::from(row)])
            }
        }
    };
}

/// Rates of all states, in their order.
#[derive(Clone, Copy, Debug)]
pub struct CraneMoves<C>([C; MOST_STATES]);

impl<C: Calc> CraneMoves<C> {
    /// Of angle and rate of the driven bar.
    pub fn bar(&self) -> [C; 2] {
        [self.0[0], self.0[1]]
    }

    /// Of a state, by its place in the order of the equations.
    pub fn of(&self, state: usize) -> C {
        self.0[state]
    }
}

pub fn moves<C: Scalar>(
    built: &[Level<C>],
    told: &[Level<C>],
    at: &CraneAt<C>,
    theta: &One<C>,
) -> Result<CraneMoves<C>, Fault> {
    let found = (C::own::<InMotion>().rates)(present(built, told), at);
    found.map(CraneMoves).ok_or_else(|| open(theta))
}

/// Rates of the states but for angle and rate of the driven bar.
#[derive(Clone, Copy, Debug)]
pub struct CraneRates<C>([C; RATES.len()]);

/// Those of [`CraneStates`].
pub const RATES: [&Symbol; 22] = *listed!(
    s: D_P_1, D_P_2, D_P_A, D_P_B, D_X_V, D_V_V, D_PSI_SL, D_OMEGA_SL, D_X_Q, D_Y_Q, D_Z_Q, D_V_QX, D_V_QY, D_V_QZ, D_PHI_R,
    D_OMEGA_R, D_L_R, D_S_Q, D_V_Q, D_V_R, D_DELTA_L, D_V_TL
);

rows!(CraneRates, RATES);

impl<C: Calc> CraneRates<C> {
    pub fn new(moves: &CraneMoves<C>, fitted: &Fitted) -> CraneRates<C> {
        let mut rows = [C::constant(0.0); RATES.len()];
        for (rate, place) in moves.0[2..].iter().zip(order(fitted)) {
            rows[*place] = *rate;
        }
        CraneRates(rows)
    }
}

/// Results that are one number each.
macro_rules! reactions {
    ($($name:ident: $of:ident $(with $part:ty)?;)*) => {
        $(pub fn $name<C: Scalar>(
            built: &[Level<C>],
            told: &[Level<C>],
            at: &CraneAt<C>,
            theta: &One<C>,
            $(_: &$part,)?
        ) -> Result<C, Fault> {
            let found = (C::own::<InMotion>().reaction)(present(built, told), at, MotionResult::$of);
            found.ok_or_else(|| open(theta))
        })*
    };
}
reactions! {
    cylinder: Cylinder;
    resisting: Friction;
    pull: Pull;
    drum: Drum;
    driving: Drive;
}

/// Results that are two numbers each.
macro_rules! pairs {
    ($($(#[$about:meta])* $name:ident: $one:ident, $other:ident $(with $part:ty)?;)*) => {
        $($(#[$about])* pub fn $name<C: Scalar>(
            built: &[Level<C>],
            told: &[Level<C>],
            at: &CraneAt<C>,
            theta: &One<C>,
            $(_: &$part,)?
        ) -> Result<Point<C>, Fault> {
            let of = |which| (C::own::<InMotion>().reaction)(present(built, told), at, which);
            let found = of(MotionResult::$one).zip(of(MotionResult::$other));
            found.map(|(one, other)| Point::new(one, other)).ok_or_else(|| open(theta))
        })*
    };
}
pairs! {
    /// Force of the air on the load (N), and the power that it takes (W).
    drag: Air, AirPower with AirAround<C>;
    /// Force of the ground on the load (N), and the load's height above it (m).
    standing: Ground, Height with GroundBelow<C>;
}

/// What acts on the driven bar besides what resists: moments of wind, slope and centrifugal forces (N·m), powers of the motor and, on the drum of a
/// slack rope, of its brakes (W).
#[derive(Clone, Copy, Debug)]
pub struct BarActed<C>([C; ACTING.len()]);

const ACTING: [&Symbol; 5] = *listed!(s: M_WIND, M_SLOPE, M_OMEGA, P_ML, P_BL);

rows!(BarActed, ACTING);

pub fn acted<C: Scalar>(
    built: &[Level<C>],
    told: &[Level<C>],
    at: &CraneAt<C>,
    theta: &One<C>,
) -> Result<BarActed<C>, Fault> {
    let mut found = [C::constant(0.0); ACTING.len()];
    let all = [
        MotionResult::Outer(Outer::Wind),
        MotionResult::Outer(Outer::Slope),
        MotionResult::Outer(Outer::Centrifugal),
        MotionResult::Motor,
        MotionResult::DrumBrake,
    ];
    for (of, which) in found.iter_mut().zip(all) {
        *of = (C::own::<InMotion>().reaction)(present(built, told), at, which).ok_or_else(|| open(theta))?;
    }
    Ok(BarActed(found))
}

/// What acts on slewing besides its drive: moment of friction, brake and end stop (N·m), pressure of the wind on all that slews
/// (Pa), its moment, and those of the slope, on luffing beside it (N·m).
#[derive(Clone, Copy, Debug)]
pub struct OnSlewing<C>([Option<C>; 5]);

impl<C: Calc> Rows<C> for OnSlewing<C> {
    const ROWS: &'static [&'static Symbol] = listed!(s: M_R_SL, P_WS, M_WS, M_GAMMA, M_GAMMA_L);
    fn row(&self, row: u8, _: u16) -> Found<C> {
        self.0[usize::from(row)].ok_or_else(absent)
    }
}

impl<C: Scalar> OnSlewing<C> {
    pub fn new(
        built: &[Level<C>],
        told: &[Level<C>],
        at: &CraneAt<C>,
        theta: &One<C>,
        slewed: &SlewedParts<C>,
        around: &Option<AirAround<C>>,
        states: &CraneStates<C>,
    ) -> Result<OnSlewing<C>, Fault> {
        let area = slewed.area.map(|area| area.in_air(around.as_ref()));
        let pushed = area.and_then(|area| area.pushed(at.inputs.wind, states.0[PSI_SL]));
        let [pressure, moment] = pushed.map_or([None; 2], |pushed| pushed.map(Some));
        let of = |which| (C::own::<InMotion>().reaction)(present(built, told), at, which).ok_or_else(|| open(theta));
        let leaning = |which| slewed.slope.map(|_| of(MotionResult::Outer(which))).transpose();
        Ok(OnSlewing([
            Some(of(MotionResult::SlewingFriction)?),
            pressure,
            moment,
            leaning(Outer::Turning)?,
            leaning(Outer::Lifting)?,
        ]))
    }
}

/// Energy that blows have taken, in J.
pub fn blown<C: Calc>(at: &CraneAt<C>) -> C {
    C::constant(at.past.blown)
}

/// Where the load of a crane that slews is seen from its head.
#[derive(Clone, Copy, Debug)]
pub struct LoadSeen<C>([C; 3]);
results! { LoadSeen as l => { PHI_R: l.0[0]; CHI_R: l.0[1]; S_Q: l.0[2]; } }

impl<C: Calc> LoadSeen<C> {
    pub fn new(at: &CraneAt<C>, fitted: &Fitted) -> LoadSeen<C> {
        let own: [C; space::STATES] = if fitted.oil { part(&at.y) } else { *first(&at.y) };
        let [swing, side] = space::angles(&own);
        LoadSeen([swing, side, space::distance(&own)])
    }
}

/// Whether the oil falls below vacuum.
#[derive(Clone, Copy, Debug)]
pub struct CraneOil(bool);

impl<C: Calc> Rows<C> for CraneOil {
    const ROWS: &'static [&'static Symbol] = &[&h::CAVITATES];
    fn row(&self, _: u8, _: u16) -> Found<C> {
        Ok(C::constant(f64::from(self.0)))
    }
}

impl CraneOil {
    pub fn new<C: Calc>(at: &CraneAt<C>, moves: &CraneMoves<C>, _: &CylinderOil<C>) -> CraneOil {
        let oil = Hydraulic::<MOST>::oil(&at.y.map(C::value));
        CraneOil(oil.cavitates(|| [2, 3, 4, 5].map(|i| moves.0[i].value())))
    }
}

/// What flows through parts of the oil that a scene may leave out, and what of them is open.
#[derive(Clone, Copy, Debug)]
pub struct OilFlows<C>(Option<Flows<C>>);

impl<C: Calc> Rows<C> for OilFlows<C> {
    const ROWS: &'static [&'static Symbol] = listed!(h: Q_ACA, Q_ACB, Y_LHA, Y_LHB, Q_B1, Q_B2, P_S);
    fn row(&self, row: u8, _: u16) -> Found<C> {
        let flows = self.0.as_ref().ok_or_else(absent)?;
        let found = match row {
            0 | 1 => flows.drawn,
            2 | 3 => flows.openings,
            4 | 5 => flows.torn,
            _ => Some([flows.supply; 2]),
        };
        found.map(|two| two[usize::from(row % 2)]).ok_or_else(absent)
    }
}

impl<C: Scalar> OilFlows<C> {
    pub fn new(built: &[Level<C>], told: &[Level<C>], at: &CraneAt<C>, _: &OilParts<C>) -> OilFlows<C> {
        OilFlows(present(built, told).oil_flows(&at.y))
    }
}

/// What falls below zero where a smooth piece of the motion ends.
#[derive(Clone, Copy, Debug)]
pub struct CraneEvents<C>([C; INDICATORS.len()]);

/// Of luffing; of the oil, with the stops of luffing; of slewing; of the rope; of the hoist; of the ground; of parts of the oil; of
/// the drive's rope.
pub const INDICATORS: [&Symbol; 29] = [
    &s::Z_REST,
    &s::Z_LOOSE,
    &s::Z_SPOOL,
    &s::Z_RELIEF_1,
    &s::Z_RELIEF_2,
    &s::Z_LOW,
    &s::Z_HIGH,
    &h::Z_VACUUM,
    &s::Z_SL_REST,
    &s::Z_SL_LOOSE,
    &s::Z_SL_LOW,
    &s::Z_SL_HIGH,
    &s::Z_ROPE,
    &s::Z_HOIST,
    &s::Z_DRUM_REST,
    &s::Z_DRUM_LOOSE,
    &s::Z_GROUND,
    &h::Z_SUCTION_A,
    &h::Z_SUCTION_B,
    &h::Z_HOLD_A,
    &h::Z_HOLD_B,
    &h::Z_OPEN_A,
    &h::Z_OPEN_B,
    &h::Z_UNDERLAP,
    &h::Z_FLOW,
    &h::Z_POWER,
    &s::Z_TACKLE,
    &s::Z_TACKLE_REST,
    &s::Z_TACKLE_LOOSE,
];

rows!(CraneEvents, INDICATORS);

pub fn events<C: Scalar>(
    built: &[Level<C>],
    told: &[Level<C>],
    at: &CraneAt<C>,
    theta: &One<C>,
    fitted: &Fitted,
) -> Result<CraneEvents<C>, Fault> {
    let found = (C::own::<InMotion>().indicators)(present(built, told), at).ok_or_else(|| open(theta))?;
    let luffing: &[usize] = if fitted.oil { &[2, 3, 4, 5, 6, 7] } else { &[0, 1, 5, 6] };
    let slewing: &[usize] = if fitted.slewing.is_some() { &[8, 9, 10, 11] } else { &[] };
    let mut rows = [C::constant(0.0); INDICATORS.len()];
    let (found, parts) = found.split_at(MOST_INDICATORS - PART_MARGINS);
    rows[17..17 + PART_MARGINS].copy_from_slice(parts);
    let mut found = found.iter().copied();
    for (place, z) in luffing.iter().chain(slewing).chain(&[12]).zip(&mut found) {
        rows[*place] = z;
    }
    // A hoist has the one or the other.
    let hoist: [C; 2] = std::array::from_fn(|_| found.next().unwrap_or(rows[13]));
    (rows[13], rows[14], rows[15]) = (hoist[0], hoist[0], hoist[1]);
    rows[16] = found.next().unwrap_or(rows[16]);
    for (row, z) in rows[17 + PART_MARGINS..].iter_mut().zip(found) {
        *row = z;
    }
    Ok(CraneEvents(rows))
}
