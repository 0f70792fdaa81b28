//! Friction in the pins, and with it the sum of a case and the drive's force.

use crate::component::stages::results;
use crate::kernel::calc::Calc;
use crate::luffing::resistances::given::{CasePin, CasesChoice};
use crate::luffing::resistances::loads::Carrying;
use crate::luffing::resistances::moments::Resisted;
use crate::luffing::resistances::symbols as s;
use crate::parts::plane::{Point, squared};

/// Most pins of a mechanism with a balance.
pub const PINS: usize = 7;

/// The pins of a balance that has a rod, behind those of a mechanism: of the rod on the boom and on the lever, of the lever
/// on the frame.
pub const OF_BALANCE: [&str; 3] = ["K", "L", "M"];

/// What a pin carries (N), and how far its parts turn against each other for one radian of the luffing angle; of a guide, how
/// far they slide (m).
#[derive(Clone, Copy, Debug)]
pub enum Pin<C> {
    Turns { force: C, turn: C },
    Slides { force: C, way: C },
}

impl<C: Calc> Pin<C> {
    /// Under a force, its parts turning by so much each.
    pub fn new(force: Point<C>, [one, other]: [C; 2]) -> Pin<C> {
        Pin::Turns {
            force: amount(force),
            turn: one - other,
        }
    }

    pub fn force(&self) -> C {
        match self {
            Pin::Turns { force, .. } | Pin::Slides { force, .. } => *force,
        }
    }

    /// Way of its surface, in m, with a radius (m).
    pub fn way(&self, radius: C) -> C {
        match self {
            Pin::Turns { turn, .. } => turn.abs() * radius,
            Pin::Slides { way, .. } => way.abs(),
        }
    }
}

/// Those of a mechanism in its order, and behind them those of a balance that has a rod.
#[derive(Clone, Copy, Debug)]
pub struct Pins<C>([Pin<C>; PINS]);

impl<C: Calc> Pins<C> {
    /// Behind those of the mechanism, on a boom that turns by `boom` for one radian of the luffing angle.
    pub fn new<const N: usize>(own: [Pin<C>; N], balance: &Carrying<C>, boom: C) -> Pins<C> {
        let (zero, rod) = (C::constant(0.0), balance.turn);
        let at_rod = |other: C| Pin::Turns {
            force: balance.rod.abs(),
            turn: rod - other,
        };
        let lever = Pin::new(balance.on_pivot, [balance.lever, zero]);
        let of_balance = [at_rod(boom), at_rod(balance.lever), lever];
        Pins(std::array::from_fn(|i| {
            let behind = of_balance.get(i.wrapping_sub(N));
            own.get(i).or(behind).copied().unwrap_or(lever)
        }))
    }

    /// By its place.
    pub fn at(&self, pin: usize) -> &Pin<C> {
        &self.0[pin]
    }
}

/// A force by its amount, which at nothing has no direction.
fn amount<C: Calc>(force: Point<C>) -> C {
    let square = squared(force);
    if square.value() == 0.0 {
        return C::constant(0.0);
    }
    square.sqrt()
}

/// A case with its friction.
#[derive(Clone, Copy, Debug)]
pub struct Rubbed<C> {
    /// Moments in N·m, positive where they raise the boom.
    pub friction: C,
    pub sum: C,
}
results! { each Rubbed as r => {
    M_R_FRICTION: r.friction;
    M_R_SUM: r.sum;
} }

impl<C: Calc> Rubbed<C> {
    /// M_μ = Σ μ F l for one radian, against the motion. [virtual work]
    pub fn new(resisted: &Resisted<C>, pins: &Pins<C>, given: &[CasePin<C>], choice: &CasesChoice) -> Rubbed<C> {
        let of = |sum: C, (pin, at): (&CasePin<C>, &usize)| {
            let on = pins.at(*at);
            sum + pin.mu * on.force() * on.way(pin.r)
        };
        let rubs = given
            .iter()
            .zip(&choice.pins)
            .fold(C::constant(0.0), of)
            .tabled(&s::M_MU);
        let friction = match resisted.rate.value() {
            0.0 => C::constant(0.0).over(rubs),
            forward if forward > 0.0 => (-rubs).def(&s::M_R_FRICTION),
            _ => rubs.def(&s::M_R_FRICTION),
        };
        let sum = (resisted.sum + friction).def(&s::M_R_SUM);
        Rubbed { friction, sum }
    }
}
