//! A start of a motor in one of its ways.

use crate::kernel::calc::Calc;
use crate::kernel::group::either;
use crate::kernel::symbol::{Symbol, listed};
use crate::parts::starts::engine::{EngineStart, Engined};
use crate::parts::starts::inverter::Ramped;
use crate::parts::starts::slip::Slipped;
use crate::parts::starts::{self as s, InverterStart, RatedPoint, SlipStart, Starting};

/// How a motor starts.
#[derive(Clone, Debug)]
pub enum StartWay<C> {
    SlipStart(SlipStart<C>),
    InverterStart(InverterStart<C>),
    EngineStart(EngineStart<C>),
}
either!(StartWay {
    SlipStart,
    InverterStart,
    EngineStart
});

impl StartWay<f64> {
    /// Speeds (1/s) and torques (N·m) that a motor of a rated point gives on the way; nothing on an inverter, which gives what the
    /// ramp asks for.
    #[must_use]
    pub fn over_speed(&self, rated: &RatedPoint<f64>) -> Vec<[f64; 2]> {
        match self {
            StartWay::SlipStart(slip) => slip.over_speed(rated),
            StartWay::InverterStart(_) => Vec::new(),
            StartWay::EngineStart(engine) => engine.over_speed(),
        }
    }
}

/// Results of each way.
pub const SLIPPED: &[&Symbol] = listed!(s: S_K, T_BD, S_F, T_LEAST, I_S, T_SLIP, A_SLIP);
pub const RAMPED: &[&Symbol] = listed!(s: T_U, T_RAMP, T_INV, A_INV);
pub const ENGINED: &[&Symbol] = listed!(s: T_E_MAX, K_E, T_ID, T_E_LEAST, T_CL, I_E, T_ENG, A_ENG);

/// Whether there is a result, where a motor starts in one way or in none: of the others there is nothing.
#[must_use]
pub fn has(start: Option<&StartWay<f64>>, symbol: &Symbol) -> bool {
    let own = start.map(|start| match start {
        StartWay::SlipStart(_) => SLIPPED,
        StartWay::InverterStart(_) => RAMPED,
        StartWay::EngineStart(_) => ENGINED,
    });
    let of = |there: &[&Symbol]| there.contains(&symbol);
    own.is_some_and(of) || ![SLIPPED, RAMPED, ENGINED].into_iter().any(of)
}

/// A start in its way.
#[derive(Clone, Copy, Debug)]
pub enum Started<C> {
    Slipped(Slipped<C>),
    Ramped(Ramped<C>),
    Engined(Engined<C>),
}

impl<C: Calc> Started<C> {
    pub fn new(rated: &RatedPoint<C>, way: &StartWay<C>, run: &Starting<C>) -> Started<C> {
        match way {
            StartWay::SlipStart(start) => Started::Slipped(Slipped::new(rated, start, run)),
            StartWay::InverterStart(start) => Started::Ramped(Ramped::new(rated, start, run)),
            StartWay::EngineStart(start) => Started::Engined(Engined::new(rated, start, run)),
        }
    }

    pub fn slipped(&self) -> Option<&Slipped<C>> {
        match self {
            Started::Slipped(start) => Some(start),
            _ => None,
        }
    }

    pub fn ramped(&self) -> Option<&Ramped<C>> {
        match self {
            Started::Ramped(start) => Some(start),
            _ => None,
        }
    }

    pub fn engined(&self) -> Option<&Engined<C>> {
        match self {
            Started::Engined(start) => Some(start),
            _ => None,
        }
    }
}
