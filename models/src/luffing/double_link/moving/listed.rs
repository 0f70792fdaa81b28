//! What a crane in motion has of all levels, and what is said of its variables.

use crate::balance::symbols as b;
use crate::drive;
use crate::kernel::symbol::{Symbol, listed};
use crate::kernel::variable::{Role, Variable};
use crate::luffing::double_link::forces_in_motion::RESULTS;
use crate::luffing::double_link::moving::motion::{INDICATORS, RATES};
use crate::luffing::double_link::moving::symbols as s;
use crate::luffing::double_link::symbols as g;
use crate::luffing::moving::given::{INPUTS, STATES};
use crate::parts::hydraulics::symbols as h;

/// What forces and moments of this model take into account.
const MOVING: &str = "In motion: with the inertia of all bodies, and the rope as it hangs.";
const GIVEN: &str = "In motion: what motor and brake, or the cylinder, give it.";
const AT_REST: &str = "As at rest: without inertia, the load hanging straight down.";

/// What a scene's crane in motion has.
#[derive(Clone, Copy, Debug)]
pub struct Fittings {
    /// The boom is the driving link.
    pub boom: bool,
    pub oil: bool,
    pub rope: bool,
    pub slews: bool,
    /// Of its hoist.
    pub ramp: bool,
    pub motor: bool,
}

fn place(list: &[&'static Symbol], symbol: &'static Symbol) -> Option<usize> {
    list.iter().position(|known| *known == symbol)
}

impl Fittings {
    /// Whether it has a state or an input.
    #[must_use]
    pub fn gives(self, symbol: &'static Symbol) -> bool {
        match (place(&STATES, symbol), place(&INPUTS, symbol)) {
            (Some(0..6), _) | (_, Some(2 | 3)) => self.oil,
            (Some(6 | 7), _) | (_, Some(7 | 8)) => self.slews,
            (Some(8..14), _) => self.slews && self.rope,
            (Some(16), _) => self.rope,
            (Some(19), _) => self.ramp || self.motor,
            (Some(_), _) => self.rope && !self.slews,
            (_, Some(0 | 1)) => !self.oil,
            (_, Some(4 | 5)) => self.motor,
            (_, Some(6)) => self.rope && !self.motor,
            _ => true,
        }
    }

    /// Whether it has a result.
    #[must_use]
    pub fn has(self, symbol: &'static Symbol) -> bool {
        let of = |list: &[&Symbol]| list.contains(&symbol);
        match (place(&RATES, symbol), place(&INDICATORS, symbol)) {
            (Some(0 | 1), _) => self.boom,
            (Some(2 | 3), _) => !self.boom,
            (Some(rate), _) => self.gives(STATES[rate - 4]),
            (_, Some(0 | 1)) => !self.oil,
            (_, Some(2..5 | 7)) => self.oil,
            (_, Some(8..12)) => self.slews,
            (_, Some(12)) => self.rope,
            (_, Some(13)) => self.ramp,
            (_, Some(14 | 15)) => self.motor,
            _ if of(&[&s::F_C, &h::CAVITATES]) => self.oil,
            _ if of(listed!(s: S_R, F_AX, F_AY)) => self.rope,
            _ if of(&[&s::M_R_H]) => self.motor,
            _ if of(&[&s::W_BLOW]) => !self.oil || self.rope || self.slews,
            _ if of(&[&s::M_R_SL]) => self.slews,
            _ if of(listed!(s: PHI_R, CHI_R, S_Q)) => self.slews && self.rope,
            _ => true,
        }
    }
}

/// Which part of the list a variable stands in: states, inputs, constants and results of the motion; all that a crane at
/// rest has too; rates; event indicators. Forces say what they take into account.
pub fn list(variable: &mut Variable) -> u8 {
    let symbol = variable.symbol;
    variable.at_events = symbol == &s::V_H;
    if variable.role == Role::Indicator {
        return 3;
    }
    if RATES.contains(&symbol) {
        return 2;
    }
    let driving = [&g::THETA_1, &g::OMEGA_1, &g::THETA_3, &g::OMEGA_3];
    if driving.contains(&symbol) && variable.role == Role::Input {
        variable.bounds = [symbol.range.least, symbol.range.most];
        return 0;
    }
    if ![g::ALL, b::ALL, drive::symbols::ALL]
        .iter()
        .any(|all| all.contains(&symbol))
    {
        return 0;
    }
    if RESULTS.contains(&symbol) {
        variable.remark = Some(if symbol == &g::M_D { GIVEN } else { MOVING });
    } else if matches!(variable.role, Role::Output | Role::Calculated) && symbol.unit.dimension.kg != 0 {
        variable.remark = Some(AT_REST);
    }
    1
}
