//! The balance of the boom system: what its weights ask for, what a
//! counterweight gives, and what is left. [Balance004; Ports001, 2.1-2.2, 4.1, 9]
//!
//! ```text
//!     C_5 ■                                       boom
//!          \  s_5          l_1             K  ___/
//!      chi_5 \  ___────────────────────── o──
//!             o  R_1                   r_1 /
//!           M  \       d_1                /  alpha_1 from the boom's axis
//!                \________________ O  o──/  phi ____ x
//! ```
//!
//! O is the foot of the boom, x towards the load, y up, angles counter-clockwise.
//! Moments about the boom foot are **positive where they raise the boom**, as in
//! Balance004: `M_0` is negative, `M_ur` positive, `dM = M_0 + M_ur`. (In
//! [`crate::luffing::double_link`], `M_G` has the other sign.) At a stable equilibrium `dM`
//! falls through zero. The residual about the lever's pivot, `dM_5 = dM / i_5`, has
//! the same power; [Ports001, table 5.2.1] prints its amount with the opposite sign.
//!
//! | id | function | source |
//! |---|---|---|
//! | `balance.boom.moment` | [`boom::Boom::at`] | Balance004, eq. 1, by virtual work |
//! | `balance.boom.moment_by_power` | [`boom::Boom::moment_by_power`] | Ports001, 9 |
//! | `balance.tail.moment` | [`tail::Tail::at`] | Ports001, 2.1.1 |
//! | `balance.parallelogram.moment` | [`parallelogram::Parallelogram::at`] | Ports001, 2.1.2 |
//! | `balance.lever.moment` | [`lever::Lever::at`] | Balance004, eq. 2; Ports001, 2.1.3, 4.1 |
//! | `balance.straight_rail.moment` | [`straight_rail::StraightRail::at`] | Ports001, 2.1.4 |
//! | `balance.curved_rail.moment` | [`curved_rail::CurvedRail::at`] | Ports001, 2.1.5 |
//! | `balance.residual` | [`residual::Residual::new`] | Balance004, eq. 3; Ports001, eq. 5.2.6 |
//! | `balance.drive` | [`crate::luffing::balancing::Balanced`] | equilibrium, with and without the balance |
//! | `balance.table_5_2_1` | [`published::table_5_2_1`] | Ports001, table 5.2.1 |
//! | `balance.range` | [`analysis::Analysis::new`] | Balance004, criteria F1-F3 |
//! | `balance.synthesis.three` | `lemnis_synthesis::three::lever` | Ports001, 2.2.1 |
//! | `balance.synthesis.four` | `lemnis_synthesis::four::Nodes` | Balance004, eq. 4 |
//! | `balance.synthesis.optimum` | `lemnis_synthesis::optimum::search` | Balance004, eq. 6-7, global |
//! | `balance.synthesis.tolerance` | `lemnis_synthesis::tolerance::Spread::new` | derived |

pub mod action;
pub mod analysis;
pub mod asked;
pub mod boom;
pub mod curved_rail;
mod grid;
pub mod kept;
pub mod lever;
pub mod parallelogram;
pub mod published;
pub mod residual;
pub mod scene;
pub mod straight_rail;
pub mod symbols;
pub mod tail;
pub mod task;

use crate::balance::action::{Action, RodLine};
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;
use crate::parts::plane::Point;

/// Any of the balances.
#[derive(Clone, Copy, Debug)]
pub enum Balance<C> {
    Tail(tail::Tail<C>),
    Parallelogram(parallelogram::Parallelogram<C>),
    Lever(lever::Lever<C>),
    StraightRail(straight_rail::StraightRail<C>),
    CurvedRail(curved_rail::CurvedRail<C>),
}

impl<C: Calc> Balance<C> {
    /// The same balance over another scalar.
    #[must_use]
    pub fn map<D: Calc>(&self, f: fn(C) -> D) -> Balance<D> {
        let of = &mut |_, value| f(value);
        match self {
            Balance::Tail(it) => Balance::Tail(it.map(of)),
            Balance::Parallelogram(it) => Balance::Parallelogram(it.map(of)),
            Balance::Lever(it) => Balance::Lever(it.map(f)),
            Balance::StraightRail(it) => Balance::StraightRail(it.map(of)),
            Balance::CurvedRail(it) => Balance::CurvedRail(it.map(f)),
        }
    }

    /// At boom angle `phi` (rad), with what the boom asks for there.
    ///
    /// # Errors
    /// An angle at which the balance cannot be assembled or has a dead point.
    pub fn at(&self, phi: C, boom: &boom::Load<C>) -> Result<Action<C>, OutOfRange> {
        match self {
            Balance::Tail(it) => Ok(it.at(phi)),
            Balance::Parallelogram(it) => it.at(phi),
            Balance::Lever(it) => it.at(phi),
            Balance::StraightRail(it) => it.at(phi),
            Balance::CurvedRail(it) => it.at(phi, boom),
        }
    }

    /// The counterweight at boom angle `phi` (rad), in m from the boom foot, or on a straight rail from a
    /// place that does not move; `u_0` is the boom's potential energy (J). `None` where the balance cannot be.
    pub fn place(&self, phi: C, u_0: impl FnOnce() -> C) -> Option<Point<C>> {
        match self {
            Balance::Tail(it) => Some(it.place(phi)),
            Balance::Parallelogram(it) => Some(it.place(phi)),
            Balance::Lever(it) => it.place(phi),
            Balance::StraightRail(it) => Some(it.place(phi)),
            Balance::CurvedRail(it) => it.rail(phi, u_0()).ok(),
        }
    }

    /// How it carries a force on its counterweight, which is at `place` (m) and moves by `travel` (m) for one radian of
    /// the boom, where the boom is at `phi` (rad); none where the counterweight is fixed to the boom.
    pub fn line(&self, phi: C, place: Point<C>, travel: Point<C>) -> Option<RodLine<C>> {
        match self {
            Balance::Tail(_) => None,
            Balance::Parallelogram(it) => Some(it.line(phi, place)),
            Balance::Lever(it) => it.line(phi, place),
            Balance::StraightRail(it) => Some(it.line(phi)),
            Balance::CurvedRail(it) => Some(it.line(phi, place, travel)),
        }
    }

    /// The counterweight's weight, in N; `None` where only its moment is known.
    pub fn weight(&self) -> Option<C> {
        match self {
            Balance::Tail(it) => Some(it.g_c),
            Balance::Parallelogram(it) => Some(it.g_c),
            Balance::Lever(it) => it.s_5.map(|s_5| it.dimensions.m_5 / s_5),
            Balance::StraightRail(it) => Some(it.g_c),
            Balance::CurvedRail(it) => Some(it.dimensions.g_c),
        }
    }
}
