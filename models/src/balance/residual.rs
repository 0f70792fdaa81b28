//! What is left of the moment at one position.

use crate::balance::action::{Action, LeverTurn};
use crate::balance::boom::{Boom, Load};
use crate::balance::{Balance, symbols as s};
use crate::component::stages::{absent, results};
use crate::kernel::allowed::OutOfRange;
use crate::kernel::calc::Calc;

/// What is left at one boom angle.
#[derive(Clone, Copy, Debug)]
pub struct Residual<C> {
    /// Boom angle, in rad.
    pub phi: C,
    pub boom: Load<C>,
    pub action: Action<C>,
    /// About the boom foot, in N·m; positive raises the boom.
    pub dm: C,
    /// About the lever's pivot, in N·m; infinite where the lever stands still, none
    /// where there is no lever.
    pub dm_5: Option<C>,
}

results! { Residual as r => {
    M_0: r.boom.m_0;
    M_UR: r.action.m_b;
    DM: r.dm;
    DM_5: r.dm_5.ok_or_else(absent)?;
    PSI: r.action.lever.ok_or_else(absent)?.psi;
    I_5: r.action.lever.ok_or_else(absent)?.i_5;
    GAMMA: r.action.lever.ok_or_else(absent)?.gamma;
    N_1: r.action.n_1.ok_or_else(absent)?;
    C_5Y: r.action.y_5.ok_or_else(absent)?;
    F_KX: r.action.on_boom.x;
    F_KY: r.action.on_boom.y;
    F_MX: r.action.on_pivot.ok_or_else(absent)?.x;
    F_MY: r.action.on_pivot.ok_or_else(absent)?.y;
} }

impl<C: Calc> Residual<C> {
    /// At boom angle `phi` (rad). [Balance004, eq. 3]
    ///
    /// # Errors
    /// An angle at which boom or balance cannot be.
    pub fn new(boom: &dyn Boom<C>, balance: &Balance<C>, phi: C) -> Result<Residual<C>, OutOfRange> {
        let load = boom.at(phi)?;
        let action = balance.at(phi, &load)?;
        Ok(Residual::of(phi, load, action))
    }

    /// What boom and balance leave together.
    pub fn of(phi: C, boom: Load<C>, action: Action<C>) -> Residual<C> {
        let dm = (boom.m_0 + action.m_b).def(&s::DM);
        // At rest no moment about its pivot has the power of another one.
        let about_pivot = |turn: &LeverTurn<C>| match (turn.i_5.value(), dm.value()) {
            (0.0, 0.0) => dm,
            (0.0, left) => C::constant(f64::INFINITY.copysign(left)),
            _ => (dm / turn.i_5).def(&s::DM_5),
        };
        Residual {
            phi,
            boom,
            action,
            dm,
            dm_5: action.lever.as_ref().map(about_pivot),
        }
    }
}
