//! Forces of the frame, which carry what the pins, the balance and the drive leave.

use crate::balance::residual::Residual;
use crate::component::stages::{Found, results};
use crate::drive::line::Reaction;
use crate::kernel::calc::Calc;
use crate::luffing::double_link::held::Held;
use crate::luffing::double_link::parameters::{Driven, Lengths, Weights};
use crate::luffing::double_link::position::Position;
use crate::luffing::double_link::symbols as s;
use crate::luffing::led::pull::LedPull;
use crate::parts::plane::{self, Point};

/// Forces of the frame, in N.
#[derive(Clone, Copy, Debug)]
pub struct Feet<C> {
    /// On the boom.
    pub o1: Point<C>,
    /// On the rocker.
    pub o3: Point<C>,
    /// Axial force in the rocker at C, tension positive.
    pub n_3: C,
}
results! { Feet as f => {
    F_O1X: f.o1.x;
    F_O1Y: f.o1.y;
    F_O3X: f.o3.x;
    F_O3Y: f.o3.y;
    N_3: f.n_3;
} }

impl<C: Calc> Feet<C> {
    /// Equilibrium of boom and rocker under their weights, a led rope and the force of the drive, where that is no mere moment.
    ///
    /// # Errors
    /// Where no finite forces in the pins carry load and weights.
    pub fn new(
        p: &Position<C>,
        l: &Lengths<C>,
        weights: &Option<Weights<C>>,
        balance: Option<&Residual<C>>,
        held: &Held<C>,
        drive: Option<&Reaction<C>>,
        pulled: Option<&LedPull<C>>,
    ) -> Found<Feet<C>> {
        let pins = held.pins()?;
        let push = drive.and_then(|drive| drive.force);
        let held = |force: Point<C>, g: Option<C>| Point::new(force.x, g.map_or(force.y, |g| force.y + g));
        let by_balance = |force: Point<C>| balance.map_or(force, |balance| force - balance.action.on_boom);
        let by_drive = |force: Point<C>, driven| match push {
            Some(push) if p.driven == driven => force - push,
            _ => force,
        };
        let by_rope = |force: Point<C>, bar: usize| pulled.map_or(force, |pulled| force - pulled.on[bar].force);
        let (g_1, g_3) = (weights.map(|w| w.g_1), weights.map(|w| w.g_3));
        let o1 = || {
            plane::def(
                by_drive(by_balance(by_rope(held(pins.b, g_1), 0)), Driven::Boom),
                [&s::F_O1X, &s::F_O1Y],
            )
        };
        let o3 = || {
            plane::def(
                by_drive(by_rope(held(pins.c, g_3), 2), Driven::Rocker),
                [&s::F_O3X, &s::F_O3Y],
            )
        };
        // The driving link's foot first.
        let (o1, o3) = match p.driven {
            Driven::Boom => (o1(), o3()),
            Driven::Rocker => {
                let o3 = o3();
                (o1(), o3)
            }
        };
        let n_3 = (-(plane::dot(pins.c, p.x_3) / l.x_3)).def(&s::N_3);
        Ok(Feet { o1, o3, n_3 })
    }
}
