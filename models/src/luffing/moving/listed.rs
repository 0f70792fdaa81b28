//! What a crane in motion has of all levels, and what is said of its variables.

use crate::component::outline::joined;
use crate::drive::symbols::Z_PULL;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::{Role, Variable};
use crate::luffing::moving::control::acting::axis;
use crate::luffing::moving::control::continuous::{CONTROL_EVENTS, WINDING};
use crate::luffing::moving::control::{AXES, HELD, cycle};
use crate::luffing::moving::given::{INPUTS, Meets, STATES};
use crate::luffing::moving::luffs::MotionSources;
use crate::luffing::moving::stages::{INDICATORS, RATES};
use crate::luffing::moving::symbols as s;
use crate::parts::hydraulics::symbols as h;

/// What forces and moments of this model take into account.
const MOVING: &str = "In motion: with the inertia of all bodies, and the rope as it hangs.";
const GIVEN: &str = "In motion: what motor and brake, or the cylinder, give it.";
const AT_REST: &str = "As at rest: without inertia, the load hanging straight down.";

/// The rates of a driven bar, those of all other states, and those of controllers.
#[must_use]
pub const fn rates_after<const N: usize>(bar: &[&'static Symbol]) -> [&'static Symbol; N] {
    assert!(N == bar.len() + RATES.len() + WINDING.len(), "as many as there are");
    let mut all = [bar[0]; N];
    let mut i = 0;
    while i < N {
        let own = i.checked_sub(bar.len());
        all[i] = match own {
            None => bar[i],
            Some(own) if own < RATES.len() => RATES[own],
            Some(own) => WINDING[own - RATES.len()],
        };
        i += 1;
    }
    all
}

/// Event indicators of a crane and of its controllers.
pub const ALL_INDICATORS: [&Symbol; 38] = joined(INDICATORS, CONTROL_EVENTS);

/// What a scene's crane in motion has.
#[derive(Clone, Copy, Debug)]
pub struct Fittings {
    pub oil: bool,
    pub rope: bool,
    pub slews: bool,
    /// Of its hoist.
    pub ramp: bool,
    pub motor: bool,
    pub air: bool,
    /// Wind on what slews, and a slope under it.
    pub aside: bool,
    pub leans: bool,
    pub ground: bool,
    pub anti_cavitation: bool,
    pub load_holding: bool,
    pub pump: bool,
    /// On the shaft of luffing's motor.
    pub braked: bool,
    /// The rope of its drive may go slack.
    pub hauled: bool,
    pub meets: Meets,
    /// Of luffing, slewing and hoist.
    pub controlled: [bool; 3],
    /// Its controllers are not sampled.
    pub continuous: bool,
}

fn place(list: &[&'static Symbol], symbol: &'static Symbol) -> Option<usize> {
    list.iter().position(|known| *known == symbol)
}

impl Fittings {
    /// `None` at rest.
    #[must_use]
    pub fn of(sources: &MotionSources) -> Option<Fittings> {
        sources.constants.map(|_| Fittings {
            oil: sources.oil.is_some(),
            rope: sources.fitted.rope.is_some(),
            slews: sources.slewed.is_some(),
            ramp: sources.ramp.is_some(),
            motor: sources.motor.is_some(),
            air: sources.around.is_some(),
            aside: sources.slewed.is_some_and(|slewed| slewed.area.is_some()),
            leans: sources.slewed.is_some_and(|slewed| slewed.slope.is_some()),
            ground: sources.ground.is_some(),
            anti_cavitation: sources.oil_parts.is_some_and(|parts| parts.anti_cavitation.is_some()),
            load_holding: sources.oil_parts.is_some_and(|parts| parts.load_holding.is_some()),
            pump: sources.oil_parts.is_some_and(|parts| parts.pump.is_some()),
            braked: sources.fitted.braked,
            hauled: sources.fitted.hauled,
            meets: sources.fitted.meets,
            controlled: sources
                .control
                .map_or([false; 3], |control| control.0.map(|axis| axis.is_some())),
            continuous: sources.control.is_some_and(|control| cycle(&control).is_none()),
        })
    }

    /// Whether it has a state or an input.
    #[must_use]
    pub fn gives(self, symbol: &'static Symbol) -> bool {
        if let Some(held) = place(&HELD, symbol).filter(|held| held % 3 == 0) {
            return self.drives(held / 3) && !self.controlled[held / 3];
        }
        match (place(&STATES, symbol), place(&INPUTS, symbol)) {
            (Some(0..6), _) | (_, Some(2 | 3)) => self.oil,
            (Some(6 | 7), _) | (_, Some(8)) => self.slews,
            (Some(8..14), _) => self.slews && self.rope,
            (Some(16), _) => self.rope,
            (Some(19), _) => self.ramp || self.motor,
            (Some(20 | 21), _) => self.hauled,
            (Some(_), _) => self.rope && !self.slews,
            (_, Some(1)) => !self.oil,
            (_, Some(5)) => self.motor,
            (_, Some(6)) => self.rope && !self.motor,
            (_, Some(9)) => self.air || self.aside,
            (_, Some(10)) => self.air && self.slews || self.aside,
            (_, Some(11 | 12)) => self.load_holding,
            (_, Some(13)) => self.braked,
            (_, Some(14)) => self.meets.pressure,
            (_, Some(15)) => self.meets.speed,
            (_, Some(16)) => self.meets.slope,
            (_, Some(17)) => self.meets.slewing,
            _ => true,
        }
    }

    /// Whether a motor moves luffing (0), slewing (1) or the hoist (2).
    fn drives(self, axis: usize) -> bool {
        [!self.oil, self.slews, self.motor][axis]
    }

    /// Whether it has a result.
    #[must_use]
    pub fn has(self, symbol: &'static Symbol) -> bool {
        if let Some(axis) = axis(symbol) {
            return self.controlled[axis];
        }
        let of = |list: &[&Symbol]| list.contains(&symbol);
        match (place(&RATES, symbol), place(&INDICATORS, symbol)) {
            (Some(rate), _) => self.gives(STATES[rate]),
            (_, Some(0 | 1)) => !self.oil,
            (_, Some(2..5 | 7)) => self.oil,
            (_, Some(8..12)) => self.slews,
            (_, Some(12)) => self.rope,
            (_, Some(13)) => self.ramp,
            (_, Some(14 | 15)) => self.motor,
            (_, Some(16)) => self.ground,
            (_, Some(17 | 18)) => self.anti_cavitation,
            (_, Some(19..24)) => self.load_holding,
            (_, Some(24 | 25)) => self.pump,
            (_, Some(26..29)) => self.hauled,
            _ if of(&[&Z_PULL]) => !self.hauled,
            _ if of(&[&s::P_ML, &s::P_BL]) => self.hauled,
            _ if of(&[&s::F_C, &h::CAVITATES]) => self.oil,
            _ if of(listed!(h: Q_ACA, Q_ACB)) => self.anti_cavitation,
            _ if of(listed!(h: Y_LHA, Y_LHB, Q_B1, Q_B2)) => self.load_holding,
            _ if of(&[&h::P_S]) => self.pump,
            _ if of(listed!(s: S_R, F_AX, F_AY)) => self.rope,
            _ if of(&[&s::M_R_H]) => self.motor,
            _ if of(&[&s::W_BLOW]) => !self.oil || self.rope || self.slews,
            _ if of(&[&s::M_R_SL]) => self.slews,
            _ if of(&[&s::P_WS, &s::M_WS]) => self.aside,
            _ if of(&[&s::M_WIND]) => self.meets.pressure,
            _ if of(&[&s::M_SLOPE]) => self.meets.slope,
            _ if of(&[&s::M_OMEGA]) => self.meets.slewing,
            _ if of(&[&s::M_GAMMA, &s::M_GAMMA_L]) => self.leans,
            _ if of(listed!(s: PHI_R, CHI_R, S_Q)) => self.slews && self.rope,
            _ => true,
        }
    }
}

/// What is said of a mechanism's variables in motion.
pub struct Said {
    /// Angle and angular velocity of the driven bar, whichever it is, and their rates.
    pub bar: [&'static [&'static Symbol]; 2],
    /// Tables of what a crane at rest has too.
    pub still: &'static [&'static [&'static Symbol]],
    /// Results in motion in the place of those at rest, and the moment of the drive.
    pub moving: &'static [&'static Symbol],
    pub drive: Option<&'static Symbol>,
    /// What is said of others, in motion and at rest.
    pub remarks: &'static [(&'static Symbol, &'static str)],
}

impl Said {
    /// Which part of the list a variable stands in: states, inputs, constants and results of the motion; all that a crane at
    /// rest has too; rates; event indicators. Forces say what they take into account.
    pub fn list(&self, crane: &Fittings, variable: &mut Variable) -> u8 {
        let symbol = variable.symbol;
        let [driving, rates] = self.bar;
        let own = self.remarks.iter().find(|(known, _)| *known == symbol);
        variable.remark = own.map(|(_, remark)| *remark).or(variable.remark);
        let by_controllers = if crane.continuous {
            AXES.iter().any(|axis| axis.commands.contains(&symbol))
        } else {
            HELD.contains(&symbol) && variable.role != Role::Input
        };
        variable.at_events = [&s::V_H, &s::U_BR].contains(&symbol) || by_controllers;
        if variable.role == Role::Indicator {
            return 3;
        }
        if rates.contains(&symbol) || RATES.contains(&symbol) {
            return 2;
        }
        if driving.contains(&symbol) && variable.role == Role::Input {
            variable.bounds = [symbol.range.least, symbol.range.most];
            return 0;
        }
        if !self.still.iter().any(|all| all.contains(&symbol)) {
            return 0;
        }
        if self.moving.contains(&symbol) {
            variable.remark = Some(if self.drive == Some(symbol) { GIVEN } else { MOVING });
        } else if matches!(variable.role, Role::Output | Role::Calculated) && symbol.unit.dimension.kg != 0 {
            variable.remark = Some(AT_REST);
        }
        1
    }
}

/// What is said of a component's variables in motion, and what it has there.
macro_rules! said {
    ($component:ident: $said:expr) => {
        /// What is said of its variables in motion.
        const SAID: $crate::luffing::moving::listed::Said = $said;

        /// What it has in motion; `None` at rest.
        fn fittings(given: &Given<f64>) -> Option<$crate::luffing::moving::listed::Fittings> {
            use $crate::luffing::moving::luffs::Luffs;
            $crate::luffing::moving::listed::Fittings::of(&$component::luffing(given).sources)
        }
    };
}
pub(crate) use said;

/// What stands in the `Component` of every luffing mechanism: states, inputs and results of its motion as [`said!`]
/// tells them, what its controllers latch; the stage that a scene's change comes to is named.
macro_rules! luffing_component {
    ($stage:ident) => {
        const STATES: [&'static [&'static $crate::kernel::symbol::Symbol]; 2] = SAID.bar;

        fn gives(given: &Given<f64>, symbol: &'static $crate::kernel::symbol::Symbol) -> bool {
            fittings(given).is_none_or(|crane| crane.gives(symbol))
        }

        fn list(given: &Given<f64>, variable: &mut $crate::kernel::variable::Variable) -> u8 {
            fittings(given).map_or(0, |crane| SAID.list(&crane, variable))
        }

        fn cycle(given: &Given<f64>) -> Option<f64> {
            given
                .control
                .as_ref()
                .and_then($crate::luffing::moving::control::cycle)
        }

        fn latch(known: &mut Known<f64>) -> Found<()> {
            let held = known.sampled()?.next;
            *known.latched() = Some(held);
            Ok(())
        }

        fn update(known: &mut Known<f64>) -> Found<()> {
            known.$stage().map(|_| ())
        }
    };
}
pub(crate) use luffing_component;
